import type * as en from "../en/index.ts";
import type { Translation } from "../entry.ts";

export const texts: Translation<typeof en.pot> = {
  "pot.aimed": "{ball}打{pocket}袋：{how}，± {margin}°。",
  "pot.tap-pocket": "再点一个球袋，就瞄准把{ball}打进那里。",
  "pot.unsolved": "{ball}打{pocket}袋：这样出杆没有进球线路。请改变杆速或旋转。",
  "pot.cut": "{hit}，切角 {degrees}°",
  "pot.straight": "{hit}，直球",
  "pot.no-line": "这样出杆，{ball}没有到{pocket}袋的线路。请换一个杆速或旋转。",
  "pot.no-line-at-all": "这样出杆，{ball}没有进球线路。请换一个杆速或旋转。",
  "pot.no-pockets": "这张球台没有球袋。",
  "pot.no-ball": "还没有选择目标球：请按 N 选择一颗。",

  "pot.hit.full": "正撞",
  "pot.hit.nearly-full": "接近正撞",
  "pot.hit.three-quarter": "四分之三球",
  "pot.hit.half": "半球",
  "pot.hit.quarter": "四分之一球",
  "pot.hit.thin": "薄球",
  "pot.hit.very-thin": "极薄球",

  "pot.kind.direct": "直接",
  "pot.kind.bank": "翻袋",
  "pot.kind.kick": "先吃库",
  "pot.kind.combination": "组合球",
  "pot.kind.jump": "跳球",
  "pot.kind.massé": "扎杆",

  "change.aim-pot": "瞄准：{ball}打{pocket}袋",
};
