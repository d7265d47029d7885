import type * as en from "../en/index.ts";
import type { Translation } from "../entry.ts";

export const texts: Translation<typeof en.carom> = {
  "carom.heading": "{pattern}, {ball} zuerst",
  "carom.pattern.direct": "Direkt",
  "carom.pattern.one-cushion": "Eine Bande",
  "carom.pattern.two-cushions": "Zwei Banden",
  "carom.pattern.around-the-table": "Um den Tisch",
  "carom.pattern.double-the-rail": "Zweimal dieselbe Bande",
  "carom.pattern.across-the-table": "Gegenüberliegende Banden",
  "carom.pattern.across-then-corner": "Gegenüberliegende Banden, dann durch die Ecke",
  "carom.pattern.corner-then-across": "Durch die Ecke, dann gegenüberliegende Banden",
  "carom.pattern.ticky": "Ticky",
  "carom.pattern.cushion-first": "Eine Vorbande",
  "carom.pattern.umbrella": "Zwei Vorbanden",
  "carom.pattern.cushions-first": "Drei Vorbanden",
  "carom.pattern.same-rail": "Dieselbe Bande nacheinander",

  "carom.met.off": "{ball} zuerst",
  "carom.met-hit.off": "{ball} {hit}",
  "carom.met.on": "dann {ball}",
  "carom.met-hit.on": "dann {ball} {hit}",
  "carom.cushion.long": "lang",
  "carom.cushion.short": "kurz",
  "carom.side.none": "kein Effet",
  "carom.side.running": "Laufeffet",
  "carom.side.reverse": "Gegeneffet",

  "carom.event.cushion": "{event}, Bande {number}",
  "carom.event.first": "{event}, erste Kugel",
  "carom.event.second": "{event}, zweite Kugel",
  "carom.balls": { one: "{count} Kugel", other: "{count} Kugeln" },
  "carom.cushions": { one: "{count} Bande", other: "{count} Banden" },
};
