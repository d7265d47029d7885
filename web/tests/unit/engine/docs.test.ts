import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { fileURLToPath, pathToFileURL } from "node:url";
import { expect, test, vi } from "vitest";
import { read } from "./files.ts";

const ENGINE = fileURLToPath(new URL("../../../src/engine/index.ts", import.meta.url));

// The snippets of a page build on each other, so they run as one program.
test.each(["docs/javascript.md", "docs/lockstep.md", "web/src/engine/README.md"])(
  "the snippets of %s run one after the other",
  async (page) => {
    const snippets = [...read(page).matchAll(/^```js\n(.*?)^```/gms)].map((match) => match[1]!);
    expect(snippets).not.toHaveLength(0);
    const folder = mkdtempSync(`${tmpdir()}/carom-docs-`);
    const program = `${folder}/page.mjs`;
    writeFileSync(program, snippets.join("\n").replaceAll('"carom-engine"', `"${ENGINE}"`));
    const said = vi.spyOn(console, "log").mockImplementation(() => undefined);
    try {
      await import(/* @vite-ignore */ pathToFileURL(program).href);
      expect(said).toHaveBeenCalled();
      for (const values of said.mock.calls) expect(values).not.toContain(undefined);
      if (page === "docs/lockstep.md") expect(said).toHaveBeenCalledWith(true, true, true);
    } finally {
      said.mockRestore();
      rmSync(folder, { recursive: true });
    }
  },
);
