/** Studies and the document: the position and the shots of a chapter, and a chapter of what the table shows. */

import type {
  BallEntry,
  ShotFile,
  StrikeEntry,
  GoalArea,
  StudyChapter,
  GoalCondition,
  StudyShot,
} from "../../engine/index.ts";
import { azimuthTo } from "../common/angles.ts";
import { omit } from "../common/omit.ts";
import type { AimedShot } from "./aimed-shot.ts";
import { aimed } from "./shot-file.ts";
import { NO_TREE, startsFrom, type Tree, type TreeNode } from "./shot-tree.ts";

/** As the format allows (docs/studies.md). */
export const MOST_CHAPTERS = 200;
export const LONGEST_TITLE = 100;
export const LONGEST_TEXT = 4000;

/** The balls at the end of a shot; null if no shot can follow. */
type EndOf = (shot: AimedShot) => readonly BallEntry[] | null;

/** Shot and tree of a chapter. A position without a strike is aimed at the nearest ball. */
export function positionOf(
  chapter: StudyChapter,
  endOf: EndOf,
): { readonly shot: AimedShot; readonly tree: Tree | undefined } {
  const { shot: file, tree = [] } = chapter;
  const shot = file.strike ? aimed(file) : aimedAtBall(file, chapter.task?.solution);
  const nodes: TreeNode[] = [];
  const base = omit(shot, "marks", "strike");
  tree.forEach(({ after, strike, comment = "" }, index) => {
    const parent = after === undefined ? null : nodes.find(({ id }) => id === after + 1);
    // What follows a shot that cannot be played cannot be played either.
    const balls = parent === null ? base.balls : parent && endOf(parent.shot);
    if (!balls) return;
    const played = { ...base, balls, strike };
    nodes.push({ id: index + 1, parent: parent?.id ?? null, shot: played, comment });
  });
  return { shot, tree: nodes.length > 0 ? { nodes, at: null } : undefined };
}

/** Cue speed (m/s) with which a task begins. */
const SPEED = 2;

/** The cue points at the nearest ball; the solution only tells which ball is struck. */
function aimedAtBall(file: ShotFile, solution: StrikeEntry | undefined): AimedShot {
  const { strike } = aimed(file);
  const ball = solution?.ball ?? strike.ball;
  const from = file.balls.find(({ id }) => id === ball)?.position;
  const others = file.balls.filter(({ id }) => id !== ball);
  if (!from || others.length === 0) return { ...file, strike: { ...strike, ball } };
  const away = ([x, y]: BallEntry["position"]) => Math.hypot(x - from[0], y - from[1]);
  const nearest = others.reduce((a, b) => (away(b.position) < away(a.position) ? b : a));
  const azimuth_deg = azimuthTo([from[0], from[1]], [nearest.position[0], nearest.position[1]]);
  return { ...file, strike: { ball, speed: SPEED, azimuth_deg } };
}

/**
 * A chapter of what the table shows. With a task its shot has no strike, which would show how to solve it.
 *
 * @param shot The shot with dated names of presets.
 */
export function chapterOf(
  { shot: shown, tree = NO_TREE }: { readonly shot: AimedShot; readonly tree?: Tree | undefined },
  shot: ShotFile,
  { title, text, task }: Pick<StudyChapter, "title" | "text" | "task">,
): StudyChapter {
  const { strike } = shot;
  const position = omit(shot, "strike", "track");
  const shots = shotsFrom(tree, shown);
  return {
    title,
    ...(text ? { text } : {}),
    shot: task ? position : { ...position, ...(strike && { strike }) },
    ...(shots.length > 0 && { tree: shots }),
    ...(task && { task }),
  };
}

/** The shots of a tree that are played from a position, and those that follow them. */
function shotsFrom(tree: Tree, position: AimedShot): StudyShot[] {
  const shots: StudyShot[] = [];
  const indices = new Map<number, number>();
  const seen = new Set<string>();
  for (const { id, parent, shot, comment } of tree.nodes) {
    const after = parent === null ? undefined : indices.get(parent);
    if (after === undefined && !startsFrom(shot, position)) continue;
    const key = JSON.stringify([after, shot.strike]);
    if (seen.has(key)) continue;
    seen.add(key);
    const own = { strike: shot.strike, ...(comment !== "" && { comment }) };
    indices.set(id, shots.push(after === undefined ? own : { after, ...own }) - 1);
  }
  return shots;
}

/** The areas in which a ball shall stop. */
export function areasOf(goal: readonly GoalCondition[] = []): GoalArea[] {
  return goal.flatMap((condition) => (condition.kind === "stop" ? [condition.area] : []));
}
