import type * as en from "../en/index.ts";
import type { Translation } from "../entry.ts";

export const texts: Translation<typeof en.layout> = {
  "layout.rack": "Aufbauen",
  "layout.game": "Spiel",
  "layout.seed": "Startwert",
  "layout.shuffle": "Mischen und aufbauen",
  "layout.table": "Tisch",
  "layout.own-table": "Aus der Datei",
  "layout.dimensions": "Maße",
  "layout.changed-hint": "Geänderte Werte sind markiert und lassen sich zurücksetzen.",
  "layout.reset-all": "Alles zurücksetzen",
  "layout.balls": "Kugeln",
  "layout.balls-hint":
    "Ziehen Sie Kugeln auf dem Tisch, oder wählen Sie hier eine und schreiben Sie ihren Platz.",
  "layout.selected": "Gewählte Kugel",
  "layout.struck": "{ball}, wird gestoßen",
  "layout.new-ball": "Neue Kugel",
  "layout.add": "Hinzufügen",
  "layout.across": "Quer",
  "layout.along": "Längs",
  "layout.aim-at": "Anzielen",
  "layout.strike": "Stoßen",
  "layout.remove": "Entfernen",
  "layout.no-name": "Die neue Kugel hat keinen Namen: Schreiben Sie einen, etwa 9 oder red.",
  "layout.name-taken": "Es gibt schon eine Kugel „{id}“: Schreiben Sie einen anderen Namen.",
  "layout.no-place": "Für eine weitere Kugel ist kein Platz: Entfernen Sie zuerst eine.",
  "layout.last-ball":
    "Die letzte Kugel lässt sich nicht entfernen: Für einen Stoß braucht es eine Kugel.",

  "change.add": "{ball} hinzufügen",
  "change.remove": "{ball} entfernen",
  "change.move": "{ball} verschieben",
  "change.rack": "Aufbau: {game}",
  "change.table": "Tisch wechseln",
  "change.photo": "Lage aus einem Foto",
  "change.parameter": "{name} ändern",
  "change.physics": "Physik wechseln",
  "layout.tray": "Ablage",
  "layout.tray-hint":
    "Eine Kugel auf den Tisch ziehen oder antippen. Wer eine Kugel vom Tisch zieht, nimmt sie weg.",
  "layout.put": "{ball} auf den Tisch legen",
  "layout.let-go": "Loslassen nimmt {ball} vom Tisch.",
};
