/** The page of the Train tab on which a drill is made from positions of the table. */

import type { DrillFile } from "../../../engine/index.ts";
import { round4 } from "../../common/angles.ts";
import { h } from "../../common/dom.ts";
import { ballName } from "../../common/shot-words.ts";
import { t } from "../../words/translate.ts";
import { areasOfMarks, marksOf } from "../../document/marks.ts";
import { diagram } from "../drill-diagram.ts";
import { drillOfFile, stepOf } from "../drill-file.ts";
import { restOf } from "../drill-judge.ts";
import { layoutOf } from "../drill-layout.ts";
import { clothOf } from "../drill-places.ts";
import type { Drill } from "../drills/index.ts";
import { needText } from "../goal-words.ts";
import { button, heading, type Trainer } from "../train-parts.ts";
import type { Draft } from "./draft.ts";
import { conditionForm, number, type OwnCondition, select } from "./condition-form.ts";
import { MOST_POINTS, zoneForm, zonesOf } from "./zone-form.ts";

/** Bounds of the format. */
const MOST_STEPS = 30;
const MOST_ATTEMPTS = 100;
const MOST_NEEDS = 12;

/** Size of the balls over their size on the table. */
const ENLARGED = 1.6;

/** A radius of the circle around the end of the aimed shot, m. */
const CIRCLE = 0.2;

type FileStep = DrillFile["steps"][number];

/** What the fields of a draft have, if it is newer than the draft. */
const typed = new WeakMap<Draft, DrillFile>();

export function mountOwnForm(root: HTMLElement, trainer: Trainer, draft: Draft): void {
  const file = typed.get(draft) ?? draft.file;
  const change = (patch: Partial<DrillFile>) =>
    trainer.go({ kind: "own", draft: { ...draft, file: { ...read(), ...patch } } });
  const name = h("input", { id: "own-name", type: "text", maxlength: "100" });
  name.value = file.name;
  const text = h("textarea", { id: "own-text", rows: "3", maxlength: "2000" });
  text.value = file.text ?? "";
  const attempts = number("own-attempts", t("own.attempts"), file.attempts, 1, MOST_ATTEMPTS);
  const misses = number("own-misses", t("own.misses"), file.misses ?? null, 1, MOST_ATTEMPTS);
  const orders =
    file.steps.length > 1 ? (["ladder", "turns", "same"] as const) : (["same"] as const);
  const order = select("own-order", t("own.order"), orders, (one) => t(`own.order-${one}`));
  order.control.value = file.order ?? orders[0];

  /** The draft with what the fields have now. */
  function read(): DrillFile {
    const missed = misses.control.valueAsNumber;
    const { format, table, cue, steps } = file;
    return {
      format,
      name: name.value.trim(),
      ...(text.value.trim() !== "" && { text: text.value.trim() }),
      table,
      ...(cue !== undefined && { cue }),
      attempts: attempts.control.valueAsNumber,
      ...(Number.isInteger(missed) && { misses: missed }),
      order: order.control.value as NonNullable<DrillFile["order"]>,
      steps,
    };
  }
  // The user leaves the form to set up the next position.
  for (const field of [name, text, attempts.control, misses.control, order.control]) {
    field.addEventListener("change", () => typed.set(draft, read()));
  }

  root.append(
    h(
      "div",
      { class: "row" },
      button("all-drills", t("train.all"), () => trainer.go({ kind: "overview" })),
    ),
    heading(t("own.title")),
    h("p", { class: "hint" }, t("own.intro")),
    h("div", { class: "labelled" }, h("label", { for: name.id }, t("own.name")), name),
    h("div", { class: "labelled" }, h("label", { for: text.id }, t("own.text")), text),
    attempts.root,
    misses.root,
    order.root,
    ...file.steps.map((_, k) => stepCard(trainer, file, k, (steps) => change({ steps }))),
    h(
      "div",
      { class: "row" },
      button("own-add-step", t("own.add-step"), () => addStep(trainer, { ...draft, file: read() })),
    ),
    h(
      "div",
      { class: "row end pinned" },
      button("own-save", t("own.save"), () => save(trainer, { ...draft, file: read() }), true),
    ),
  );
}

