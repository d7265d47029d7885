import { readdirSync } from "node:fs";
import { basename } from "node:path";
import { fileURLToPath } from "node:url";
import { expect, test } from "vitest";

const SOURCES = fileURLToPath(new URL("../../../src/", import.meta.url));

/** Built files, the texts of a language, and the lists of what a folder offers. */
const EXCEPTED = /^engine\/(pkg|dist)\/|^app\/words\/[^/]+\/|(^|\/)index\.ts$/;

test("a file's name says what it is without its folder: no two files have the same", () => {
  const files = readdirSync(SOURCES, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => `${entry.parentPath}/${entry.name}`.slice(SOURCES.length).replace(/^\//, ""))
    .filter((file) => !EXCEPTED.test(file));
  expect(files.length).toBeGreaterThan(200);
  const twice = files.filter((file, i) =>
    files.some((f, j) => i !== j && basename(f) === basename(file)),
  );
  expect(twice).toEqual([]);
});
