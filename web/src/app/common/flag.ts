/** Flags in the browser's storage: names that are there or not. */

/** That of the browser, which later visits find, and that of the tab. */
export type FlagStorage = "localStorage" | "sessionStorage";

/** Whether a flag is set; `otherwise` without storage, which some frames and browsers do not have. */
export function hasFlag(storage: FlagStorage, name: string, otherwise: boolean): boolean {
  try {
    return window[storage].getItem(name) !== null;
  } catch {
    return otherwise;
  }
}

/** Sets or removes a flag. Without storage it ends with the page. */
export function setFlag(storage: FlagStorage, name: string, isSet: boolean): void {
  try {
    if (isSet) window[storage].setItem(name, "1");
    else window[storage].removeItem(name);
  } catch {
    // There is nothing to remove either.
  }
}
