/** Small plots of a ball's speed and spin against time, with a cursor at the present time. */

import type { Trace } from "../../engine/index.ts";
import { h, setText, svg } from "../common/dom.ts";
import type { Store } from "../document/store.ts";
import { seek } from "./control.ts";
import type { Show } from "./state.ts";
import { curve, type PlotArea, roundUp, xOf, yOf } from "./plot.ts";
import { sample, type Samples } from "./samples.ts";

/** Size of a plot's drawing; the page scales it to the panel. */
const WIDTH = 288;
const HEIGHT = 64;

interface Line {
  readonly name: string;
  readonly values: (samples: Samples) => readonly number[];
}

interface Plot {
  readonly name: string;
  readonly unit: string;
  readonly lines: readonly Line[];
}

const PLOTS: readonly Plot[] = [
  { name: "Speed", unit: "m/s", lines: [{ name: "speed", values: ({ speed }) => speed }] },
  {
    name: "Spin",
    unit: "rad/s",
    lines: [
      { name: "total", values: ({ spin }) => spin },
      { name: "English, + is left", values: ({ side }) => side },
    ],
  },
];

export function mountPlots(root: HTMLElement, store: Store): Show {
  const plots = PLOTS.map((plot) => mountPlot(root, store, plot));
  let shown: { trace: Trace; ball: number } | null = null;
  let samples: Samples | null = null;

  return (trace, ball, time) => {
    if (shown?.trace !== trace || shown.ball !== ball) {
      shown = { trace, ball };
      samples = sample(trace, ball);
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
      ...lines.map((line, index) => h("span", { class: `line-${index}` }, line.name)),
    );
  root.append(
    h(
      "figure",
      { class: "plot" },
      h("figcaption", {}, h("span", {}, `${name}, ${unit}`), key),
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
      setText(high, String(area.high));
      setText(low, String(area.low));
      setText(end, `${duration.toFixed(2)} s`);
      picture.setAttribute(
        "aria-label",
        `${name} against time: from ${least.toPrecision(3)} to ${most.toPrecision(3)} ${unit} ` +
          `in ${duration.toFixed(2)} s`,
      );
    },
    point: (time) => cursor.setAttribute("d", `M${xOf(area, time)} 0V${HEIGHT}`),
  };
}
