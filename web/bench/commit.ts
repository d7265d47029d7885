/** The commit and day of a measurement, as `carom bench` stores them. */
import { execFileSync } from "node:child_process";
import { fileURLToPath } from "node:url";

const ROOT = fileURLToPath(new URL("../../", import.meta.url));

/** Every tracked file but the results: one benchmark writes its results before the next one starts. */
const CODE = [".", ":(exclude)benches/results"];

/** The checkout's short commit, with `+` if files of CODE have changes, and the date in UTC. */
export function commitAndDate(): { readonly commit: string; readonly date: string } {
  const git = (...command: string[]) =>
    execFileSync("git", ["-C", ROOT, ...command], { encoding: "utf8" }).trim();
  const changed = git("status", "--porcelain", "--untracked-files=no", "--", ...CODE) !== "";
  return {
    commit: git("rev-parse", "--short", "HEAD") + (changed ? "+" : ""),
    date: new Date().toISOString().slice(0, 10),
  };
}
