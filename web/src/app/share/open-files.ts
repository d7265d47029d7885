/** Opens files that are chosen or dropped on the page. */

import type { FrameRecord } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { h, icon } from "../common/dom.ts";
import { openTree } from "../analyse/tree-panel.ts";
import { isTreeText } from "../document/tree-text.ts";
import { gameOfRecord } from "../game/game-record.ts";
import { isMatchText } from "../game/recorded/match-game.ts";
import { openMatch } from "../game/recorded/match-list.ts";
import { cannotOpen, readFile } from "../document/shot-file.ts";
import type { Store } from "../document/store.ts";
import { replay } from "../replay/replay-control.ts";
import { openText } from "./address.ts";
import { linkIn } from "./link.ts";
import { decimal, t } from "../words/translate.ts";

/** The largest file that is read, bytes: ten times the longest trace of a break. */
const LARGEST = 50e6;

const OPEN_ICON = "M4 19V6h5l2 2h9v11zM4 11h16";

/** Opens a text that is a file of another part of the page; null if it is none. */
export type Opener = (file: {
  readonly name: string;
  readonly text: string;
}) => Promise<void> | null;

/**
 * Opens a shot file, a trace, a file with the text of a link, or one that `other` opens. A file that cannot be
 * opened changes nothing.
 */
export async function openFile(
  file: File,
  store: Store,
  context: Context,
  other: Opener,
): Promise<void> {
  if (file.size > LARGEST) {
    store.refuse(t("open.too-large", { file: file.name, megabytes: decimal(file.size / 1e6, 0) }));
    return;
  }
  let text: string;
  try {
    text = await file.text();
  } catch {
    store.refuse(t("open.unreadable", { file: file.name }));
    return;
  }
  const link = linkIn(text);
  if (link !== null) {
    await openText(store, context, link);
    return;
  }
  const opening = other({ name: file.name, text });
  if (opening) await opening;
  else if (await open(store, context, text))
    context.announce(t("open.opened", { file: file.name }));
}

/**
 * Opens a shot file or a trace, the record of a game or of a match, or the shots of an analysis. A refused
 * file leaves everything as it is.
 */
async function open(store: Store, context: Context, text: string): Promise<boolean> {
  const { engine } = context;
  try {
    if (isMatchText(text)) return await openMatch(store, context, text);
    if (isTreeText(text)) return await openTree(store, engine, text);
    const record = recordIn(text);
    if (record) {
      const game = await store.open(gameOfRecord(engine, record));
      return game !== null && store.apply(game, t("change.open-record"));
    }
    const { shot, trace, filmed } = readFile(engine, text);
    const opened = store.apply(
      { shot, game: null, filmed },
      t(trace ? "change.open-trace" : "change.open-shot"),
    );
    if (opened && trace) replay(store, trace, 0, false);
    return opened;
  } catch (error) {
    store.refuse(cannotOpen(error, text));
    return false;
  }
}

/** The record of a frame in a text; null if it is another file. */
function recordIn(json: string): FrameRecord | null {
  const file = JSON.parse(json) as Partial<FrameRecord> | null;
  return file?.format === "carom-frame/1" ? (file as FrameRecord) : null;
}

/** The button that opens a file. */
export function openButton(store: Store, context: Context, other: Opener): HTMLElement {
  const input = h("input", {
    type: "file",
    accept: ".json,.jsonl,.txt,application/json,application/jsonl,text/plain",
    hidden: true,
    "aria-label": t("open.file"),
    id: "open-file",
  });
  input.addEventListener("change", () => {
    const file = input.files?.[0];
    input.value = ""; // the same file can be chosen again
    if (file) void openFile(file, store, context, other);
  });
  const button = h(
    "button",
    {
      type: "button",
      class: "button",
      id: "open",
      "aria-label": t("open.open"),
      onclick: () => input.click(),
    },
    icon(OPEN_ICON),
    h("span", {}, t("open.open")),
  );
  button.title = t("open.hint");
  return h("span", {}, button, input);
}

/** Opens files that are dropped on the page. */
export function mountDrop(store: Store, context: Context, other: Opener): void {
  const veil = h("div", { class: "drop", hidden: true, "aria-hidden": "true" }, t("open.drop"));
  document.body.append(veil);
  const hasFile = (event: DragEvent): boolean => !!event.dataTransfer?.types.includes("Files");
  addEventListener("dragover", (event) => {
    if (!hasFile(event)) return;
    event.preventDefault();
    veil.hidden = false;
  });
  addEventListener("dragleave", (event) => {
    if (!event.relatedTarget) veil.hidden = true; // left the window
  });
  addEventListener("drop", (event) => {
    veil.hidden = true;
    if (!hasFile(event)) return;
    event.preventDefault();
    const files = event.dataTransfer?.files ?? [];
    if (files.length > 1) store.refuse(t("open.one"));
    else if (files[0]) void openFile(files[0], store, context, other);
  });
}
