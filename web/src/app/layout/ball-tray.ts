/** The balls that are not on the table: they are dragged onto it, or put on it by a click. */

import { trayOf } from "../../photo/index.ts";
import type { Context } from "../common/context.ts";
import { h } from "../common/dom.ts";
import { ballName, shortName } from "../common/shot-words.ts";
import { addBall } from "../document/layout-changes.ts";
import type { Store } from "../document/store.ts";
import { t } from "../words/translate.ts";
import { dragBall, dropBall, isBeside, middleInView } from "./ball-drag.ts";
import { swatch } from "../common/swatch.ts";

/** Movement (CSS pixels) from which a press is a drag. */
const DRAG = 6;

let drags = 0;

export function mountTray(root: HTMLElement, store: Store, context: Context): void {
  const list = h("div", { class: "balls", role: "group", "aria-label": t("layout.tray") });
  const hint = h("p", { class: "hint" }, t("layout.tray-hint"));
  root.append(h("h2", {}, t("layout.tray")), hint, list);
  let set: readonly string[] = [];
  let table: unknown = null;
  let shown = "";
  const show = (): void => {
    const { shot } = store.document;
    const key = JSON.stringify([shot.table, shot.physics]);
    if (key !== table) set = trayOf(context.engine, store.shot.geometry);
    table = key;
    const there = new Set(shot.balls.map(({ id }) => id));
    const missing = set.filter((id) => !there.has(id));
    if (missing.join() === shown) return;
    shown = missing.join();
    root.hidden = missing.length === 0;
    // The pressed ball disappears; the focus goes to the one that takes its place.
    const at = [...list.children].indexOf(document.activeElement!);
    list.replaceChildren(...missing.map((id) => ball(id, set.indexOf(id), store, context)));
    if (at >= 0)
      list
        .querySelectorAll("button")
        .item(Math.min(at, missing.length - 1))
        .focus();
  };
  store.subscribe((now, before) => {
    if (now.document.shot !== before.document.shot) show();
  });
  show();
}

function ball(id: string, index: number, store: Store, context: Context): HTMLButtonElement {
  const chip = h(
    "button",
    {
      type: "button",
      class: "button chip",
      "aria-label": t("layout.put", { ball: ballName(id) }),
    },
    swatch(id, index),
    shortName(id),
  );
  // The browser looks at it when a finger touches the chip: later it would scroll the panel.
  chip.style.touchAction = "none";
  const click = (): void => {
    addBall(store, context.engine, id, middleInView(context));
  };
  chip.addEventListener("click", click);
  chip.addEventListener("pointerdown", (event) => {
    if (event.button === 0) follow(chip, event, { id, store, context, click });
  });
  return chip;
}

interface Held {
  readonly id: string;
  readonly store: Store;
  readonly context: Context;
  readonly click: () => void;
}

/** Follows the pointer until it is released. The chip leaves the page once the ball is on the table. */
function follow(chip: HTMLElement, press: PointerEvent, held: Held): void {
  const { id, store, context, click } = held;
  drags += 1;
  const group = `tray ${drags}`;
  const end = new AbortController();
  // The chip leaves the page once its ball is on the table.
  const sheet = chip.closest<HTMLElement>(".drawer");
  let dragged = false;
  const onTable = () => store.document.shot.balls.some((one) => one.id === id);
  const target = (event: PointerEvent) => {
    const over = document.elementFromPoint(event.clientX, event.clientY)?.id === "table";
    const { point } = context.viewer.pick(event.clientX, event.clientY, event.pointerType);
    return over && point && !isBeside(store, point) ? point : null;
  };
  const move = (event: PointerEvent): void => {
    const away = Math.hypot(event.clientX - press.clientX, event.clientY - press.clientY);
    if (!dragged && away < DRAG) return;
    if (!dragged) chip.removeEventListener("click", click);
    dragged = true;
    // A sheet steps aside for the part of the table below it.
    if (sheet) sheet.dataset.drag = "tray";
    const point = target(event);
    if (!point) return;
    if (onTable()) dragBall(store, id, point, group);
    else dropBall(store, id, point, group);
  };
  const release = (event: PointerEvent): void => {
    end.abort();
    context.loop.flush();
    store.settle();
    if (dragged && onTable() && (event.type === "pointercancel" || !target(event))) store.undo();
    delete sheet?.dataset.drag;
    // The click of a drag that ends on the chip comes after this.
    setTimeout(() => {
      if (dragged) chip.addEventListener("click", click);
    });
  };
  const { signal } = end;
  // The chip does not capture the pointer: it leaves the page.
  window.addEventListener(
    "pointermove",
    (event) => {
      if (event.pointerId === press.pointerId) context.loop.input("tray", () => move(event));
    },
    { signal },
  );
  for (const type of ["pointerup", "pointercancel"] as const) {
    window.addEventListener(
      type,
      (event) => {
        if (event.pointerId === press.pointerId) release(event);
      },
      { signal },
    );
  }
}
