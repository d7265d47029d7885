/** The Layout tab: racks, the table, and the position of each ball. */

import type { Context } from "../common/context.ts";
import { mountPhoto } from "../../photo/index.ts";
import { h, uniqueId } from "../common/dom.ts";
import { swatch } from "../common/swatch.ts";
import { mountField } from "../form/field.ts";
import { addBall, nextId, placeBall, rack, removeBall } from "../document/layout-changes.ts";
import { photoOptions } from "./layout-from-photo.ts";
import { aimAt } from "../document/strike-changes.ts";
import type { Store } from "../document/store.ts";
import { mountTable } from "./table-controls.ts";
import { middleInView } from "./ball-drag.ts";
import { mountTray } from "./ball-tray.ts";
import { gameName } from "../common/preset-names.ts";
import { ballName, shortName } from "../common/shot-words.ts";
import { language, t } from "../words/translate.ts";

/** Seeds drawn by the page are below this: short numbers are easy to pass on. */
const SEEDS = 10_000;

export function mountLayoutPanel(root: HTMLElement, store: Store, context: Context): void {
  const tray = h("section");
  root.append(tray);
  mountTray(tray, store, context);
  mountBalls(root, store, context);
  mountRacks(root, store, context);
  mountPhoto(root, photoOptions(store, context), language());
  mountTable(root, store, context);
}

function option(value: string, text = value): HTMLOptionElement {
  return h("option", { value }, text);
}

/** A select or input with its label above it. */
function labelled(label: string, control: HTMLElement): HTMLElement {
  control.id = uniqueId("control");
  return h("div", { class: "labelled" }, h("label", { for: control.id }, label), control);
}

function mountRacks(root: HTMLElement, store: Store, { engine }: Context): void {
  const game = h("select", {}, ...engine.games.map((name) => option(name, gameName(name))));
  const seed = h("input", { type: "number", min: 0, step: 1, value: store.document.seed });
  const set = () => {
    const value = Number(seed.value);
    if (seed.value.trim() === "" || !Number.isSafeInteger(value) || value < 0) {
      store.refuse(t("field.not-a-seed"));
    } else rack(store, engine, game.value, value);
  };
  const shuffle = () => {
    seed.value = String(Math.floor(Math.random() * SEEDS));
    set();
  };
  root.append(
    h("h2", {}, t("layout.rack")),
    h("div", { class: "pair" }, labelled(t("layout.game"), game), labelled(t("layout.seed"), seed)),
    h(
      "div",
      { class: "row" },
      h("button", { type: "button", class: "button", onclick: set }, t("layout.rack")),
      h("button", { type: "button", class: "button", onclick: shuffle }, t("layout.shuffle")),
    ),
  );
  store.subscribe((now, before) => {
    if (now.document.seed !== before.document.seed) seed.value = String(now.document.seed);
  });
}

function mountBalls(root: HTMLElement, store: Store, context: Context): void {
  const list = h("div", { class: "balls", role: "radiogroup", "aria-label": t("layout.selected") });
  const name = h("input", { type: "text", size: 8, autocomplete: "off" });
  const add = h("button", { type: "button", class: "button" }, t("layout.add"));
  add.addEventListener("click", () => {
    if (addBall(store, context.engine, name.value, middleInView(context)))
      name.value = nextId(store.document.shot.balls);
  });
  const fields = h("div");
  root.append(
    h("h2", {}, t("layout.balls")),
    h("p", { class: "hint" }, t("layout.balls-hint")),
    list,
    fields,
    h("div", { class: "row add" }, labelled(t("layout.new-ball"), name), add),
  );
  mountSelected(fields, store, context);

  let shown = "";
  function show(): void {
    const { balls, strike } = store.document.shot;
    const { selected } = store.session;
    const ids = balls.map((ball) => ball.id);
    const key = JSON.stringify([ids, strike.ball, selected]);
    if (key === shown) return;
    shown = key;
    const focused = list.contains(document.activeElement);
    const current = selected !== null && ids.includes(selected) ? selected : ids[0];
    list.replaceChildren(
      ...ids.map((id, index) =>
        h(
          "button",
          {
            type: "button",
            class: "button chip",
            role: "radio",
            "aria-checked": String(id === selected),
            "aria-label":
              id === strike.ball ? t("layout.struck", { ball: shortName(id) }) : shortName(id),
            tabindex: id === current ? 0 : -1,
            onclick: () => {
              store.setSession({ selected: id });
            },
          },
          swatch(id, index),
          shortName(id),
        ),
      ),
    );
    if (focused) list.querySelector<HTMLElement>('[tabindex="0"]')?.focus();
    if (!ids.includes(name.value) && name.value !== "") return;
    name.value = nextId(balls);
  }
  list.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: -1, ArrowUp: -1, ArrowRight: 1, ArrowDown: 1 }[event.key];
    if (step === undefined) return;
    const ids = store.document.shot.balls.map((ball) => ball.id);
    const at = ids.indexOf(store.session.selected ?? ids[0]!);
    store.setSession({ selected: ids[(at + step + ids.length) % ids.length]! });
    event.preventDefault();
  });
  store.subscribe(show);
  show();
}

function mountSelected(root: HTMLElement, store: Store, context: Context): void {
  const selected = () => store.shot.balls.find((ball) => ball.id === store.session.selected);
  const axis = (label: string, index: 0 | 1) => {
    mountField(root, store, context, {
      label,
      unit: "m",
      spoken: t("unit.metres"),
      digits: 4,
      step: 0.001,
      slider: { min: () => 0, max: () => store.shot.geometry.size?.[index] ?? 1 },
      read: () => selected()?.position[index] ?? 0,
      write: (value, group) => {
        const ball = selected();
        if (!ball) return false;
        const [x, y] = ball.position;
        return placeBall(store, ball.id, index === 0 ? [value, y] : [x, value], group);
      },
    });
  };
  axis(t("layout.across"), 0);
  axis(t("layout.along"), 1);
  const act = (text: string, action: (id: string) => void) =>
    h(
      "button",
      {
        type: "button",
        class: "button",
        onclick: () => {
          const ball = selected();
          if (ball) action(ball.id);
        },
      },
      text,
    );
  const strike = act(t("layout.strike"), (id) =>
    store.strike({ ball: id }, t("change.strike", { ball: ballName(id) })),
  );
  const target = act(t("layout.aim-at"), (id) => {
    aimAt(store, id);
  });
  const remove = act(t("layout.remove"), (id) => removeBall(store, id));
  root.append(h("div", { class: "row" }, target, strike, remove));
  const show = () => {
    const id = selected()?.id;
    root.hidden = id === undefined;
    const struck = id === store.document.shot.strike.ball;
    strike.disabled = struck;
    target.disabled = struck;
  };
  store.subscribe(show);
  show();
}
