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

const SHARE_ICON = "M12 15V4M8 7.5 12 4l4 3.5M5 12v7h14v-7";

export function mountShare(root: HTMLElement, store: Store, context: Context): void {
  const title = h("h2", { id: uniqueId("share") }, "Share this shot");
  const dialog = h("dialog", { id: "share-dialog", "aria-labelledby": title.id });
  const close = action("Close", "close-share", () => dialog.close());
  const copier = mountCopier();
  const linkPart = mountLink(store, context.engine, copier.copy);
  const shotText = (): string => `${toPrettyJson(store.shot.file)}\n`;
  dialog.append(
    h("div", { class: "head" }, title, close),
    linkPart.section,
    section(
      "Files",
      action("Copy as Python", "copy-python", () =>
        copier.copy(pythonProgram(store.shot.file), "Python program"),
      ),
      action("Copy shot file", "copy-shot", () => copier.copy(shotText(), "Shot file")),
      action("Download shot file", "download-shot", () => download(shotText(), "shot.json")),
      action("Download trace", "download-trace", () => copier.say(downloadTrace(store))),
    ),
    section(
      "Picture of the table as you see it",
      action("Download PNG", "download-png", async () => {
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
    { type: "button", class: "button", id: "share-button", "aria-label": "Share", onclick: open },
    icon(SHARE_ICON),
    h("span", { class: "wide-only" }, "Share"),
  );
  root.append(openButton(store, context), share);
  mountDrop(store, context);
}

function mountLink(
  store: Store,
  engine: Engine,
  copyText: (text: string, what: string) => Promise<void>,
): { section: HTMLElement; refresh: () => void } {
  const address = h("input", { type: "text", readonly: true, id: uniqueId("link") });
  address.addEventListener("focus", () => address.select());
  const label = h("label", { for: address.id, class: "unseen" }, "Link");
  const button = action("Copy link", "copy-link", () => copyText(address.value, "Link"));
  const none = h(
    "p",
    { class: "hint" },
    "In a frame of another page there is no link: copy the shot file instead.",
  );
  return {
    section: section("Link with everything on this page", label, address, button, none),
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
  copy: (text: string, what: string) => Promise<void>;
  say: (sentence: string) => void;
  clear: () => void;
}

/** Copies text and confirms it; if the browser forbids copying, shows the text selected. */
function mountCopier(): Copier {
  const said = h("p", { class: "said", role: "status" });
  const text = h("textarea", { readonly: true, rows: 8, "aria-label": "Text to copy" });
  const say = (sentence: string): void => {
    setText(said, sentence);
    text.hidden = true;
  };
  return {
    root: h("div", {}, said, text),
    say,
    clear: () => say(""),
    copy: async (content, what) => {
      if (await copy(content)) {
        say(`${what} copied.`);
        return;
      }
      say("The browser does not allow this page to copy. Here is the text, selected:");
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
  if (!trace)
    return store.ghost.error ?? "This shot has no trace: change it until it can be played.";
  download(`${trace.json()}\n`, "trace.json");
  return "Trace downloaded.";
}
