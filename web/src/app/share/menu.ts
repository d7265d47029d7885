/** Everything that takes a shot out of the page, and the button that opens one. */

import "./menu.css";
import type { Context } from "../context.ts";
import { h, icon, uniqueId } from "../dom.ts";
import type { Store } from "../store.ts";
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
  const address = h("input", { type: "text", readonly: true, id: uniqueId("link") });
  const noAddress = h(
    "p",
    { class: "hint" },
    "Inside another page there is no address to share: copy the shot file instead.",
  );
  const dialog = h("dialog", { id: "share-dialog", "aria-labelledby": title.id });
  const copyButton = (label: string, what: string, text: () => string | null, id: string) =>
    action(label, id, async () => {
      const content = text();
      if (content === null) return;
      const done = await copy(content);
      context.announce(
        done ? `${what} copied.` : "The browser does not let the page copy: select the text.",
      );
    });
  const linkRow = h(
    "div",
    { class: "row" },
    h("label", { for: address.id, class: "unseen" }, "Link"),
    address,
    copyButton("Copy link", "Link", () => link(store), "copy-link"),
  );
  const shotText = (): string => `${toPrettyJson(store.shot.file)}\n`;
  dialog.append(
    h(
      "div",
      { class: "head" },
      title,
      action("Close", "close-share", () => dialog.close()),
    ),
    h("section", {}, h("h3", {}, "Link with everything on this page"), linkRow, noAddress),
    h(
      "section",
      {},
      h("h3", {}, "Files"),
      h(
        "div",
        { class: "row" },
        copyButton(
          "Copy as Python",
          "Python program",
          () => pythonProgram(store.shot.file),
          "copy-python",
        ),
        copyButton("Copy shot file", "Shot file", shotText, "copy-shot"),
        action("Download shot file", "download-shot", () => download(shotText(), "shot.json")),
        action("Download trace", "download-trace", () => downloadTrace(store)),
      ),
    ),
    h(
      "section",
      {},
      h("h3", {}, "Picture of the table as you see it"),
      action("Download PNG", "download-png", async () => {
        download(await context.viewer.capture(), "carom.png");
      }),
    ),
    filmSection(store, context),
  );
  document.body.append(dialog);
  address.addEventListener("focus", () => address.select());

  const open = (): void => {
    const here = link(store);
    linkRow.hidden = here === null;
    noAddress.hidden = here !== null;
    address.value = here ?? "";
    dialog.showModal();
  };
  const share = h(
    "button",
    { type: "button", class: "button", id: "share-button", onclick: open },
    icon(SHARE_ICON),
    "Share",
  );
  root.append(openButton(store, context), share);
  mountDrop(store, context);
}

function action(label: string, id: string, run: () => unknown): HTMLButtonElement {
  return h("button", { type: "button", class: "button", id, onclick: () => void run() }, label);
}

function downloadTrace(store: Store): void {
  const trace = store.session.trace ?? store.ghost.trace;
  if (trace) download(`${trace.json()}\n`, "trace.json");
  else store.refuse(store.ghost.error ?? "There is no trace of this shot.");
}
