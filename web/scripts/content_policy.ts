/** The page's content security policy: the build writes it into the page after its character set. */

import { createHash } from "node:crypto";
import type { Plugin } from "vite";

const SCRIPT = /<script(?![^>]*application\/json)[^>]*>([^]*?)<\/script>/gu;
const CHARSET = '<meta charset="utf-8" />';

/**
 * The policy of a page: only its own scripts run, by their hashes, and nothing is loaded from or sent to another
 * host, so that a shot file of a stranger can neither run a script nor send anything.
 */
export function contentPolicy(page: string): string {
  const hashes = [...page.matchAll(SCRIPT)].map(([, script = ""]) => {
    return `'sha256-${createHash("sha256").update(script).digest("base64")}'`;
  });
  return [
    "default-src 'none'",
    // WebAssembly is compiled from the script; it needs a permission of its own.
    `script-src ${hashes.join(" ")} 'wasm-unsafe-eval'`,
    // The thinking worker is a blob; the worker that keeps the page for use offline is a file beside it.
    "worker-src blob: 'self'",
    "manifest-src 'self'",
    "style-src 'unsafe-inline'",
    // Pictures and films are read from and written to memory.
    "img-src 'self' data: blob:",
    "media-src blob:",
    "base-uri 'none'",
    "form-action 'none'",
  ].join("; ");
}

/** Writes the policy into the built page, after the scripts were put into it. */
export function withContentPolicy(): Plugin {
  return {
    name: "content-policy",
    apply: "build",
    enforce: "post",
    generateBundle: {
      order: "post",
      handler(_options, bundle) {
        for (const file of Object.values(bundle)) {
          if (file.type !== "asset" || !file.fileName.endsWith(".html")) continue;
          const page = String(file.source);
          const meta = `<meta http-equiv="Content-Security-Policy" content="${contentPolicy(page)}" />`;
          if (!page.includes(CHARSET)) this.error(`${file.fileName} has no ${CHARSET}`);
          file.source = page.replace(CHARSET, () => `${CHARSET}\n    ${meta}`);
        }
      },
    },
  };
}
