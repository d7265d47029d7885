/** All drills, in the order in which the page shows them. */

import { CAROM_DRILLS } from "./carom.ts";
import type { Drill } from "./drill.ts";
import { POOL_DRILLS } from "./pool.ts";
import { SNOOKER_DRILLS } from "./snooker.ts";

export type * from "./drill.ts";

export const DRILLS: readonly Drill[] = [...POOL_DRILLS, ...SNOOKER_DRILLS, ...CAROM_DRILLS];

/** The drill with an id; undefined for one of another version of the page. */
export function drillOf(id: string): Drill | undefined {
  return DRILLS.find((drill) => drill.id === id);
}
