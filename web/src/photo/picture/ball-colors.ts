/**
 * Which ball of a set is which, by colour. The colour and the strength of the light are not known: those are
 * taken at which the colours of all balls fit the set best. Stripes differ from solids in the share of white.
 */

import { look } from "../../viewer/index.ts";
import type { Point } from "../../engine/index.ts";
import type { Camera } from "../geometry/camera.ts";
import { assign, total } from "./assign.ts";
import { covered, samples, type SeenBall } from "./ball-places.ts";
import type { Cloth, Color } from "./cloth.ts";
import { sample, type Pixels } from "./pixels.ts";

/** Rings of the samples of colours, as shares of the radius: not the edge, which mixes with the cloth. */
const RINGS = [0.15, 0.35, 0.52, 0.66, 0.78];
/** Darkest shade and strongest light on a ball, as a share of its colour. */
const SHADE = 0.3;
const LIGHT = 1.15;
/** A pixel this bright in every channel shows a lamp, not the ball, of 255. */
const GLARE = 250;
/** Standard deviation of a pixel from its ball's colour, of 255, and the distance beyond which all are alike. */
const SPREAD = 16;
const FARTHEST = 4;
/** Weight of the mean distance of the pixels against the other evidence: they are not independent. */
const PIXELS = 6;

/**
 * Share of a ball's samples that are white, everywhere and towards its edge, which the circle of a number seldom
 * reaches, and their standard deviation.
 */
const PLAIN = { white: 0.03, edge: 0.03, spread: 0.1 };
const NUMBERED = { white: 0.14, edge: 0.08, spread: 0.12 };
const STRIPED = { white: 0.55, edge: 0.45, spread: 0.22 };
/** Samples from this ring on are the edge, as a share of the radius. */
const EDGE = 0.6;
/** Share of the samples of a ball that are less bright than its usual light, and the standard deviation of ln. */
const LIT = 0.75;
const LIT_SPREAD = 0.2;

/**
 * Logarithms of the light's strength, and of its red and blue against its green, that are tried first, and the
 * step of those tried around the best.
 */
const STRENGTHS = [-0.6, -0.25, 0.1, 0.4];
const TINTS = [-0.27, 0, 0.27];
const STEP = 0.12;
/** Standard deviations of their logarithms. */
const STRENGTH_SPREAD = 0.35;
const TINT_SPREAD = 0.25;

/** A ball of the set, and how it looks. */
interface Kind {
  readonly body: Color;
  readonly isWhite: boolean;
  readonly whiteness: Readonly<Record<"white" | "edge" | "spread", number>>;
}

/** What is seen at a sample of a ball. */
interface Sampled {
  readonly color: Color;
  readonly isEdge: boolean;
}

const WHITE: Color = [244, 238, 221];

/** The id of each ball; the set must have as many ids. */
export function ballColors(
  pixels: Pixels,
  camera: Camera,
  cloth: Cloth,
  radius: number,
  balls: readonly SeenBall[],
  ids: readonly string[],
): string[] {
  if (balls.length === 0) return [];
  const seen = balls.map((ball) => {
    const samples = colorsOf(pixels, camera, cloth, radius, balls, ball);
    return { samples, weight: ball.score };
  });
  const kinds = ids.map(kindOf);
  const first = best(
    STRENGTHS.flatMap((x) => TINTS.flatMap((y) => TINTS.map((z): Color => [x, y, z]))),
    seen,
    kinds,
  );
  const steps = [-STEP, 0, STEP];
  const [x, y, z] = first.light;
  const near = steps.flatMap((a) =>
    steps.flatMap((b) => steps.map((c): Color => [x + a, y + b, z + c])),
  );
  return best(near, seen, kinds).chosen.map((column) => ids[column]!);
}

/** The samples of a ball, and how much they count: a ball that is not clear may be none, and then yields. */
interface SeenColors {
  readonly samples: readonly Sampled[];
  readonly weight: number;
}

/** An assignment of balls in a light: the logarithms of its strength, red and blue. */
interface Assigned {
  readonly light: Color;
  readonly chosen: readonly number[];
  readonly cost: number;
}

/** The light in which the balls fit the set best. */
function best(
  lights: readonly Color[],
  seen: readonly SeenColors[],
  kinds: readonly Kind[],
): Assigned {
  const tried = lights.map((light): Assigned => {
    const [strength, red, blue] = light;
    const prior =
      (strength / STRENGTH_SPREAD) ** 2 + (red / TINT_SPREAD) ** 2 + (blue / TINT_SPREAD) ** 2;
    const gains: Color = [Math.exp(strength + red), Math.exp(strength), Math.exp(strength + blue)];
    const costs = seen.map(({ samples, weight }) =>
      costsOf(samples, kinds, gains).map((cost) => weight * cost),
    );
    const chosen = assign(costs);
    return { light, chosen, cost: total(costs, chosen) + prior };
  });
  return tried.reduce((a, b) => (b.cost < a.cost ? b : a));
}

