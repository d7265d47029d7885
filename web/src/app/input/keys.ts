/** All keys of the page: their actions, and their descriptions in the help. */

import { shoot, takeItFromHere } from "../aim/shoot.ts";
import type { Context } from "../common/context.ts";
import type { Camera } from "../document/document.ts";
import { aimAt, FINE, turn } from "../document/strike-changes.ts";
import { aimAtNextPocket } from "../analyse/aim-at-pocket.ts";
import { redo, undo } from "../document/undo.ts";
import { leave, stepBackwards, stepForwards, togglePlaying } from "../replay/replay-control.ts";
import { switchSound } from "../replay/replay-sound.ts";
import { beginDrawing, endDrawing } from "../draw/draw-mode.ts";
import type { Store } from "../document/store.ts";
import { round } from "../common/units.ts";
import { type PlainKey, t } from "../words/translate.ts";

/** Degrees and m/s per arrow key. Shift and fine adjustment each divide them by ten. */
const TURN = 1;
const SPEED = 0.1;

/** Lowest speed (m/s) that the keys set; the engine refuses 0. */
const SOFTEST = 0.01;

/** Time (ms) after which a series of key presses ends and becomes one step of undo. */
const PAUSE = 800;

interface Tools {
  readonly store: Store;
  readonly context: Context;
  readonly openHelp: () => void;
}

interface Key {
  /** Names as in `KeyboardEvent.key`, after "Mod+" for Ctrl or ⌘ and then "Shift+". */
  readonly keys: readonly string[];
  /** The keys as the help shows them: letters, or names in the catalogue. */
  readonly shown: readonly string[];
  readonly help: Extract<PlainKey, `key.${string}`>;
  /** Mode in which the key acts; left out: both. */
  readonly mode?: "aim" | "replay";
  /** Whether the key acts only while the table has the focus. */
  readonly table?: boolean;
  readonly run: (tools: Tools, event: KeyboardEvent) => void;
}

const fine = ({ store }: Tools, event: KeyboardEvent) =>
  (store.session.fine ? FINE : 1) * (event.shiftKey ? FINE : 1);

function faster(tools: Tools, event: KeyboardEvent, sign: number): void {
  const { store } = tools;
  const speed = store.document.shot.strike.speed + sign * SPEED * fine(tools, event);
  store.strike({ speed: Math.max(SOFTEST, round(speed, 3)) }, t("change.speed"), "speed-keys");
}

const toCamera =
  (camera: Camera) =>
  ({ store }: Tools) => {
    store.setView({ camera });
  };

