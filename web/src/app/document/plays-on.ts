import type { Session } from "./document.ts";

/** Whether the replay runs and only its time has changed. */
export function playsOn(now: Session, before: Session): boolean {
  return (
    now.replay.playing &&
    before.replay.playing &&
    now.replay.trace === before.replay.trace &&
    now.selected === before.selected
  );
}
