/** Downloads made in the browser, without a server. */

/** Time (ms) that a download has to begin; afterwards its URL is revoked. */
const BEGINS_WITHIN = 60_000;

/** Offers `content` for download as a file called `name`. */
export function download(content: Blob | string, name: string): void {
  const blob = typeof content === "string" ? new Blob([content], { type: "text/plain" }) : content;
  const url = URL.createObjectURL(blob);
  const anchor = document.createElement("a");
  anchor.href = url;
  anchor.download = name;
  document.body.append(anchor);
  anchor.click();
  anchor.remove();
  setTimeout(() => URL.revokeObjectURL(url), BEGINS_WITHIN);
}
