import { load as loadFrom } from "./core.ts";
import embedded from "./pkg/embedded.js";
import type { Engine } from "./engine.ts";

export * from "./carom-route.ts";
export type * from "./drawn-tables.ts";
export type * from "./drill-goals.ts";
export * from "./engine.ts";
export * from "./error.ts";
export type * from "./evaluation.ts";
export * from "./match.ts";
export * from "./player.ts";
export * from "./rules.ts";
export * from "./study.ts";
export * from "./types.ts";

/**
 * Loads the engine from bytes, from a compiled module (`Engine.module` of another thread), or without an
 * argument from the WebAssembly embedded in this module. A thread has one engine: later calls return the
 * same one.
 * @throws WebAssembly.CompileError if the source is not WebAssembly.
 */
export async function load(source?: BufferSource | WebAssembly.Module): Promise<Engine> {
  return loadFrom(source ?? (await embeddedBytes()));
}

function embeddedBytes(): Promise<ArrayBuffer> {
  const text = atob(embedded);
  const packed = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) packed[i] = text.charCodeAt(i);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}
