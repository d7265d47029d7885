/** The Share dialog, and the button that opens files. */

import "./menu.css";
import type { Engine } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { type Child, h, icon, setText, uniqueId } from "../common/dom.ts";
import type { Store } from "../document/store.ts";
import { link } from "./address.ts";
import { copy } from "./clipboard.ts";
import { download } from "./download.ts";
import { mountDrop, openButton } from "./files.ts";
import { filmSection } from "./film.ts";
import { toPrettyJson } from "./literal.ts";
import { pythonProgram } from "./python.ts";
import { t } from "../words/translate.ts";

const SHARE_ICON = "M12 15V4M8 7.5 12 4l4 3.5M5 12v7h14v-7";

export function mountShare(root: HTMLElement, store: Store, context: Context): void {
  const title = h("h2", { id: uniqueId("share") }, t("share.title"));
  const dialog = h("dialog", { id: "share-dialog", "aria-labelledby": title.id });
  const close = action(t("share.close"), "close-share", () => dialog.close());
  const copier = mountCopier();
  const linkPart = mountLink(store, context.engine, copier.copy);
  const shotText = (): string => `${toPrettyJson(store.shot.file)}\n`;
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
    filmSection(store, context),
    copier.root,
  );
  document.body.append(dialog);

  const open = (): void => {
    linkPart.refresh();
    copier.clear();
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
    h("span", { class: "wide-only" }, t("share.share")),
  );
  root.append(openButton(store, context), share);
  mountDrop(store, context);
}

function mountLink(
  store: Store,
  engine: Engine,
  copyText: (text: string, done: string) => Promise<void>,
): { section: HTMLElement; refresh: () => void } {
  const address = h("input", { type: "text", readonly: true, id: uniqueId("link") });
  address.addEventListener("focus", () => address.select());
  const label = h("label", { for: address.id, class: "unseen" }, t("share.link"));
  const button = action(t("share.copy-link"), "copy-link", () =>
    copyText(address.value, t("share.link-copied")),
  );
  const none = h("p", { class: "hint" }, t("share.no-link"));
  return {
    section: section(t("share.link-heading"), label, address, button, none),
    refresh: () => {
      const here = link(store, engine);
      address.value = here ?? "";
      address.hidden = button.hidden = here === null;
      none.hidden = here !== null;
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
  const trace = store.session.trace ?? store.ghost.trace;
  if (!trace) return store.ghost.error ?? t("share.no-trace");
  download(`${trace.json()}\n`, "trace.json");
  return t("share.trace-downloaded");
}
