// Files to the user's disk, without a server.

/** How long (ms) a download may take to begin: its address is given back after that. */
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
