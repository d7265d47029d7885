import { load as loadFrom } from "./core.js";
import embedded from "./pkg/embedded.js";
import type { Engine } from "./engine.js";

export * from "./engine.js";
export * from "./error.js";
export * from "./player.js";
export * from "./rules.js";
export * from "./types.js";

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
