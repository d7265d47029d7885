/** Magnetic aiming: a cue that turns past a pot clicks into its middle. */

import {
  CaromError,
  type PocketName,
  type PotAim,
  type Shot,
  type Trace,
} from "../../engine/index.ts";
import type { AimedShot } from "../document/document.ts";
import { azimuthOfAim, turnedTo } from "../document/pot-lock.ts";
import { firstContactEvent } from "./first-contact.ts";

/** Degrees by which the first ball's path may pass a pocket to be drawn to it. */
const CAPTURE = 30;

export interface Snap {
  readonly azimuth: number;
  readonly ball: string;
  readonly pocket: PocketName;
  readonly aim: PotAim;
}

/**
 * The pot within `zone` degrees of the azimuth; null if there is none.
 *
 * @param azimuth Where the cue would point without snapping, degrees.
 */
export function magnet(shot: Shot, file: AimedShot, azimuth: number, zone: number): Snap | null {
  try {
    const turned = turnedTo(shot, file, azimuth);
    const trace = turned.simulate();
    const target = drawn(trace);
    const aim = target && turned.potAim(target.ball, target.pocket, { near: true });
    trace.free();
    turned.free();
    if (!target || aim?.kind !== "direct") return null;
    const snapped = azimuthOfAim(aim);
    const away = Math.abs(((snapped - azimuth + 540) % 360) - 180);
    return away <= zone ? { azimuth: snapped, ...target, aim } : null;
  } catch (error) {
    if (error instanceof CaromError) return null;
    throw error;
  }
}

/** The first ball that the cue ball meets, and the pocket nearest to its path. */
export function drawn(trace: Trace): { readonly ball: string; readonly pocket: PocketName } | null {
  const found = firstContactEvent(trace);
  if (!found) return null;
  const { event, other } = found;
  const { position, velocity } = event.after[other]!;
  const way = Math.atan2(velocity[1], velocity[0]);
  const passes = trace.shot.geometry.pockets.map(({ name, center: [x, y] }) => {
    const to = Math.atan2(y - position[1], x - position[0]);
    const off = Math.abs(Math.atan2(Math.sin(to - way), Math.cos(to - way))) * (180 / Math.PI);
    return { pocket: name, off };
  });
  const [nearest] = passes.sort((a, b) => a.off - b.off);
  return nearest && nearest.off < CAPTURE
    ? { ball: event.balls[other]!, pocket: nearest.pocket }
    : null;
}
