import { load as loadFrom } from "./core.js";
import embedded from "./pkg/embedded.js";
import type { Engine } from "./engine.js";

export * from "./engine.js";
export * from "./error.js";
export * from "./rules.js";
export * from "./types.js";

/**
 * The engine, ready to use: from bytes or a compiled module (`Engine.module` of another thread), or
 * without an argument from the WebAssembly that this module carries. There is one in a thread: every
 * call gives the same.
 * @throws WebAssembly.CompileError if the source is no WebAssembly.
 */
export async function load(source?: BufferSource | WebAssembly.Module): Promise<Engine> {
  return loadFrom(source ?? (await carried()));
}

function carried(): Promise<ArrayBuffer> {
  const text = atob(embedded);
  const packed = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) packed[i] = text.charCodeAt(i);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}
