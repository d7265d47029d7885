/** A shot as a Python program. */

import type { FrameRecord, ShotFile } from "../../engine/index.ts";
import { toPython } from "./literal.ts";

/** A complete program that simulates the shot and prints it; its hash equals the page's. */
export function pythonProgram(shot: ShotFile): string {
  return `import carom

shot = carom.Shot.from_dict(${toPython(shot)})
trace = shot.simulate()
print(trace)
`;
}

/** A complete program that plays the game again and prints its state. */
export function gameProgram(record: FrameRecord): string {
  return `import carom

frame = carom.Frame.replay(${toPython(record)})
print(frame)
`;
}
