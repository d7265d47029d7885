import type * as en from "../en/index.ts";
import type { Translation } from "../entry.ts";

export const texts: Translation<typeof en.diagram> = {
  "diagram.heading": "Diagramm für Papier",
  "diagram.label": "Diagramm des Tisches",
  "diagram.caption": "{number}. {comment}",
  "diagram.svg": "SVG",
  "diagram.png": "PNG",
  "diagram.print": "Drucken …",
  "diagram.paper": "Papier",
  "diagram.a4": "A4",
  "diagram.letter": "Letter",
  "diagram.per-page": "Diagramme je Seite",
  "diagram.what": "Was",
  "diagram.this": "Diese Stellung",
  "diagram.all": "Alle Stöße der Analyse",
  "diagram.none": "Tuch ohne Ränder hat kein Diagramm: Wählen Sie einen Tisch.",
};