/** A step: its diagram, its conditions, its points. */
function stepCard(
  trainer: Trainer,
  file: DrillFile,
  index: number,
  change: (steps: readonly FileStep[]) => void,
): HTMLElement {
  const { engine } = trainer.context;
  const step = file.steps[index]!;
  const { goal } = step;
  const drill: Drill = drillOfFile(engine, file);
  const setting = { drill, step: stepOf(clothOf(engine, file.table), step), attempt: 0 };
  const set = (one: Partial<FileStep>) =>
    change(file.steps.map((other, k) => (k === index ? { ...step, ...one } : other)));
  const title = t("train.step", { step: index + 1, steps: file.steps.length });
  const remove = button(`own-remove-${index}`, t("own.remove-step"), () =>
    change(file.steps.filter((_, k) => k !== index)),
  );
  const parts: (Node | false)[] = [
    h("h3", {}, title),
    diagram(engine, setting, { label: title, enlarged: ENLARGED }),
  ];
  if (goal.kind === "shot") {
    const setNeeds = (needs: readonly OwnCondition[]) => set({ goal: { ...goal, needs } });
    const { geometry } = clothOf(engine, file.table);
    const { zones = [] } = goal;
    const points = number(`own-points-${index}`, t("own.points"), goal.points ?? 1, 1, MOST_POINTS);
    points.control.addEventListener("change", () => {
      const value = points.control.valueAsNumber;
      if (Number.isInteger(value)) set({ goal: { ...goal, points: value } });
    });
    const place = {
      balls: step.balls.map(({ id }) => id),
      cue: file.cue ?? "cue",
      pockets: geometry.pockets.map(({ name }) => name),
      end: endOf(trainer.store.ghost.trace, file.cue ?? "cue"),
    };
    parts.push(
      h(
        "ul",
        { class: "own-needs" },
        ...goal.needs.map((need, k) =>
          needRow(`own-need-${index}-${k}`, need, () =>
            setNeeds(goal.needs.filter((_, other) => other !== k)),
          ),
        ),
      ),
      goal.needs.length < MOST_NEEDS &&
        conditionForm(`own-${index}`, place, (condition) => setNeeds([...goal.needs, condition])),
      // Zones give the points of an attempt themselves.
      zones.length === 0 && points.root,
      zoneForm(
        trainer,
        `own-zone-${index}`,
        { zones, layout: layoutOf(engine, setting), geometry },
        (next) => set({ goal: { ...goal, zones: next } }),
      ),
    );
  }
  parts.push(h("div", { class: "row" }, remove));
  return h("section", { class: "own-step", "aria-label": title }, ...parts);
}

function needRow(id: string, need: OwnCondition, remove: () => void): HTMLElement {
  // Areas do not appear in the sentence, so that those of files will do.
  const text = needText(need);
  return h("li", {}, text, " ", button(id, t("own.remove-condition"), remove));
}

/** Where a shot leaves the cue ball, m; null if it is lost. */
function endOf(trace: Trainer["store"]["ghost"]["trace"], cue: string) {
  if (!trace || trace.outcome.cue_ball_scratched || trace.outcome.off_table.includes(cue))
    return null;
  const end = restOf(trace, cue);
  return end && ([round4(end[0]), round4(end[1])] as const);
}

/** Adds the position of the table, with what the aimed shot does as its goal. */
function addStep(trainer: Trainer, draft: Draft): void {
  const { store, go } = trainer;
  const { shot, game } = store.document;
  const { file } = draft;
  const { table, strike } = shot;
  if (typeof table !== "string" || game) {
    store.refuse(t(game ? "own.in-game" : "own.own-table"));
    return;
  }
  const isFirst = file.steps.length === 0;
  if (!isFirst && (table !== file.table || strike.ball !== (file.cue ?? "cue"))) {
    store.refuse(t("own.other-table", { ball: ballName(file.cue ?? "cue") }));
    return;
  }
  if (file.steps.length === MOST_STEPS) {
    store.refuse(t("own.full"));
    return;
  }
  const areas = areasOfMarks(marksOf(shot));
  const zones = zonesOf(areas, clothOf(trainer.context.engine, table).geometry);
  const step: FileStep = {
    balls: shot.balls.map(({ id, position: [x, y] }) => ({ id, position: [x, y] })),
    speed: strike.speed,
    goal: {
      kind: "shot",
      needs: needsOf(trainer, strike.ball, zones.length > 0),
      ...(zones.length > 0 && { zones }),
    },
  };
  const steps = [...file.steps, step];
  const kept = file.order ?? "same";
  const order = isFirst ? "same" : kept === "same" && file.steps.length === 1 ? "ladder" : kept;
  const grown = { ...file, table, cue: strike.ball, order, steps };
  go({ kind: "own", draft: { ...draft, file: grown } });
}

/** What the aimed shot does: it pots balls, or hits a ball first; and without zones where the cue ball stops. */
function needsOf({ store }: Trainer, cue: string, hasZones: boolean): OwnCondition[] {
  const { trace } = store.ghost;
  if (!trace) return [];
  const { pocketed, first_contact: first } = trace.outcome;
  const pots = pocketed
    .filter(([ball]) => ball !== cue)
    .map(([ball, pocket]): OwnCondition => ({ kind: "pot", ball, pocket }));
  const center = endOf(trace, cue);
  return [
    ...(pots.length > 0 ? pots : first === null ? [] : [{ kind: "first", ball: first } as const]),
    ...(center && !hasZones ? [{ kind: "stop", area: { center, radius: CIRCLE } } as const] : []),
  ];
}

function isEmpty(goal: FileStep["goal"]): boolean {
  return goal.kind === "shot" && goal.needs.length === 0 && !goal.zones?.length;
}

/** Keeps the drill, after the engine has checked it, and shows it. */
function save({ store, context, keeper, go }: Trainer, { file, kept }: Draft): void {
  if (file.name === "") store.refuse(t("own.no-name"));
  else if (file.steps.length === 0) store.refuse(t("own.no-steps"));
  else if (file.steps.some(({ goal }) => isEmpty(goal))) {
    store.refuse(t("own.no-goal"));
  } else {
    const { engine } = context;
    const isRight =
      Number.isInteger(file.attempts) && file.attempts >= 1 && file.attempts <= MOST_ATTEMPTS;
    if (!isRight) {
      store.refuse(t("own.wrong-attempts", { most: MOST_ATTEMPTS }));
      return;
    }
    const name = keeper.addDrill(engine.drill(file), kept);
    go({ kind: "drill", drill: drillOfFile(engine, { ...file, name }) });
    context.announce(t("own.saved", { name }));
  }
}
