/** The part of the panel that looks ahead: the zone for the next ball, and a plan of three balls. */

import type { BallInfo } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { h, setText, uniqueId } from "../common/dom.ts";
import { changeUnpressed } from "../common/press.ts";
import { ballName, pocketName } from "../common/shot-words.ts";
import type { Store } from "../document/store.ts";
import { Desk } from "./desk/desk-client.ts";
import type { Leg, PlanJob } from "./desk/desk-protocol.ts";
import { after, estimate, placeOf } from "./desk/desk-layout.ts";
import DeskWorker from "./desk/desk-worker.ts?worker&inline";
import { ellipseAround } from "./leave-picture.ts";
import { noiseOf, positionOf } from "./analysed-position.ts";
import { interval, ordersOf } from "./plan-orders.ts";
import { resultButton, showShot } from "./result-preview.ts";
import { percent, strikeText } from "./analyse-words.ts";
import { capital, t } from "../words/translate.ts";

/** Time (ms) without a change after which the zone is computed again. */
const REST = 250;

/** Balls of a plan. */
const BALLS = 3;

/** How often a plan is played: the standard error of a chance of one half is then 6 %. */
const RUNS = 64;

/** Balls that a proposal considers: the easiest ones. */
const CONSIDERED = 6;

const STOP = "#8fe3ff";

export function mountNext(root: HTMLElement, store: Store, context: Context): void {
  mountZone(root, store, context);
  mountPlan(root, store, context);
}

function mountZone(root: HTMLElement, store: Store, context: Context): void {
  const desk = new Desk(() => new DeskWorker(), context.engine);
  const ball = h("select", { id: uniqueId("next-ball") });
  const status = h("p", { class: "hint", id: "zone-status", role: "status" });
  root.append(
    h("h2", {}, t("next.title")),
    h("div", { class: "row" }, h("label", { for: ball.id }, t("next.ball")), ball),
    status,
  );
  let timer: ReturnType<typeof setTimeout> | undefined;

  function ask(): void {
    clearTimeout(timer);
    const next = ball.value;
    const isShown = next !== "" && store.session.activity === "analyse";
    if (!isShown || store.session.mode === "replay") {
      desk.cancel();
      if (!isShown && store.session.analysis.zone) store.setPart("analysis", { zone: null });
      setText(status, isShown ? status.textContent : t("next.hint"));
      return;
    }
    timer = setTimeout(() => {
      const { trace } = store.ghost;
      const { shot } = store.document;
      // The table on which the next ball is played.
      const left = (trace && after(shot, trace)) ?? shot;
      const file = placeOf(left, next) ? left : shot;
      const noise = noiseOf(context.engine, store.state);
      setText(status, t("next.searching"));
      desk.ask(
        { kind: "zone", shot: JSON.stringify(file), ball: next, noise },
        {
          part: ({ columns, rows, values, share }) => {
            // The colours show square roots, which are for counts: fourth powers make good places stand out.
            store.setPart("analysis", {
              zone: { columns, rows, values: values.map((value) => value ** 4) },
            });
            const best = Math.max(...values);
            if (share === 1)
              setText(
                status,
                best > 0
                  ? t("next.zone", { ball: ballName(next), best: percent(best) })
                  : t("next.none", { ball: ballName(next) }),
              );
          },
          refused: (message) => setText(status, message),
        },
      );
    }, REST);
  }

  const follow = (): void => {
    fill(ball, objectBalls(store), t("next.off"));
    ask();
  };
  ball.addEventListener("change", ask);
  store.subscribe((now, before) => {
    const isSame =
      now.document === before.document &&
      now.session.analysis.level === before.session.analysis.level &&
      now.session.activity === before.session.activity &&
      now.session.mode === before.session.mode;
    if (!isSame) follow();
  });
  follow();
}

