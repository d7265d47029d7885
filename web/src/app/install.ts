/**
 * Makes the page installable, and usable without a network, when a host serves it with the files beside it.
 * A page from disk needs neither, and a page with a document in it is another page for each document.
 */

/** Files of web/public, which the build copies beside the page. */
const MANIFEST = "manifest.webmanifest";
const WORKER = "service-worker.js";

export function makeInstallable(): void {
  const embedded = document.getElementById("carom-document")?.textContent.trim();
  const isServed = /^https?:$/.test(location.protocol);
  if (!isServed || window !== window.top || embedded) return;
  const link = document.createElement("link");
  link.rel = "manifest";
  link.href = MANIFEST;
  document.head.append(link);
  // Browsers have service workers at secure addresses only.
  if (!("serviceWorker" in navigator)) return;
  navigator.serviceWorker.register(WORKER).catch((error: unknown) => {
    console.info(error);
  });
}
