/** The Share dialog, and the button that opens files. */

import "./share-menu.css";
import type { Engine, FrameRecord, ShotFile } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { type Child, h, icon, setText, uniqueId } from "../common/dom.ts";
import { plainRecordOf, recordOf } from "../game/game-record.ts";
import { filmOf } from "../document/filmed.ts";
import type { Store } from "../document/store.ts";
import { isLocal, link, linkText, ownHost } from "./address.ts";
import { copy } from "./clipboard.ts";
import { download } from "./download.ts";
import { mountDrop, openButton, type Opener } from "./open-files.ts";
import { diagramSection } from "./diagram-section.ts";
import { filmSection } from "./film.ts";
import { mountPrint } from "../diagram/print-diagram.ts";
import { toPrettyJson } from "./literal.ts";
import { gameProgram, pythonProgram } from "./python.ts";
import { t } from "../words/translate.ts";

const SHARE_ICON = "M12 15V4M8 7.5 12 4l4 3.5M5 12v7h14v-7";

/** @param other Opens files of another part of the page. */
export function mountShare(root: HTMLElement, store: Store, context: Context, other: Opener): void {
  const title = h("h2", { id: uniqueId("share") }, t("share.title"));
  const dialog = h("dialog", { id: "share-dialog", "aria-labelledby": title.id });
  const close = action(t("share.close"), "close-share", () => dialog.close());
  const copier = mountCopier();
  const linkPart = mountLink(store, context.engine, copier.copy);
  const shotText = (): string => `${toPrettyJson(filmedShot(store))}\n`;
  dialog.append(
    h("div", { class: "head" }, title, close),
    linkPart.section,
    section(
      t("share.files"),
      action(t("share.python"), "copy-python", () =>
        copier.copy(pythonProgram(store.shot.file), t("share.python-copied")),
      ),
      action(t("share.copy-shot"), "copy-shot", () =>
        copier.copy(shotText(), t("share.shot-copied")),
      ),
      action(t("share.download-shot"), "download-shot", () => download(shotText(), "shot.json")),
      action(t("share.download-trace"), "download-trace", () => copier.say(downloadTrace(store))),
    ),
    section(
      t("share.picture"),
      action(t("share.png"), "download-png", async () => {
        download(await context.viewer.capture(), "carom.png");
      }),
    ),
    diagramSection(store, copier.say),
    filmSection(store, context),
    copier.root,
  );
  document.body.append(dialog);
  // The shot of a game is a part of it; the game as a whole is its record.
  const record = (): FrameRecord => recordOf(context.engine, store.document.game!);
  const ofGame = h(
    "div",
    { class: "row", id: "share-game" },
    action(t("share.game-python"), "copy-game-python", () =>
      copier.copy(
        gameProgram(plainRecordOf(context.engine, store.document.game!)),
        t("share.game-copied"),
      ),
    ),
    action(t("share.record"), "download-record", () =>
      download(`${toPrettyJson(record())}\n`, "frame.json"),
    ),
  );
  dialog.querySelector("#copy-python")!.closest("section")!.append(ofGame);

  const open = (): void => {
    linkPart.refresh();
    copier.clear();
    ofGame.hidden = store.document.game === null;
    dialog.showModal();
  };
  const share = h(
    "button",
    {
      type: "button",
      class: "button",
      id: "share-button",
      "aria-label": t("share.share"),
      onclick: open,
    },
    icon(SHARE_ICON),
    h("span", {}, t("share.share")),
  );
  root.append(openButton(store, context, other), share);
  mountDrop(store, context, other);
  mountPrint(store, context);
}

/** The shot file, with what a camera saw of it. */
function filmedShot(store: Store): ShotFile {
  const film = filmOf(store.document);
  return { ...store.shot.file, ...(film.length > 0 && { track: film }) };
}

function mountLink(
  store: Store,
  engine: Engine,
  copyText: (text: string, done: string) => Promise<void>,
): { section: HTMLElement; refresh: () => void } {
  const local = isLocal();
  const address = h("input", { type: "text", readonly: true, id: uniqueId("link") });
  address.addEventListener("focus", () => address.select());
  const name = t(local ? "share.link-text" : "share.link");
  const label = h("label", { for: address.id, class: "unseen" }, name);
  const button = local
    ? action(t("share.copy-text"), "copy-link", () =>
        copyText(address.value, t("share.text-copied")),
      )
    : action(t("share.copy-link"), "copy-link", () =>
        copyText(address.value, t("share.link-copied")),
      );
  const save = action(t("share.save-text"), "save-link", () =>
    download(`${address.value}\n`, "carom.txt"),
  );
  const none = h("p", { class: "hint" }, t(local ? "share.local" : "share.no-link"));
  const host = ownHost();
  const here = host !== null && h("p", { class: "hint" }, t("share.here", { host }));
  const noFilm = h("p", { class: "hint", id: "link-without-film" }, t("share.no-film"));
  return {
    section: section(
      t("share.link-heading"),
      label,
      address,
      button,
      local && save,
      none,
      noFilm,
      here,
    ),
    refresh: () => {
      const text = local ? linkText(store, engine) : link(store, engine);
      address.value = text ?? "";
      address.hidden = button.hidden = text === null;
      none.hidden = text !== null && !local;
      noFilm.hidden = text === null || filmOf(store.document).length === 0;
    },
  };
}

interface Copier {
  root: HTMLElement;
  /** Copies a text; `done` is the sentence that confirms it. */
  copy: (text: string, done: string) => Promise<void>;
  say: (sentence: string) => void;
  clear: () => void;
}

/** Copies text and confirms it; if the browser forbids copying, shows the text selected. */
function mountCopier(): Copier {
  const said = h("p", { class: "said", role: "status" });
  const text = h("textarea", { readonly: true, rows: 8, "aria-label": t("share.text") });
  const say = (sentence: string): void => {
    setText(said, sentence);
    text.hidden = true;
  };
  return {
    root: h("div", {}, said, text),
    say,
    clear: () => say(""),
    copy: async (content, done) => {
      if (await copy(content)) {
        say(done);
        return;
      }
      say(t("share.not-allowed"));
      text.hidden = false;
      text.value = content;
      text.focus();
      text.select();
    },
  };
}

function section(heading: string, ...children: Child[]): HTMLElement {
  return h("section", {}, h("h3", {}, heading), h("div", { class: "row" }, ...children));
}

function action(label: string, id: string, run: () => unknown): HTMLButtonElement {
  return h("button", { type: "button", class: "button", id, onclick: () => void run() }, label);
}

/** @returns The message to show. */
function downloadTrace(store: Store): string {
  const trace = store.session.replay.trace ?? store.ghost.trace;
  if (!trace) return store.ghost.error ?? t("share.no-trace");
  download(`${trace.json()}\n`, "trace.json");
  return t("share.trace-downloaded");
}
