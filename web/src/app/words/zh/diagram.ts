import type * as en from "../en/index.ts";
import type { Translation } from "../entry.ts";

export const texts: Translation<typeof en.diagram> = {
  "diagram.heading": "打印用图",
  "diagram.label": "球台示意图",
  "diagram.caption": "{number}. {comment}",
  "diagram.svg": "SVG",
  "diagram.png": "PNG",
  "diagram.print": "打印…",
  "diagram.paper": "纸张",
  "diagram.a4": "A4",
  "diagram.letter": "Letter",
  "diagram.per-page": "每页图数",
  "diagram.what": "内容",
  "diagram.this": "当前局面",
  "diagram.all": "分析中的所有击球",
  "diagram.none": "没有边的台布没有示意图：请选择一张球台。",
};
