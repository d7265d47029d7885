/** Warnings about old spellings. */

const given = new Set<string>();

/** Warns on the console, once per message and thread. */
export function warnOnce(message: string): void {
  if (given.has(message)) return;
  given.add(message);
  console.warn(`carom: ${message}`);
}
