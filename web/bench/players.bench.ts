/**
 * The players in WebAssembly, in Node, compared with the native ones: ruled successors a second, in the
 * positions and with the plays and errors of the example `successors` of carom-plan; and the time of a
 * decision of the player carom at club level in mid-game layouts of eight-ball. One core. Prints the
 * results and writes them to benches/results/players.json.
 */
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { cpus, loadavg, tmpdir } from "node:os";
import { expect, test } from "vitest";
import { type Decision, type FrameRecord, load, type Play } from "../src/engine/index.ts";
import { commitAndDate } from "./commit.ts";
import { layouts } from "./layouts.ts";
import { median, nativeProgram, nativeTime, round, ROOT, timeOf } from "./measure.ts";

/** Least number of ruled successors a second, and longest time of a decision, ms. */
const LEAST_SUCCESSORS = 50_000;
const LONGEST_DECISION = 500;

/** Variants of each play in a measurement: about two seconds. */
const VARIANTS = 1500;
/** Budgets of simulated shots. The bar is for the larger one. */
const BUDGETS = [2_000, 10_000] as const;
/** Layouts in which decisions are timed. */
const LAYOUTS = 20;
/** Rounds of alternating measurements, for the medians. */
const ROUNDS = 7;

const engine = await load();

/** Measures the two in turns; the first measurement of each is a warm-up. */
function alternate(native: () => number, node: () => number) {
  const times = { native: [] as number[], node: [] as number[] };
  for (let k = 0; k <= ROUNDS; k++) {
    const row = [native(), node()] as const;
    if (k === 0) continue;
    times.native.push(row[0]);
    times.node.push(row[1]);
  }
  const ratio = round(median(times.native.map((time, k) => time / times.node[k]!)));
  return { native: median(times.native), node: median(times.node), ratio };
}

function successors() {
  const program = nativeProgram("carom-plan", "successors");
  const written = execFileSync(program, ["1", "records"], { encoding: "utf8", maxBuffer: 64e6 });
  const positions = (
    JSON.parse(written) as { readonly record: FrameRecord; readonly play: Play }[]
  ).map(({ record, play }) => ({ frame: engine.replay(record), play }));
  const noise = engine.olympiad();
  const kept = (n: number) => {
    let sum = 0;
    for (const { frame, play } of positions) {
      const { request } = frame.state;
      if (request.kind !== "shot") throw new Error("a position asks for no shot");
      const { player } = frame.successors(play, noise, n, { seed: 1 });
      sum += player.filter((seat) => seat === request.player).length;
    }
    return sum;
  };
  // The same successors: as many of them keep the turn.
  const native = execFileSync(program, [String(VARIANTS), "rule"], { encoding: "utf8" });
  expect(kept(VARIANTS)).toBe(Number(native));
  const start = () => nativeTime(program, 1, "rule");
  const times = alternate(
    () => nativeTime(program, VARIANTS + 1, "rule") - start(),
    () => timeOf(() => kept(VARIANTS)),
  );
  const perSecond = (time: number) => Math.round((1e3 * VARIANTS * positions.length) / time);
  const { native: n, node, ratio } = times;
  return { native: perSecond(n), node: perSecond(node), ratio_to_native: ratio };
}

/** The bits of decisions combined, as the native program prints them. */
function combined(decisions: readonly Decision[]): string {
  const view = new DataView(new ArrayBuffer(8));
  const bits = (x: number) => {
    view.setFloat64(0, x);
    return view.getBigUint64(0);
  };
  let sum = 0n;
  for (const { play, win_chance } of decisions) {
    sum ^= bits(win_chance!) ^ (play ? bits(play.strike.azimuth) : 0n);
  }
  return sum.toString(16).padStart(16, "0");
}

function decisions(simulations: number) {
  const program = nativeProgram("carom-mind", "decisions");
  const files = layouts().slice(0, LAYOUTS);
  const frames = files.map((file) => engine.frameOf("eight-ball", engine.shot(file)));
  const player = engine.player({ noise: engine.noisePresets.club!, simulations });
  const decide = () => frames.map((frame) => player.choose(frame));
  const folder = mkdtempSync(`${tmpdir()}/carom-bench-`);
  try {
    const list = `${folder}/shots.jsonl`;
    writeFileSync(list, `${files.join("\n")}\n`);
    const given = [list, String(simulations), "1"];
    const native = execFileSync(program, given, { encoding: "utf8" });
    const ours = decide();
    const spent = ours.reduce((sum, decision) => sum + decision.simulations, 0);
    expect(`${spent} ${combined(ours)}\n`).toBe(native);
    const times = alternate(
      () => nativeTime(program, ...given),
      () => timeOf(decide),
    );
    return {
      simulations,
      simulated: Math.round(spent / LAYOUTS),
      native_ms: round(times.native / LAYOUTS),
      node_ms: round(times.node / LAYOUTS),
      ratio_to_native: times.ratio,
    };
  } finally {
    rmSync(folder, { recursive: true });
  }
}

test("successors and decisions in WebAssembly are fast enough", { timeout: 1_200_000 }, () => {
  const result = {
    ...commitAndDate(),
    processor: cpus()[0]?.model,
    node: process.version,
    rounds: ROUNDS,
    ruled_successors_per_second: successors(),
    decisions: BUDGETS.map(decisions),
    // Load of the machine: processor time grows too if it exceeds the number of cores.
    load: round(loadavg()[0]!),
  };
  writeFileSync(`${ROOT}benches/results/players.json`, `${JSON.stringify(result, null, 2)}\n`);
  console.log(result);
  expect(result.ruled_successors_per_second.node).toBeGreaterThan(LEAST_SUCCESSORS);
  expect(result.decisions.at(-1)!.node_ms).toBeLessThan(LONGEST_DECISION);
});
