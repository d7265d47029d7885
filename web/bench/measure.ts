/** Native programs to compare with, and medians. All times are processor times, which other programs disturb little. */
import { execFileSync, spawnSync } from "node:child_process";
import { fileURLToPath } from "node:url";

export const ROOT = fileURLToPath(new URL("../../", import.meta.url));

/** The path of an example of a crate, as the plain build for the platform, without flags for this processor. */
export function nativeProgram(crate: string, example: string): string {
  const command = ["build", "--quiet", "--profile", "bench", "-p", crate];
  command.push("--example", example, "--message-format", "json");
  const built = execFileSync("cargo", command, {
    cwd: ROOT,
    encoding: "utf8",
    maxBuffer: 64e6,
    env: { ...process.env, RUSTFLAGS: "" },
  });
  for (const line of built.split("\n").filter(Boolean)) {
    const { executable, target } = JSON.parse(line) as {
      executable?: string | null;
      target?: { name: string };
    };
    if (executable && target?.name === example) return executable;
  }
  throw new Error(
    `cargo built no program ${example}: check the example of this name in crates/${crate}`,
  );
}

/** Processor time of a program with these arguments, including its start, ms. */
export function nativeTime(program: string, ...given: readonly (string | number)[]): number {
  const timed = `TIMEFORMAT=%3U; time "$0" "$@" > /dev/null`;
  const run = spawnSync("bash", ["-c", timed, program, ...given.map(String)], {
    encoding: "utf8",
  });
  const seconds = Number(run.stderr);
  if (run.status !== 0 || !Number.isFinite(seconds)) throw new Error(run.stderr);
  return seconds * 1e3;
}

/** Processor time of work on this thread, ms. */
export function timeOf(work: () => unknown): number {
  const before = process.cpuUsage();
  work();
  return process.cpuUsage(before).user / 1e3;
}

export function median(values: readonly number[]): number {
  return values.toSorted((a, b) => a - b)[values.length >> 1]!;
}

/** Three digits. */
export function round(value: number): number {
  return Number(value.toPrecision(3));
}
