/** Records of frames, `carom-frame/1`: the start of a frame and all its moves. Python's `Frame.record` is the same. */

import { object } from "./arguments.ts";
import type { Engine } from "./engine.ts";
import { CaromError, moved, refuse } from "./error.ts";
import type { Call, Choice, Frame, FrameRecord, FrameSetup, Play } from "./rules.ts";

export const FRAME_FORMAT = "carom-frame/1";

/** What to do with a record that cannot be read. */
const REMEDY = "give the value of Frame.record";

/** What a record is replayed with. */
type Replayer = Pick<Engine, "frame" | "frameOf" | "shot" | "version" | "checkRecord">;

/**
 * The frame of a record, with every move repeated.
 *
 * @throws CaromError if this is not a record of a frame, or a move is not allowed; the message has the move's index.
 */
export function replay(engine: Replayer, record: unknown): Frame {
  const steps = replaySteps(engine, record);
  let step = steps.next();
  while (!step.done) step = steps.next();
  return step.value;
}

/** As `replay`, but yields before every move, so that a long frame can be replayed in parts. */
export function* replaySteps(
  engine: Replayer,
  record: unknown,
): Generator<undefined, Frame, undefined> {
  const { engine: made, setup, moves } = object("record", record) as FrameRecord;
  engine.checkRecord(record as FrameRecord);
  const frame = start(engine, setup);
  for (const [index, move] of (moves as readonly unknown[]).entries()) {
    yield;
    if (isApplied(frame, move, moves[index - 1])) continue;
    try {
      make(frame, move);
    } catch (error) {
      frame.free();
      if (!(error instanceof CaromError)) throw error;
      const place = `moves[${index}]${error.place === "" ? "" : `.${error.place}`}`;
      throw moved(error, place, error.remedy + otherEngine(made, engine.version));
    }
  }
  return frame;
}

/** The end of an error's sentence: the engine that made a record, if it is another one. */
function otherEngine(made: unknown, version: string): string {
  if (typeof made !== "string" || made === version) return "";
  return ` (the record was made by ${made}, and this is ${version})`;
}

function start(engine: Pick<Engine, "frame" | "frameOf" | "shot">, setup: FrameSetup): Frame {
  // `target` is the key of records before the rename; a record is a file, so it is read silently.
  // eslint-disable-next-line @typescript-eslint/no-deprecated -- see above
  const { game, target, ...rest } = setup;
  const options = target === undefined ? rest : { points: target, ...rest };
  if (!("shot" in options)) return engine.frame(game, options);
  const { shot: file, ...terms } = options;
  const shot = engine.shot(file);
  try {
    return engine.frameOf(game, shot, { player: 0, ...terms });
  } finally {
    shot.free();
  }
}

/**
 * Whether the frame has already applied this choice of an old record. After a scratch on the break of
 * eight-ball, frames used to ask for a choice with this one option. Now they apply it.
 */
function isApplied(frame: Frame, move: unknown, previous: unknown): boolean {
  if (!isMove(move, "choice") || move.choice !== "play-from-hand" || !isMove(previous, "play")) {
    return false;
  }
  const { game, request } = frame.state;
  return (
    game === "eight-ball" && request.kind === "shot" && request.in_hand === "behind-head-string"
  );
}

function isMove<K extends string>(move: unknown, key: K): move is Readonly<Record<K, unknown>> {
  return typeof move === "object" && move !== null && key in move;
}

function make(frame: Frame, move: unknown): void {
  if (isMove(move, "play")) frame.play(withoutNulls(move.play)).trace.free();
  else if (isMove(move, "choice")) frame.choose(move.choice as Choice);
  else if (isMove(move, "concede") && move.concede === true) frame.concede();
  else refuse("not-a-move", "", "not a play, a choice or a concession", REMEDY);
}

/** A recorded play. Python writes `null` for the parts of a call that it does not have. */
function withoutNulls(play: unknown): Play {
  const { call, ...rest } = object("play", play) as Play;
  if (call === undefined) return rest;
  const parts = Object.entries(object("call", call)).filter(([, value]) => value !== null);
  return { ...rest, call: Object.fromEntries(parts) as unknown as Call };
}
