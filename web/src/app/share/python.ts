// A shot as a Python program.

import type { ShotFile } from "../../engine/index.ts";
import { toPython } from "./literal.ts";

/** A program that runs as it stands, prints the events of the shot, and has the page's hash. */
export function pythonProgram(shot: ShotFile): string {
  return `import carom

shot = carom.Shot.from_dict(${toPython(shot)})
trace = shot.simulate()
print(trace)
`;
}
