/**
 * A position or a shot as a picture for paper: light, with thin lines, and readable without colours.
 *
 * The picture needs no style sheet, so that it is the same on the page, as a file and on paper. The layers are listed
 * in `layersOf` from the lowest to the highest.
 */

import type { DrawnMark, Shot, Trace } from "../../engine/index.ts";
import { look } from "../../viewer/index.ts";
import { svg } from "../common/dom.ts";
import { freest, numberBox, type Obstacle } from "./diagram-labels.ts";
import { paperMarks } from "./paper-marks.ts";
import {
  BALL_NUMBER,
  bedMarks,
  diamonds,
  type DrawnTable,
  edgesOf,
  type Mark,
  markings,
  middle,
  numeral,
  placesAround,
  tenth,
} from "./table-marks.ts";

/** Empty edge around the picture, mm on the table. */
const EDGE = 30;

/** Widths of lines, mm on the table: 0.3 mm on a page of A4. */
const THIN = 3;
const LINE = 5;

/** Largest distance of a drawn path from the exact one, and of the points that numbers keep clear of, m. */
const TOLERANCE = 0.002;
const SPACING = 0.03;

/** How each part of the table looks on paper. */
const LOOKS: Readonly<Record<string, Readonly<Record<string, string | number>>>> = {
  "diagram-frame": { fill: "#e3e3e3", stroke: "#6a6a6a", "stroke-width": LINE },
  "diagram-cloth": { fill: "#ffffff", stroke: "#6a6a6a", "stroke-width": LINE },
  "diagram-pocket": { fill: "#c9c9c9", stroke: "#6a6a6a", "stroke-width": THIN },
  "diagram-sight": { fill: "#333333" },
  "diagram-marking": { fill: "none", stroke: "#aaaaaa", "stroke-width": THIN },
  "diagram-spot": { fill: "#aaaaaa" },
  "diagram-id": { fill: "#000000", "font-family": "sans-serif" },
};

/** Dashes of the paths after the cue ball's, which is a whole line: they differ without colours. */
const DASHES = ["35 13", "13 10", "40 10 8 10", "5 9"] as const;

/** Greatest share of light in a path's colour: yellow would not be seen on white. */
const LIGHTEST = 0.45;

/**
 * The picture of a shot, with the paths of its trace if there is one; null on cloth without edges.
 *
 * @param label What the picture shows, for screen readers.
 * @param drawn What is drawn on the table.
 */
export function paperDiagram(
  shot: Shot,
  trace: Trace | null,
  label: string,
  drawn: readonly DrawnMark[] = [],
): SVGSVGElement | null {
  const { size, rail_width: rail = 0.15 } = shot.geometry;
  if (!size) return null;
  const margin = 1000 * rail + EDGE;
  const [across, down] = [1000 * size[1] + 2 * margin, 1000 * size[0] + 2 * margin];
  const picture = svg("svg", {
    xmlns: "http://www.w3.org/2000/svg",
    viewBox: [-margin, -margin, across, down].map((x) => Math.round(x)).join(" "),
    role: "img",
    "aria-label": label,
  });
  picture.append(
    ...layersOf(shot, trace, size, drawn).map(([tag, { class: name, ...attributes }, text]) =>
      svg(tag, { ...attributes, ...LOOKS[String(name)] }, text),
    ),
  );
  return picture;
}

function layersOf(
  shot: Shot,
  trace: Trace | null,
  size: readonly [number, number],
  drawn: readonly DrawnMark[],
): Mark[] {
  const { geometry } = shot;
  const table: DrawnTable = { geometry, size, diamond: [size[0] / 4, size[1] / 8] };
  const paths = trace ? pathsOf(trace) : [];
  return [
    ...bedMarks(table),
    ...diamonds(table, false),
    ...markings(table),
    ...paths.flatMap(({ marks }) => marks),
    ...shot.balls.flatMap(({ id, position, radius }, index): Mark[] => {
      const { body, striped } = look(id, index);
      const place = middle([position[0], position[1]]);
      const rim = { stroke: "#000000", "stroke-width": LINE, fill: striped ? "#ffffff" : body };
      const ball: Mark = ["circle", { ...place, r: 1000 * radius, ...rim }];
      return striped ? [ball, ["circle", { ...place, r: 550 * radius, fill: body }]] : [ball];
    }),
    ...numbersOf(
      shot,
      size,
      paths.flatMap(({ points }) => points),
    ),
    ...paperMarks(drawn),
  ];
}

/** The path of a ball that moves, with the ring where it stops, and points along it, mm. */
interface DrawnPath {
  readonly marks: readonly Mark[];
  readonly points: readonly (readonly [x: number, y: number])[];
}

