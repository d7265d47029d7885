/**
 * Which works are open in which tab. A tab holds a lock of the browser for each work that it writes, so that
 * no two tabs write to the same one: not when a tab is duplicated, nor when the same work is continued twice.
 * The browser releases the locks when a tab is closed. Where it has no locks, a tab never takes over a work
 * and writes to copies of its own.
 */

const PREFIX = "carom-work-";

/** Time (ms) that a tab waits for a lock: that of the page before a reload is released in this time. */
const PATIENCE = 1500;

/** The locks of the browser; null where it has none, such as at an insecure address. */
function locks(): LockManager | null {
  return (navigator as { readonly locks?: LockManager }).locks ?? null;
}

/**
 * Takes a work until the tab is closed.
 *
 * @param waits Whether to wait a moment for a tab that is being closed.
 * @returns Gives it back; null if another tab has it.
 */
export async function claim(id: string, waits = false): Promise<(() => void) | null> {
  const own = locks();
  if (!own) return null;
  return new Promise((resolve) => {
    const options = waits ? { signal: AbortSignal.timeout(PATIENCE) } : { ifAvailable: true };
    own
      .request(PREFIX + id, options, (lock) => {
        if (lock === null) {
          resolve(null);
          return undefined;
        }
        return new Promise<void>((release) => resolve(release));
      })
      .catch(() => resolve(null));
  });
}

/** The ids of the works that a tab holds, this one included. */
export async function heldWorks(): Promise<ReadonlySet<string>> {
  const { held = [] } = (await locks()?.query()) ?? {};
  const names = held.flatMap(({ name }) => name ?? []);
  return new Set(
    names.filter((name) => name.startsWith(PREFIX)).map((name) => name.slice(PREFIX.length)),
  );
}
