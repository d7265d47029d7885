import type * as en from "../en/index.ts";
import type { Translation } from "../entry.ts";

export const texts: Translation<typeof en.carom> = {
  "carom.heading": "{pattern}，先碰{ball}",
  "carom.pattern.direct": "直接",
  "carom.pattern.one-cushion": "一库",
  "carom.pattern.two-cushions": "两库",
  "carom.pattern.around-the-table": "绕台",
  "carom.pattern.double-the-rail": "两次吃同一库",
  "carom.pattern.across-the-table": "对边往返",
  "carom.pattern.across-then-corner": "对边，再绕角",
  "carom.pattern.corner-then-across": "绕角，再对边",
  "carom.pattern.ticky": "先库再球再同库",
  "carom.pattern.cushion-first": "先吃一库",
  "carom.pattern.umbrella": "先吃两库",
  "carom.pattern.cushions-first": "先吃三库",
  "carom.pattern.same-rail": "连吃同一库",

  "carom.met.off": "先碰{ball}",
  "carom.met-hit.off": "{hit}碰{ball}",
  "carom.met.on": "再碰{ball}",
  "carom.met-hit.on": "{hit}碰{ball}",
  "carom.cushion.long": "长库",
  "carom.cushion.short": "短库",
  "carom.side.none": "不带侧旋",
  "carom.side.running": "顺塞",
  "carom.side.reverse": "反塞",

  "carom.event.cushion": "{event}，第 {number} 库",
  "carom.event.first": "{event}，第一颗球",
  "carom.event.second": "{event}，第二颗球",
  "carom.balls": { other: "{count} 颗球" },
  "carom.cushions": { other: "{count} 库" },
};