/** The colours of a ball as they would be in the middle of the light, without glare. */
function colorsOf(
  pixels: Pixels,
  camera: Camera,
  cloth: Cloth,
  radius: number,
  balls: readonly SeenBall[],
  ball: SeenBall,
): Sampled[] {
  const out = new Float64Array(3);
  const here = cloth.at(ball.place);
  const even = [0, 1, 2].map((c) => (here[c]! > 0 ? cloth.usual[c]! / here[c]! : 1));
  const found: Sampled[] = [];
  const places = samples(ball.points, RINGS);
  for (const [k, [x, y]] of places.entries()) {
    const at: Point = [ball.pixel[0] + x, ball.pixel[1] + y];
    if (!sample(pixels, at[0], at[1], out) || covered(ball, at, balls, camera, radius)) continue;
    if (Math.min(out[0]!, out[1]!, out[2]!) >= GLARE) continue;
    const ring = RINGS[Math.floor((k * RINGS.length) / places.length)]!;
    const color = out.map((value, c) => value * even[c]!) as unknown as Color;
    found.push({ color, isEdge: ring > EDGE });
  }
  return found;
}

function kindOf(id: string, index: number): Kind {
  const { body, striped, label } = look(id, index);
  const color = [1, 3, 5].map((at) => parseInt(body.slice(at, at + 2), 16)) as unknown as Color;
  const isWhite = !striped && Math.min(...color) > 200;
  return { body: color, isWhite, whiteness: striped ? STRIPED : label ? NUMBERED : PLAIN };
}

/** How badly the samples of a ball fit each kind in a light. */
function costsOf(seen: readonly Sampled[], kinds: readonly Kind[], light: Color): number[] {
  if (seen.length === 0) return kinds.map(() => 0);
  const white = seen.map(({ color }) => fit(color, WHITE, light));
  const whiteCost = PIXELS * mean(white.map(({ distance }) => distance)) + litCost(white);
  const known = new Map<string, Fitted>();
  return kinds.map(({ body, isWhite, whiteness }) => {
    if (isWhite) return whiteCost;
    const key = body.join();
    const fit = known.get(key) ?? fitted(seen, white, body, light);
    known.set(key, fit);
    const { spread } = whiteness;
    const shares = [(fit.white - whiteness.white) / spread, (fit.edge - whiteness.edge) / spread];
    const striped = (shares[0]! ** 2 + shares[1]! ** 2) / 2 + 2 * Math.log(spread);
    return fit.cost + striped;
  });
}

/** How a ball fits a colour: its cost, and the shares of its samples that are white. */
interface Fitted {
  readonly cost: number;
  readonly white: number;
  readonly edge: number;
}

function fitted(
  seen: readonly Sampled[],
  white: readonly Fit[],
  body: Color,
  light: Color,
): Fitted {
  const colored = seen.map(({ color }) => fit(color, body, light));
  const isWhite = colored.map(({ distance }, k) => white[k]!.distance < distance);
  const share = (some: readonly boolean[]) => some.filter(Boolean).length / (some.length || 1);
  const nearer = colored.map((one, k) => (isWhite[k]! ? white[k]! : one));
  const own = colored.filter((_, k) => !isWhite[k]!);
  const pale = white.filter((_, k) => isWhite[k]!);
  return {
    cost:
      PIXELS * mean(nearer.map(({ distance }) => distance)) +
      (own.length * litCost(own) + pale.length * litCost(pale)) / seen.length,
    white: share(isWhite),
    edge: share(isWhite.filter((_, k) => seen[k]!.isEdge)),
  };
}

/** How unlikely the light on a ball is: its lit side has the light of the cloth around it. */
function litCost(fits: readonly Fit[]): number {
  const sorted = fits.map(({ shade }) => shade).sort((a, b) => a - b);
  const lit = Math.max(0.05, sorted[Math.floor(LIT * (sorted.length - 1))] ?? 1);
  return (Math.log(lit) / LIT_SPREAD) ** 2;
}

function mean(values: readonly number[]): number {
  return values.reduce((sum, value) => sum + value, 0) / values.length;
}

/** How a colour fits a body's: the light on it, and the squared distance in standard deviations. */
interface Fit {
  readonly shade: number;
  readonly distance: number;
}

function fit(color: Color, body: Color, light: Color): Fit {
  const [r, g, b] = [body[0] * light[0], body[1] * light[1], body[2] * light[2]];
  const along = (color[0] * r + color[1] * g + color[2] * b) / (r * r + g * g + b * b);
  const shade = Math.min(LIGHT, Math.max(SHADE, along));
  const [x, y, z] = [color[0] - shade * r, color[1] - shade * g, color[2] - shade * b];
  return {
    shade: along,
    distance: Math.min(FARTHEST ** 2, (x * x + y * y + z * z) / SPREAD ** 2),
  };
}