function mountPlan(root: HTMLElement, store: Store, context: Context): void {
  const { engine } = context;
  const desk = new Desk(() => new DeskWorker(), engine);
  const chosen = Array.from({ length: BALLS }, () => h("select", { id: uniqueId("plan-ball") }));
  const rows = chosen.map((select, k) =>
    h(
      "div",
      { class: "labelled" },
      h("label", { for: select.id }, t("plan.ball", { number: k + 1 })),
      select,
    ),
  );
  const go = h("button", { type: "button", class: "button", id: "plan" }, t("plan.plan"));
  const list = h("ol", { class: "lines", id: "plan-legs", "aria-label": t("plan.title") });
  const status = h("p", {
    class: "hint",
    id: "plan-status",
    role: "status",
    "aria-live": "polite",
  });
  root.append(
    h("h2", {}, t("plan.title")),
    h("div", { class: "thirds" }, ...rows),
    h("div", { class: "row" }, go),
    list,
    status,
  );

  let shown: readonly Leg[] = [];

  function showLegs(legs: readonly Leg[]): void {
    shown = legs;
    changeUnpressed(list, () => list.replaceChildren(...legs.map(legItem)));
  }

  store.subscribe((now, before) => {
    if (now.session.orientation !== before.session.orientation) showLegs(shown);
  });

  function clear(): void {
    desk.cancel();
    showLegs([]);
    setText(status, t("plan.hint"));
    chosen.forEach((select) => fill(select, objectBalls(store), t("plan.any")));
    const few = objectBalls(store).length;
    rows.forEach((row, k) => (row.hidden = k >= few));
    go.disabled = few === 0;
  }

  go.addEventListener("click", () => {
    const job = jobOf();
    if (!job) {
      setText(status, t("plan.no-order"));
      return;
    }
    showLegs([]);
    setText(status, t("plan.searching"));
    desk.ask(job, {
      part: ({ legs, met, count }) => {
        if (legs.length !== shown.length) showLegs(legs);
        if (count > 0) {
          const [low, high] = interval(met, count).map(percent) as [string, string];
          setText(
            status,
            t("plan.total", {
              count: legs.length,
              chance: percent(met / count),
              low,
              high,
              runs: count,
            }),
          );
        }
      },
      done: () => {
        list.dataset.done = "true";
        if (shown.length < job.length) setText(status, t("plan.none"));
      },
      refused: (message) => setText(status, message),
    });
    delete list.dataset.done;
  });

  function jobOf(): PlanJob | null {
    const noise = noiseOf(engine, store.state);
    const { shot, document } = store;
    const cue = placeOf(document.shot, document.shot.strike.ball);
    const all = objectBalls(store);
    const wanted = chosen.filter((_, k) => k < all.length).map(({ value }) => value || null);
    const ease = (id: string) => {
      const at = placeOf(document.shot, id);
      return cue && at ? estimate(shot, cue, at, noise) : 0;
    };
    const rules = positionOf(store, engine)?.rules ?? null;
    const objective = rules === null ? null : engine.gameFacts[rules]!.objective;
    const easiest =
      objective === "lowest-first"
        ? all
        : [...all]
            .sort((a, b) => ease(b) - ease(a))
            .filter((id, k) => k < CONSIDERED || wanted.includes(id));
    const orders = ordersOf(easiest, wanted, objective);
    const length = orders[0]?.length ?? 0;
    if (length === 0) return null;
    return { kind: "plan", shot: JSON.stringify(document.shot), orders, length, noise, runs: RUNS };
  }

  function legItem(leg: Leg): HTMLElement {
    const { ball, pocket, strike, chance } = leg;
    const show = () => {
      const outline = ellipseAround(leg.stops);
      showShot(store, engine.shot(leg.shot), outline ? [{ outline, color: STOP }] : []);
    };
    const names = { ball: ballName(ball), pocket: pocketName(pocket) };
    return h(
      "li",
      {},
      resultButton(
        store,
        { take: () => store.apply({ shot: leg.shot }, t("change.plan", names)), show },
        h(
          "span",
          { class: "said" },
          h("strong", {}, capital(t("lines.pot", names))),
          h("span", { class: "hint" }, strikeText(strike)),
          h(
            "span",
            { class: "facts" },
            h("span", {}, `${t("lines.pot-chance")} `, h("b", {}, percent(chance))),
          ),
        ),
      ),
    );
  }

  store.subscribe((now, before) => {
    const isSame =
      now.document.shot.balls === before.document.shot.balls &&
      now.document.game === before.document.game &&
      now.document.noise === before.document.noise &&
      now.session.analysis.level === before.session.analysis.level;
    if (!isSame) clear();
  });
  clear();
}

/** The balls of the layout that can be potted, by their ids. */
function objectBalls({ shot, document }: Store): readonly string[] {
  const balls: readonly BallInfo[] = shot.geometry.pockets.length > 0 ? shot.balls : [];
  return balls.map(({ id }) => id).filter((id) => id !== document.shot.strike.ball);
}

/** Fills a list with balls and an entry for none; a ball that is gone is no longer chosen. */
function fill(select: HTMLSelectElement, balls: readonly string[], none: string): void {
  const { value } = select;
  if (select.dataset.balls !== balls.join()) {
    select.dataset.balls = balls.join();
    select.replaceChildren(
      h("option", { value: "" }, none),
      ...balls.map((id) => h("option", { value: id }, capital(ballName(id)))),
    );
  }
  select.value = balls.includes(value) ? value : "";
}
