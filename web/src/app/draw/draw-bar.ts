/** The tools for drawing, below the table while one draws, and the button that begins. */

import "./draw-bar.css";
import type { MarkColor } from "../../engine/index.ts";
import { MARK_COLORS } from "../../viewer/index.ts";
import { button, h, icon, setText, uniqueId } from "../common/dom.ts";
import {
  COLORS,
  type Drawing,
  type DrawTool,
  LONGEST_LABEL,
  marksOf,
  TOOLS,
} from "../document/marks.ts";
import type { Store } from "../document/store.ts";
import { t } from "../words/translate.ts";
import { mountChoice } from "../common/choice-row.ts";
import { changeOf, draw } from "./draw-changes.ts";
import { beginDrawing, canDraw, endDrawing } from "./draw-mode.ts";
import { markInWords } from "./mark-words.ts";

const ICONS: Readonly<Record<DrawTool | "pencil", string>> = {
  line: "M5 19L19 5",
  arrow: "M5 19L19 5M19 5h-7M19 5v7",
  circle: "M12 4a8 8 0 1 0 .01 0",
  area: "M5 7h14v10H5z",
  label: "M6 6h12M12 6v13",
  erase: "M9 19h11M5 14l8-8 6 6-7 7H9z",
  pencil: "M4 20l1-5L16 4l4 4L9 19zM14 6l4 4",
};

/** @param tool The place of the button that begins. */
export function mountDrawBar(root: HTMLElement, tool: HTMLElement, store: Store): void {
  const begin = iconButton("pencil", t("draw.begin"));
  begin.id = "draw-button";
  begin.addEventListener("click", () => {
    if (store.session.drawing) endDrawing(store);
    else beginDrawing(store);
  });
  tool.append(begin);
  const patch = (change: Partial<Drawing>) => {
    const { drawing } = store.session;
    if (drawing) store.setSession({ drawing: { ...drawing, ...change } });
  };
  const showTool = chooser(
    root,
    t("draw.tools"),
    TOOLS.map((name) => ({ name, button: iconButton(name, t(`draw.${name}`)) })),
    (name) => patch({ tool: name, start: null }),
  );
  const first = root.lastElementChild!;
  const showColor = chooser(
    root,
    t("draw.colors"),
    COLORS.map((name) => ({ name, button: colorButton(name) })),
    (color) => patch({ color }),
  );
  const text = textField((value) => patch({ text: value }));
  const { list, show: showList } = markList(store);
  const done = button(t("draw.end"), () => endDrawing(store), "primary");
  done.classList.add("done");
  done.dataset.back = "";
  const hint = h("p", { class: "hint" });
  root.replaceChildren(
    h("div", { class: "row" }, first, root.lastElementChild),
    h("div", { class: "row" }, text, list, hint, done),
  );
  const show = (): void => {
    const { drawing } = store.session;
    begin.hidden = !canDraw(store);
    begin.setAttribute("aria-pressed", String(drawing !== null));
    document.body.toggleAttribute("data-drawing", drawing !== null);
    if (!drawing) return;
    showTool(drawing.tool);
    showColor(drawing.color);
    text.hidden = drawing.tool !== "label";
    list.hidden = drawing.tool !== "erase";
    setText(hint, t(`draw.hint-${hintOf(drawing.tool)}`));
    showList();
  };
  store.subscribe((now, before) => {
    const isSame = now.session === before.session && now.document.shot === before.document.shot;
    if (!isSame) show();
  });
  show();
}

function hintOf(tool: DrawTool): "drag" | "label" | "erase" {
  return tool === "label" || tool === "erase" ? tool : "drag";
}

function chooser<Name extends string>(
  root: HTMLElement,
  name: string,
  choices: readonly { readonly name: Name; readonly button: HTMLButtonElement }[],
  choose: (name: Name) => void,
): (chosen: Name) => void {
  const row = h("div", { class: "group", role: "radiogroup", "aria-label": name });
  root.append(row);
  return mountChoice(row, choices, choose);
}

function iconButton(name: keyof typeof ICONS, label: string): HTMLButtonElement {
  const attributes = { type: "button", class: "button plain", "aria-label": label, title: label };
  return h("button", attributes, icon(ICONS[name]));
}

function colorButton(color: MarkColor): HTMLButtonElement {
  const label = t(`draw.${color}`);
  const attributes = { type: "button", class: "button plain", "aria-label": label, title: label };
  const dot = h("span", { class: "color" });
  dot.style.background = MARK_COLORS[color];
  return h("button", attributes, dot);
}

function textField(write: (text: string) => void): HTMLInputElement {
  const attributes = { type: "text", maxlength: LONGEST_LABEL, "aria-label": t("draw.text") };
  const field = h("input", { ...attributes, placeholder: t("draw.text") });
  field.addEventListener("input", () => write(field.value));
  return field;
}

/** The marks by name, which the keyboard and screen readers can remove one by one. */
function markList(store: Store): { readonly list: HTMLElement; readonly show: () => void } {
  const select = h("select", { id: uniqueId("mark"), "aria-label": t("draw.marks") });
  const remove = button(t("draw.remove"), () => {
    const at = Number(select.value);
    const marks = marksOf(store.document.shot);
    draw(
      store,
      marks.filter((_, k) => k !== at),
      changeOf("erase"),
    );
  });
  const clear = button(t("draw.clear"), () => draw(store, [], t("change.draw-clear")));
  let shown: unknown = null;
  const show = (): void => {
    const marks = marksOf(store.document.shot);
    remove.disabled = clear.disabled = select.disabled = marks.length === 0;
    if (marks === shown) return;
    shown = marks;
    const options = marks.map((mark, k) =>
      h("option", { value: k }, `${k + 1}. ${markInWords(mark)}`),
    );
    select.replaceChildren(...(options.length > 0 ? options : [h("option", {}, t("draw.none"))]));
    select.selectedIndex = Math.max(0, marks.length - 1);
  };
  return { list: h("div", { class: "row" }, select, remove, clear), show };
}
