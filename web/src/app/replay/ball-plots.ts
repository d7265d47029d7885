/** Small plots of a ball's speed and spin against time, with a cursor at the present time. */

import type { Trace } from "../../engine/index.ts";
import { h, setText, svg } from "../common/dom.ts";
import type { Store } from "../document/store.ts";
import { seek } from "./replay-control.ts";
import type { Show } from "./replay-state.ts";
import { curve, type PlotArea, roundUp, xOf, yOf } from "./plot-curves.ts";
import { sample, type Samples } from "./ball-samples.ts";
import { decimal, type PlainKey, t } from "../words/translate.ts";

/** Size of a plot's drawing; the page scales it to the panel. */
const WIDTH = 288;
const HEIGHT = 64;

interface Line {
  readonly name: PlainKey;
  readonly values: (samples: Samples) => readonly number[];
}

interface Plot {
  readonly name: PlainKey;
  readonly unit: string;
  readonly lines: readonly Line[];
}

const PLOTS: readonly Plot[] = [
  {
    name: "replay.speed-now",
    unit: "m/s",
    lines: [{ name: "replay.speed-now", values: ({ speed }) => speed }],
  },
  {
    name: "replay.spin",
    unit: "rad/s",
    lines: [
      { name: "replay.total", values: ({ spin }) => spin },
      { name: "replay.english", values: ({ side }) => side },
    ],
  },
];

export function mountPlots(root: HTMLElement, store: Store): Show {
  const still = h("p", { class: "hint" }, t("replay.still"));
  const figures = h("div");
  root.append(still, figures);
  const plots = PLOTS.map((plot) => mountPlot(figures, store, plot));
  let shown: { trace: Trace; ball: number } | null = null;
  let samples: Samples | null = null;

  return (trace, ball, time) => {
    if (shown?.trace !== trace || shown.ball !== ball) {
      shown = { trace, ball };
      samples = sample(trace, ball);
      const moves = [...samples.speed, ...samples.spin].some((value) => value > 0);
      still.hidden = moves;
      figures.hidden = !moves;
      for (const plot of plots) plot.draw(samples, trace.duration);
    }
    for (const plot of plots) plot.point(time);
  };
}

interface Drawn {
  draw: (samples: Samples, duration: number) => void;
  point: (time: number) => void;
}

function mountPlot(root: HTMLElement, store: Store, { name, unit, lines }: Plot): Drawn {
  const curves = lines.map((_, index) => svg("path", { class: `curve line-${index}` }));
  const zero = svg("path", { class: "zero" });
  const cursor = svg("path", { class: "cursor" });
  const high = h("span", { class: "high" });
  const low = h("span", { class: "low" });
  const end = h("span", { class: "until" });
  const picture = svg(
    "svg",
    { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, preserveAspectRatio: "none", role: "img" },
    zero,
    ...curves,
    cursor,
  );
  const key =
    lines.length > 1 &&
    h(
      "span",
      { class: "key" },
      ...lines.map((line, index) => h("span", { class: `line-${index}` }, t(line.name))),
    );
  root.append(
    h(
      "figure",
      { class: "plot" },
      h("figcaption", {}, h("span", {}, t("replay.plot", { name: t(name), unit })), key),
      picture,
      high,
      low,
      end,
    ),
  );
  let area: PlotArea = { width: WIDTH, height: HEIGHT, duration: 0, low: 0, high: 1 };
  picture.addEventListener("click", (event) => {
    const box = picture.getBoundingClientRect();
    seek(store, ((event.clientX - box.left) / box.width) * area.duration);
  });

  return {
    draw: (samples, duration) => {
      const all = lines.map((line) => line.values(samples));
      const most = all.flat().reduce((a, b) => Math.max(a, b), 0);
      const least = all.flat().reduce((a, b) => Math.min(a, b), 0);
      area = { ...area, duration, high: roundUp(most), low: least < 0 ? -roundUp(-least) : 0 };
      all.forEach((values, i) => curves[i]!.setAttribute("d", curve(area, samples.times, values)));
      zero.setAttribute("d", `M0 ${yOf(area, 0)}H${WIDTH}`);
      setText(high, decimal(area.high));
      setText(low, decimal(area.low));
      const whole = t("replay.seconds", { seconds: decimal(duration, 2) });
      setText(end, whole);
      picture.setAttribute(
        "aria-label",
        t("replay.plot-label", {
          name: t(name),
          least: Number(least.toPrecision(3)),
          most: Number(most.toPrecision(3)),
          unit,
          duration: whole,
        }),
      );
    },
    point: (time) => cursor.setAttribute("d", `M${xOf(area, time)} 0V${HEIGHT}`),
  };
}
