/** How to get the browser, as the end of a sentence. */
export const REMEDY: string;
/** The path of the browser; null if none is found. */
export function findChromium(): Promise<string | null>;
/** @throws Error if no browser is found, with the remedies. */
export function requireChromium(): Promise<string>;
