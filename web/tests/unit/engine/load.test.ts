import { readFileSync } from "node:fs";
import { expect, test, vi } from "vitest";
import type * as Core from "../../../src/engine/core.ts";
import { shotFile } from "./files.ts";

const wasm = readFileSync(new URL("../../../src/engine/pkg/carom_wasm_bg.wasm", import.meta.url));

/** New instances of the engine's modules, as in another thread. */
async function fresh(): Promise<typeof Core> {
  vi.resetModules();
  return import("../../../src/engine/core.ts");
}

test("the engine loads from bytes and from another thread's module", async () => {
  const first = await (await fresh()).load(wasm);
  const second = await (await fresh()).load(first.module);
  expect(second).not.toBe(first);
  const hashes = [first, second].map((e) => e.shot(shotFile("masse")).simulate().hash);
  expect(hashes[0]).toBe(hashes[1]);
});

test("a thread has one engine", async () => {
  const { load } = await fresh();
  expect(await load(wasm)).toBe(await load(wasm));
});

test("a source that is not WebAssembly is refused, and a later load succeeds", async () => {
  const { load } = await fresh();
  await expect(load(new Uint8Array([1, 2, 3]))).rejects.toThrow(WebAssembly.CompileError);
  expect((await load(wasm)).version).toMatch(/^carom/);
});
