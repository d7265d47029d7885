/** Below the table when a friend is to play: the link that sends the move. */

import type { Context } from "../common/context.ts";
import { button, h, setText } from "../common/dom.ts";
import type { Store } from "../document/store.ts";
import { standing, waitsForFriend } from "../game/awaited-turn.ts";
import { other } from "../game/game-words.ts";
import { isLocal, link, linkText, ownHost } from "./address.ts";
import { copy } from "./clipboard.ts";
import { t } from "../words/translate.ts";

export function mountFriend(root: HTMLElement, store: Store, context: Context): void {
  const { engine } = context;
  const text = h("span");
  const address = h("input", { type: "text", readonly: true, "aria-label": t("friend.link") });
  const send = button(t("friend.send"), () => void copyMove());
  send.classList.add("primary");
  const row = h("div", { class: "row friend", hidden: true }, text, send, address);
  root.append(row);

  /** The link with which the friend goes on; it opens at the start of the last shot's replay. */
  function move(): string {
    const { document, session } = store;
    const { game } = document;
    const theirs = game && { ...game, here: other(game.here ?? 0) };
    const isPlayed = standing(store, engine)?.trace !== null;
    const state = {
      ...store.state,
      document: { ...document, game: theirs },
      session: {
        ...session,
        mode: isPlayed ? ("replay" as const) : ("aim" as const),
        replay: { ...session.replay, time: 0 },
      },
    };
    return isLocal() ? linkText(store, engine, state) : (link(store, engine, state) ?? "");
  }

  async function copyMove(): Promise<void> {
    const moved = move();
    if (moved !== "" && (await copy(moved))) {
      const host = ownHost();
      if (host === null) context.announce(t(isLocal() ? "friend.copied-text" : "friend.copied"));
      else context.announce(t("friend.copied-here", { host }));
      return;
    }
    address.hidden = false;
    address.value = moved;
    address.focus();
    address.select();
  }

  const show = (): void => {
    const { game } = store.document;
    const progress = standing(store, engine);
    address.hidden = true;
    row.hidden = game?.here === undefined || !progress || store.session.mode === "replay";
    if (row.hidden || !progress || game?.here === undefined) return;
    const { request } = progress.frame.state;
    const isOver = request.kind === "over";
    // The friend sees the end of the frame too.
    row.hidden = isOver
      ? progress.steps.at(-1)?.player !== game.here
      : !waitsForFriend(store, engine);
    const name = game.setup.names[other(game.here)];
    setText(text, isOver ? "" : t("friend.theirs", { name }));
  };
  store.subscribe((now, before) => {
    if (now.document.game !== before.document.game || now.session.mode !== before.session.mode) {
      show();
    }
  });
  show();
}
