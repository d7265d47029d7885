/** Imports point one way: engine ← viewer ← app, the rooms of the app in order, and no circles. */

import { readdirSync, readFileSync } from "node:fs";
import { dirname, join, relative } from "node:path";
import { fileURLToPath } from "node:url";
import { describe, expect, test } from "vitest";

const SRC = fileURLToPath(new URL("../../src", import.meta.url));

const LAYERS = ["engine", "viewer", "app"];

/** Rooms of src/app. A file imports only from its own room and from earlier ones. */
const ROOMS = [
  "common",
  "document",
  "form",
  "replay",
  "game",
  "aim",
  "layout",
  "physics",
  "whatif",
  "share",
  "shell",
  "input",
  "help",
  // Files outside rooms assemble the page.
  "",
];

const FILES = readdirSync(SRC, { recursive: true, encoding: "utf8" }).filter(
  (file) => file.endsWith(".ts") && !/(^|\/)(pkg|dist)\//.test(file) && !file.endsWith(".d.ts"),
);

/** The files that a file imports, types included, relative to `SRC`. */
function importsOf(file: string): string[] {
  const text = readFileSync(join(SRC, file), "utf8");
  return [...text.matchAll(/(?:from|import) "(\.[^"?]+)/g)].flatMap((match) => {
    const target = relative(SRC, join(SRC, dirname(file), match[1]!));
    const names = [target, target.replace(/\.js$/, ".ts"), `${target}.ts`, `${target}/index.ts`];
    return names.filter((name) => FILES.includes(name)).slice(0, 1);
  });
}

const IMPORTS = new Map(FILES.map((file) => [file, importsOf(file)]));

/** The imports of all files for which `isAllowed` is false, as "a → b". */
function violations(isAllowed: (from: string, to: string) => boolean): string[] {
  return [...IMPORTS].flatMap(([from, all]) =>
    all.filter((to) => !isAllowed(from, to)).map((to) => `${from} → ${to}`),
  );
}

/** Groups of files that import each other; an index.ts, which re-exports its children, is exempt. */
function circles(): string[][] {
  const found: string[][] = [];
  const done = new Set<string>();
  const visit = (file: string, path: readonly string[]): void => {
    const at = path.indexOf(file);
    if (at >= 0) found.push([...path.slice(at), file]);
    if (at >= 0 || done.has(file)) return;
    for (const next of IMPORTS.get(file) ?? []) visit(next, [...path, file]);
    done.add(file);
  };
  for (const file of FILES) if (!file.endsWith("index.ts")) visit(file, []);
  return found.filter((circle) => !circle.some((file) => file.endsWith("index.ts")));
}

const roomOf = (file: string) => /^app\/([^/]+)\//.exec(file)?.[1] ?? "";

describe("imports in web/src", () => {
  test("are found", () => {
    expect(FILES.length).toBeGreaterThan(80);
    expect(IMPORTS.get("app/page.ts")).toContain("app/document/store.ts");
    expect(IMPORTS.get("viewer/viewer.ts")).toContain("viewer/balls/index.ts");
  });

  test("point from app to viewer to engine", () => {
    const layer = (file: string) => LAYERS.indexOf(file.split("/")[0]!);
    expect(violations((from, to) => layer(to) <= layer(from))).toEqual([]);
  });

  test("point from each room of the app to earlier rooms", () => {
    const isInApp = (file: string) => file.startsWith("app/");
    const rooms = new Set(FILES.filter(isInApp).map(roomOf));
    expect([...rooms].sort()).toEqual([...ROOMS].sort());
    expect(
      violations(
        (from, to) => !isInApp(to) || ROOMS.indexOf(roomOf(to)) <= ROOMS.indexOf(roomOf(from)),
      ),
    ).toEqual([]);
  });

  test("have no circles", () => {
    expect(circles()).toEqual([]);
  });
});
