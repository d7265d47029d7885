import type * as en from "../en/index.ts";
import type { Translation } from "../entry.ts";

export const texts: Translation<typeof en.pot> = {
  "pot.aimed": "{ball} in die Tasche {pocket}: {how}, ± {margin}°.",
  "pot.tap-pocket": "Tippen Sie auf eine Tasche: {ball} wird dorthin gezielt.",
  "pot.unsolved":
    "{ball} in die Tasche {pocket}: keine Linie mit diesem Stoß. Ändern Sie Tempo oder Effet.",
  "pot.cut": "{hit}, Schnittwinkel {degrees}°",
  "pot.straight": "{hit}, gerade",
  "pot.no-line":
    "Mit diesem Stoß gibt es keine Linie: {ball} in die Tasche {pocket}. Versuchen Sie ein anderes Tempo oder Effet.",
  "pot.no-line-at-all":
    "Mit diesem Stoß gibt es keine Linie: {ball}. Versuchen Sie ein anderes Tempo oder Effet.",
  "pot.no-pockets": "Dieser Tisch hat keine Taschen.",
  "pot.no-ball": "Keine Objektkugel ist gewählt: Drücken Sie N, um eine zu wählen.",

  "pot.hit.full": "voll",
  "pot.hit.nearly-full": "fast voll",
  "pot.hit.three-quarter": "dreiviertel voll",
  "pot.hit.half": "halb voll",
  "pot.hit.quarter": "viertel voll",
  "pot.hit.thin": "dünn",
  "pot.hit.very-thin": "sehr dünn",

  "pot.kind.direct": "direkt",
  "pot.kind.bank": "Bankstoß",
  "pot.kind.kick": "Vorbande",
  "pot.kind.combination": "Kombination",
  "pot.kind.jump": "Sprungstoß",
  "pot.kind.massé": "Kopfstoß",

  "change.aim-pot": "Zielen: {ball} in die Tasche {pocket}",
};
