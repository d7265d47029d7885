/** The tasks of a page's main thread, from Chromium's traces. */
import type { Page } from "playwright-core";

/** Tasks are "RunTask"; what runs within them has the second category. */
const CATEGORIES = [
  "disabled-by-default-devtools.timeline",
  "devtools.timeline",
  "blink.user_timing",
];

/** An event of a trace; times in microseconds. */
export interface TraceEvent {
  readonly name: string;
  readonly pid: number;
  readonly tid: number;
  /** Start. */
  readonly ts: number;
  /** Duration. */
  readonly dur?: number;
  /** Processor time. */
  readonly tdur?: number;
}

/** The tasks of a page while `work` ran. */
export interface Tasks {
  /** The longest one, ms: on the clock, and the processor time of the one with most of it. */
  readonly longest: number;
  readonly longest_processor: number;
  /** Number of tasks of more than 50 ms on the clock. */
  readonly long: number;
}

/** The events of the main thread of `page` while `work` runs, which must not navigate to another process. */
export async function traced(page: Page, work: () => Promise<void>): Promise<TraceEvent[]> {
  const browser = page.context().browser()!;
  await browser.startTracing(page, { categories: CATEGORIES });
  await work();
  await page.evaluate(() => performance.mark("carom:end"));
  const text = String(await browser.stopTracing());
  const { traceEvents } = JSON.parse(text) as { traceEvents: TraceEvent[] };
  const end = traceEvents.findLast(({ name }) => name === "carom:end")!;
  return traceEvents.filter(({ pid, tid }) => pid === end.pid && tid === end.tid);
}

/** The tasks of the main thread of `page` while `work` runs. */
export async function tasksOf(page: Page, work: () => Promise<void>): Promise<Tasks> {
  const tasks = (await traced(page, work)).filter(({ name }) => name === "RunTask");
  if (tasks.length === 0) throw new Error("the trace has no tasks of the page");
  const times = tasks.map(({ dur = 0 }) => dur / 1000);
  return {
    longest: Math.max(...times),
    longest_processor: Math.max(...tasks.map(({ tdur = 0 }) => tdur / 1000)),
    long: times.filter((time) => time > 50).length,
  };
}
