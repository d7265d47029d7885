import type { Engine } from "./types.js";

export * from "./error.js";
export * from "./types.js";

/**
 * The engine, ready to use: from bytes or a compiled module (`Engine.module` of another thread), or
 * without an argument from the WebAssembly that this package carries.
 */
export declare function load(source?: BufferSource | WebAssembly.Module): Promise<Engine>;
