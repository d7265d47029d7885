import type * as en from "../en/index.ts";
import type { Translation } from "../entry.ts";

export const texts: Translation<typeof en.kept> = {
  "kept.title": "Ihre Spiele",
  "kept.unfinished": "Noch nicht zu Ende",
  "kept.finished": "Beendet",
  "kept.none": "Hier stehen die Spiele, die Sie zu Ende gespielt haben, mit Rückblick.",
  "kept.offer": "Weitermachen, wo Sie aufgehört haben",
  "kept.continue": "Fortsetzen",
  "kept.close": "Schließen",
  "kept.game": "{game}, {players}, {shots}",
  "kept.against": "{first} gegen {second}",
  "kept.shots": { one: "{count} Stoß", other: "{count} Stöße" },
  "kept.analysis": "Analyse, {balls}",
  "kept.balls": { one: "{count} Kugel", other: "{count} Kugeln" },
  "kept.study": "Analyse von Stoß {number}, {game}",
  "kept.drill": "{name}, {done} von {attempts}",
  "kept.continued": "Fortgesetzt. Rückgängig geht zurück wie zuvor.",
  "kept.refused": "Das lässt sich nicht öffnen, und nichts wurde geändert. {why}",
  "kept.damaged": {
    one: "{count} Eintrag im Speicher des Browsers ist beschädigt und lässt sich nicht öffnen. Speichern Sie ihn, bevor Sie ihn löschen.",
    other:
      "{count} Einträge im Speicher des Browsers sind beschädigt und lassen sich nicht öffnen. Speichern Sie sie, bevor Sie sie löschen.",
  },
  "kept.save-damaged": "Beschädigtes speichern",
  "kept.delete-damaged": "Beschädigtes löschen",
  "kept.kept": "Sie bleiben in diesem Browser. Speichern Sie alles als Datei, um es mitzunehmen.",
  "kept.fault-refused":
    "Dieser Browser bewahrt für diese Seite nichts auf: Mit diesem Tab endet, was Sie tun. Behalten Sie ein Spiel über „Teilen“, oder öffnen Sie die Seite außerhalb eines privaten Fensters.",
  "kept.fault-full":
    "Der Speicher des Browsers ist voll: Die letzten Änderungen sind nicht gesichert. Speichern Sie alles als Datei, und löschen Sie dann Spiele, die Sie nicht mehr brauchen.",
  "kept.fault-damaged":
    "Der Speicher des Browsers ist beschädigt: Die letzten Änderungen sind nicht gesichert. Behalten Sie ein Spiel über „Teilen“, und löschen Sie dann die Daten dieser Seite im Browser.",
  "kept.export": "Alles als Datei speichern",
  "kept.import": "Aus einer Datei hinzufügen",
  "kept.imported": {
    one: "{count} neuer Eintrag hinzugefügt.",
    other: "{count} neue Einträge hinzugefügt.",
  },
  "kept.import-full": "Nicht alles aus {file} konnte gesichert werden.",
  "kept.not-backup": "{file} ist beschädigt oder keine Datei dieser Seite. Nichts wurde geändert.",
  "kept.wrong-value": "{file} ist bei {place} beschädigt. Nichts wurde geändert.",
  "kept.unreadable":
    "{file} lässt sich nicht lesen: Wählen Sie die Datei noch einmal. Nichts wurde geändert.",
  "kept.review": "Rückblick",
  "kept.review-of": "Rückblick: {what}",
  "kept.delete": "Löschen",
  "kept.delete-of": "Löschen: {what}",
  "kept.confirm": "Endgültig löschen",
  "kept.more": "Alle zeigen",
  "kept.result": "{game}: {first} {a} : {b} {second}",
  "kept.won": "{game}: {winner} hat gegen {loser} gewonnen",
  "kept.drawn": "{game}: {first} gegen {second}, ohne Sieger",
  "kept.alone": "{game}: {name}, {points}",
  "change.reload": "Seite neu geladen",
};
