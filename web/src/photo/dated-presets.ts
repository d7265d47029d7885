/** Names of presets of tables and of physics. */

/** The year and month at the end of the name of an older edition. */
const DATE = /-\d{4}-\d{2}$/;

/** Whether a name is that of an older edition. */
export function isDated(name: string): boolean {
  return DATE.test(name);
}

/** A name without its date. */
export function undated(name: string): string {
  return name.replace(DATE, "");
}