function pathsOf(trace: Trace): DrawnPath[] {
  const { balls, struck } = trace.shot;
  const last = trace.statesAt(trace.duration);
  const stride = last.length / balls.length;
  const gone = new Set([...trace.outcome.pocketed.map(([id]) => id), ...trace.outcome.off_table]);
  let dashed = 0;
  return balls.flatMap(({ id, radius }, ball) => {
    const line = trace.polyline(ball, TOLERANCE);
    if (line.length <= 4) return [];
    const places: (readonly [number, number])[] = [];
    for (let k = 0; k < line.length; k += 4) places.push([1000 * line[k + 1]!, 1000 * line[k]!]);
    const isStruck = ball === struck;
    const stroke = isStruck ? "#000000" : ink(look(id, ball).body);
    const dash = isStruck ? undefined : DASHES[dashed++ % DASHES.length]!;
    const d = places.map(([x, y], k) => `${k === 0 ? "M" : "L"}${tenth(x)} ${tenth(y)}`).join("");
    const whole = { fill: "none", stroke, "stroke-width": LINE, "stroke-linejoin": "round" };
    const end = middle([last[ball * stride]!, last[ball * stride + 1]!]);
    const ring = { fill: "#ffffff", stroke, "stroke-width": THIN, "stroke-dasharray": "12 9" };
    const marks: Mark[] = [
      ["path", { d, ...whole, ...(dash && { "stroke-dasharray": dash }) }],
      ...(gone.has(id) ? [] : [["circle", { ...end, r: 1000 * radius, ...ring }] as Mark]),
    ];
    return [{ marks, points: spread(places) }];
  });
}

/** Points along a line, not farther apart than `SPACING`. */
function spread(places: DrawnPath["points"]): DrawnPath["points"] {
  return places.flatMap(([x, y], k) => {
    const [fromX, fromY] = places[Math.max(0, k - 1)]!;
    const steps = Math.max(1, Math.ceil(Math.hypot(x - fromX, y - fromY) / (1000 * SPACING)));
    return Array.from({ length: steps }, (_, step) => {
      const share = (step + 1) / steps;
      return [fromX + share * (x - fromX), fromY + share * (y - fromY)] as const;
    });
  });
}

/** A colour that is dark enough for a line on white. */
function ink(color: string): string {
  const parts = [1, 3, 5].map((k) => parseInt(color.slice(k, k + 2), 16) / 255);
  const light = 0.299 * parts[0]! + 0.587 * parts[1]! + 0.114 * parts[2]!;
  const share = Math.min(1, LIGHTEST / Math.max(light, LIGHTEST));
  return `rgb(${parts.map((part) => Math.round(255 * share * part)).join(" ")})`;
}

/** The numbers of the balls, and the letters of their colours, each at a free place. */
function numbersOf(
  { balls }: Shot,
  size: readonly [number, number],
  points: DrawnPath["points"],
): Mark[] {
  const cloth = { left: 0, top: 0, right: 1000 * size[1], bottom: 1000 * size[0] };
  const discs = balls.map(({ position, radius }) => ({
    ...middle([position[0], position[1]]),
    r: 1000 * radius,
  }));
  const taken: Obstacle[] = [
    ...edgesOf(cloth, 0),
    ...discs.map((disc): Obstacle => ({ kind: "disc", ...disc, stroke: LINE })),
    ...points.map(([cx, cy]): Obstacle => ({ kind: "disc", cx, cy, r: 0, stroke: LINE })),
  ];
  const names = namesOf(balls.map(({ id }) => id));
  return balls.flatMap((_, k) => {
    const name = names[k]!;
    if (name === "") return [];
    const places = placesAround(discs[k]!).map((at) => ({
      at,
      box: numberBox(...at, BALL_NUMBER, name.length),
    }));
    const found = freest(places, taken);
    taken.push({ kind: "box", box: found.box, stroke: 0 });
    return [numeral("diagram-id", found.at, BALL_NUMBER, name)];
  });
}

/** What stands beside each ball: its number, or the first letters of its colour where no other ball has it. */
export function namesOf(balls: readonly string[]): string[] {
  const stems = balls.map(stemOf);
  return balls.map((id, k) => {
    const stem = stems[k]!;
    if (stem === "") return id;
    const others = stems.filter((_, other) => other !== k);
    if (id === "cue" || others.includes(stem)) return "";
    let length = 1;
    while (length < stem.length && others.some((one) => one.startsWith(stem.slice(0, length)))) {
      length += 1;
    }
    return stem.charAt(0).toUpperCase() + stem.slice(1, length);
  });
}

/** A name without its number at the end. */
function stemOf(id: string): string {
  let end = id.length;
  while (end > 0 && "0123456789".includes(id[end - 1]!)) end -= 1;
  if (end < id.length && end > 0 && "-_ ".includes(id[end - 1]!)) end -= 1;
  return id.slice(0, end);
}

/** Pixels of a picture along the table. */
const PIXELS = 2400;

/** The picture as the text of a file. */
export function diagramFile(picture: SVGSVGElement): string {
  return `${new XMLSerializer().serializeToString(picture)}\n`;
}

/** The picture in pixels. */
export async function diagramPixels(picture: SVGSVGElement): Promise<Blob> {
  const [, , across = 1, down = 1] = picture.getAttribute("viewBox")!.split(" ").map(Number);
  const sized = picture.cloneNode(true) as SVGSVGElement;
  const [width, height] = [PIXELS, Math.round((PIXELS * down) / across)];
  sized.setAttribute("width", String(width));
  sized.setAttribute("height", String(height));
  const image = new Image();
  image.src = `data:image/svg+xml,${encodeURIComponent(diagramFile(sized))}`;
  await image.decode();
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [width, height];
  const brush = canvas.getContext("2d")!;
  brush.fillStyle = "#ffffff";
  brush.fillRect(0, 0, width, height);
  brush.drawImage(image, 0, 0);
  return new Promise((resolve, reject) => {
    canvas.toBlob((blob) => {
      if (blob) resolve(blob);
      else reject(new Error("the picture has no pixels"));
    }, "image/png");
  });
}