export const KEYS: readonly Key[] = [
  {
    keys: ["ArrowLeft", "ArrowRight"],
    shown: ["←", "→"],
    help: "key.turn",
    mode: "aim",
    table: true,
    run: (tools, event) => {
      const sign = event.key === "ArrowLeft" ? 1 : -1;
      turn(tools.store, sign * TURN * fine(tools, event), "turn-keys");
    },
  },
  {
    keys: ["ArrowUp", "ArrowDown"],
    shown: ["↑", "↓"],
    help: "key.speed",
    mode: "aim",
    table: true,
    run: (tools, event) => {
      faster(tools, event, event.key === "ArrowUp" ? 1 : -1);
    },
  },
  {
    keys: ["Enter"],
    shown: ["enter"],
    help: "key.shoot",
    mode: "aim",
    table: true,
    run: ({ store, context }) => {
      shoot(store, context);
    },
  },
  {
    keys: ["n", "N"],
    shown: ["N"],
    help: "key.next-ball",
    run: ({ store }, event) => {
      const { balls, strike } = store.document.shot;
      const ids = balls.map((ball) => ball.id);
      const at = ids.indexOf(store.session.selected ?? "");
      const step = event.shiftKey ? -1 : 1;
      // At first a ball at which the cue can be aimed.
      const object = Math.max(
        0,
        ids.findIndex((id) => id !== strike.ball),
      );
      const next = at < 0 ? object : (at + step + ids.length) % ids.length;
      store.setSession({ selected: ids[next] ?? null });
    },
  },
  {
    keys: ["a"],
    shown: ["A"],
    help: "key.aim-at",
    mode: "aim",
    run: ({ store }) => {
      const { selected } = store.session;
      if (selected === null) store.refuse(t("key.no-ball"));
      else aimAt(store, selected);
    },
  },
  {
    keys: ["p", "P"],
    shown: ["P"],
    help: "key.pot",
    mode: "aim",
    run: ({ store, context }, event) => {
      aimAtNextPocket(store, context, event.shiftKey ? -1 : 1);
    },
  },
  {
    keys: ["f"],
    shown: ["F"],
    help: "key.fine",
    run: ({ store, context }) => {
      store.setSession({ fine: !store.session.fine });
      context.announce(t(store.session.fine ? "aim.fine-on" : "aim.fine-off"));
    },
  },
  {
    keys: ["m"],
    shown: ["M"],
    help: "key.sound",
    run: ({ store, context }) => {
      switchSound(store);
      context.announce(t(store.session.replay.sound ? "replay.sound-on" : "replay.sound-off"));
    },
  },
  {
    keys: [" "],
    shown: ["space"],
    help: "key.play",
    mode: "replay",
    table: true,
    run: ({ store }) => {
      togglePlaying(store);
    },
  },
  {
    keys: ["ArrowLeft", "ArrowRight"],
    shown: ["←", "→"],
    help: "key.events",
    mode: "replay",
    table: true,
    run: ({ store }, event) => {
      if (event.key === "ArrowLeft") stepBackwards(store);
      else stepForwards(store);
    },
  },
  {
    keys: ["t"],
    shown: ["T"],
    help: "key.take",
    mode: "replay",
    run: ({ store, context }) => {
      takeItFromHere(store, context);
    },
  },
  {
    keys: ["Escape"],
    shown: ["escape"],
    help: "key.escape",
    run: ({ store }) => {
      if (store.session.mode === "replay") leave(store);
      else store.setSession({ selected: null, refusal: null });
    },
  },
  {
    keys: ["Mod+z"],
    shown: ["control", "Z"],
    help: "key.undo",
    run: ({ store, context }) => {
      undo(store, context);
    },
  },
  {
    keys: ["Mod+Shift+z", "Mod+y"],
    shown: ["control", "shift", "Z"],
    help: "key.redo",
    run: ({ store, context }) => {
      redo(store, context);
    },
  },
  {
    keys: ["d"],
    shown: ["D"],
    help: "key.draw",
    mode: "aim",
    run: ({ store }) => {
      if (store.session.drawing) endDrawing(store);
      else beginDrawing(store);
    },
  },
  { keys: ["1"], shown: ["1"], help: "key.top", run: toCamera("top") },
  { keys: ["2"], shown: ["2"], help: "key.orbit", run: toCamera("orbit") },
  { keys: ["3"], shown: ["3"], help: "key.cue", run: toCamera("cue") },
  {
    keys: ["?"],
    shown: ["?"],
    help: "key.help",
    run: ({ openHelp }) => {
      openHelp();
    },
  },
];

/** Controls that use letters and arrow keys themselves. */
const TEXT_CONTROLS = "input:not([type=range], [type=checkbox], [type=radio]), select, textarea";

export function mountKeys(table: HTMLElement, tools: Tools): void {
  let pause: ReturnType<typeof setTimeout> | undefined;
  document.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || event.altKey || document.querySelector("dialog[open]")) return;
    const target = event.target as Element;
    const mod = event.ctrlKey || event.metaKey;
    if (target.closest(TEXT_CONTROLS)) return;
    const name = mod
      ? `Mod+${event.shiftKey ? "Shift+" : ""}${event.key.toLowerCase()}`
      : event.key;
    const found = KEYS.find(
      ({ keys, mode, table: only }) =>
        keys.includes(name) &&
        (mode === undefined || mode === tools.store.session.mode) &&
        (!only || target === table || target === document.body),
    );
    if (!found) return;
    event.preventDefault();
    found.run(tools, event);
    clearTimeout(pause);
    pause = setTimeout(() => {
      tools.store.settle();
    }, PAUSE);
  });
}
