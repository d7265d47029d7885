/**
 * Keeps the page for use without a network. With a network the newest page is shown; without one, the last
 * page that was.
 */

const CACHE = "carom-page-1";
const FILES = ["./", "manifest.webmanifest", "icon-192.png", "icon-512.png"];

self.addEventListener("install", (event) => {
  event.waitUntil(
    caches
      .open(CACHE)
      .then((cache) => cache.addAll(FILES))
      .then(() => self.skipWaiting()),
  );
});

self.addEventListener("activate", (event) => {
  const old = (name) => name.startsWith("carom-page-") && name !== CACHE;
  event.waitUntil(
    caches
      .keys()
      .then((names) => Promise.all(names.filter(old).map((name) => caches.delete(name))))
      .then(() => self.clients.claim()),
  );
});

self.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method !== "GET" || !isOurs(new URL(request.url))) return;
  event.respondWith(fromNetwork(request));
});

/** Whether this is one of the files that are kept; other pages of the same host are not. */
function isOurs(url) {
  const scope = new URL(self.registration.scope);
  if (url.origin !== scope.origin) return false;
  return FILES.some((file) => new URL(file, scope).pathname === url.pathname);
}

async function fromNetwork(request) {
  const cache = await caches.open(CACHE);
  try {
    const response = await fetch(request);
    // `carom play SHOT` serves a page with a shot at the same address.
    const isKept = !/no-store/.test(response.headers.get("cache-control") ?? "");
    if (response.ok && isKept) await cache.put(request, response.clone());
    return response;
  } catch (error) {
    // The address of the page may have a query.
    const kept = await cache.match(request, { ignoreSearch: true, ignoreVary: true });
    if (kept) return kept;
    throw error;
  }
}
