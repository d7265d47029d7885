import type * as en from "../en/index.ts";
import type { Translation } from "../entry.ts";

export const texts: Translation<typeof en.recorded> = {
  "recorded.match": "Match {first} – {second}",
  "recorded.finished": {
    one: "{game}, {count} Spiel. Wählen Sie es, um seine Stöße anzusehen.",
    other: "{game}, {count} Spiele. Wählen Sie eines, um seine Stöße anzusehen.",
  },
  "recorded.goes-on": {
    one: "{game}, bisher {count} Spiel. Das Match geht weiter.",
    other: "{game}, bisher {count} Spiele. Das Match geht weiter.",
  },
  "recorded.frame": "Spiel {number}",
  "recorded.players": "{first} gegen {second}:",
  "recorded.won": "{name} hat gewonnen, {why};",
  "recorded.no-winner": "kein Gewinner, {why};",
  "recorded.shots": { one: "{count} Stoß", other: "{count} Stöße" },
  "recorded.close": "Schließen",
  "recorded.frames": "Spiele des Matches",
  "recorded.of-match": "Spiel {number} eines Matches.",
  "recorded.no-end": "Das Spiel geht weiter.",
  "recorded.differs":
    "Stoß {number} endet nicht wie aufgezeichnet. Die Aufzeichnung stammt von {made}, und diese Seite hat {own}: öffnen Sie sie mit jener Version.",
  "recorded.split":
    "Gewinnchance von {name}: durchgezogene Linien sind Entscheidungen, gestrichelte sind Glück. Drücken Sie auf einen Schritt, um seinen Stoß zu sehen.",
  "recorded.expected":
    "Gewinnchance von {name}, wie die Spieler sie erwarteten. Drücken Sie auf einen Schritt, um seinen Stoß zu sehen.",
  "recorded.curve": "Gewinnchance von {name}, von {from} % bis {to} %",
  "recorded.step-decision": "Stoß {number}, Entscheidung: {change} %, auf {chance} %",
  "recorded.step-luck": "Stoß {number}, Glück: {change} %, auf {chance} %",
  "recorded.step-both": "Stoß {number}: {change} %, auf {chance} %",
  "recorded.intended": "beabsichtigt",
  "recorded.executed": "ausgeführt",
  "recorded.azimuth": "Richtung °",
  "recorded.elevation": "Neigung °",
  "recorded.side": "seitlich, Pomeranzen",
  "recorded.height": "Höhe, Pomeranzen",
  "recorded.chance": "Erwartete Gewinnchance: {chance} %.",
  "recorded.luck": "Entscheidung {decision} %, Glück {luck} %.",
  "recorded.refused": {
    one: "Vorher wurde {count} Antwort abgelehnt.",
    other: "Vorher wurden {count} Antworten abgelehnt.",
  },
  "change.open-frame": "ein Spiel eines Matches öffnen",
};
