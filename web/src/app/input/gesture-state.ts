/** What a gesture on the table has seen and done so far. */

import type { Point } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import type { Store } from "../document/store.ts";
import type { DrawDrag } from "../draw/draw-gesture.ts";
import type { Target } from "../document/target.ts";
import type { AimCloseUp } from "./aim-close-up.ts";
import { Loupe } from "./finger-loupe.ts";
import type { FingerPace } from "./finger-pace.ts";
import { Stroke } from "./stroke.ts";

/** What is read of an event. */
export type Pointer = Pick<
  PointerEvent,
  "pointerId" | "pointerType" | "button" | "clientX" | "clientY" | "shiftKey" | "timeStamp"
>;

interface Press {
  readonly pointer: number;
  readonly type: string;
  /** Its changes are one step of the history. */
  readonly group: string;
  readonly start: { readonly x: number; readonly y: number };
  /** Index of the ball at the pointer, or near a finger, when the gesture began: a tap means it. */
  readonly ball: number | null;
  /** Movement below which the gesture is a tap, CSS pixels. */
  readonly reach: number;
  moved: boolean;
}

/** The pointer was on a ball, and not only near it. */
export interface BallDrag extends Press {
  readonly kind: "ball";
  /** Index of the ball that moves. */
  readonly held: number;
  /** At what the ball was aimed, if it is the struck one. */
  readonly target: Target | null;
  /** From the pointer to the ball's centre, m. */
  readonly grip: Point;
}

export interface CueDrag extends Press {
  readonly kind: "cue";
  /** Where the cue would point without snapping, degrees; null before it turns. */
  azimuth: number | null;
  /** Position of the pointer when it last turned the cue. */
  last: { readonly x: number; readonly y: number; readonly point: Point | null };
  /** How fast the finger moves; null for a mouse, which is exact. */
  readonly pace: FingerPace | null;
}

/** A pull of the cue, a drag of the place where the cue ball stops, or of the camera, which the viewer turns. */
interface OtherDrag extends Press {
  readonly kind: "stroke" | "stop" | "camera";
}

/** A drag that draws on the table. */
interface MarkDrag extends Press, DrawDrag {
  readonly kind: "draw";
}

export type Gesture = BallDrag | CueDrag | MarkDrag | OtherDrag;

/** The picture of the table, on which gestures are made. */
export interface Surface {
  readonly dataset: DOMStringMap;
  setPointerCapture(pointer: number): void;
  /** Whether nothing of the page covers a point of the window. */
  isOpen(x: number, y: number): boolean;
}

export class GestureState {
  readonly store: Store;
  readonly context: Context;
  readonly surface: Surface;
  readonly stroke: Stroke;
  readonly loupe: Loupe;
  readonly closeUp: AimCloseUp;
  /** The pointers that are down. */
  readonly down = new Set<number>();
  /** How many gestures have begun. */
  count = 0;
  present: Gesture | null = null;

  constructor(store: Store, context: Context, surface: Surface, closeUp: AimCloseUp) {
    this.store = store;
    this.context = context;
    this.surface = surface;
    this.stroke = new Stroke(store, context);
    this.loupe = new Loupe(context.viewer);
    this.closeUp = closeUp;
  }

  /** What is at a pointer; near it, too, if it is a finger. */
  pick({ clientX, clientY, pointerType }: Pointer): { ball: number | null; point: Point | null } {
    return this.context.viewer.pick(clientX, clientY, pointerType);
  }
}
