import type * as en from "../en/index.ts";
import type { Translation } from "../entry.ts";

export const texts: Translation<typeof en.train> = {
  "train.drills": "Übungen",
  "train.intro":
    "Spielen Sie eine Übung auf diesem Tisch, oder bauen Sie sie am echten Tisch auf und tippen Sie an, wie jeder Versuch ausging.",
  "train.best": "Bestes Ergebnis {score} von {most}",
  "train.new": "Noch nicht gespielt",
  "train.all": "Alle Übungen",
  "train.diagram": "Skizze: {name}",
  "train.table-of": "{table}, {attempts}.",
  "train.attempts": { one: "{count} Versuch", other: "{count} Versuche" },
  "train.step": "Stufe {step} von {steps}",
  "train.score": "Versuch {attempt} von {attempts}. Punkte: {score}.",
  "train.shots": { one: "Bisher {count} Stoß.", other: "Bisher {count} Stöße." },
  "train.errors": "Ihre Stöße haben die Fehler von",
  "train.no-errors": "Niemandem: genau wie gezielt",
  "train.errors-hint": "Der Tisch zeichnet nur den Weg bis zur ersten Kugel.",
  "train.play": "Hier spielen",
  "train.at-table": "Am echten Tisch",
  "train.leave": "Beenden",
  "train.again": "Noch einmal",
  "train.set-again": "Kugeln neu aufbauen",
  "train.made": "Gelungen",
  "train.missed": "Misslungen",
  "train.points": { one: "{count} Punkt", other: "{count} Punkte" },
  "train.take-back": "Letzten zurücknehmen",
  "train.at-table-hint": "Bauen Sie diese Kugeln auf und tippen Sie an, wie der Versuch ausging.",
  "train.run-hint": "Tippen Sie an, wie viele Kugeln nacheinander fielen.",
  "train.progress": "{done} von {attempts} Versuchen gespielt",
  "train.attempt-made": "{number}: {points}",
  "train.attempt-open": "{number}: offen",
  "train.finished": "Fertig: {score} von {most}.",
  "train.like": "Wie diese Spielstärke: {level}.",
  "train.levels": "Was die Spielstärken erreichen",
  "train.level-score": "{level}: im Mittel {mean}, meist {low} bis {high}",
  "train.levels-hint":
    "Berechnet mit den Fehlern jeder Spielstärke beim besten Stoß. Die Spielstärken sind geschätzt.",
  "train.history": "Ihre Ergebnisse",
  "train.history-of": { one: "{count}-mal, bestes {best}", other: "{count}-mal, bestes {best}" },
  "train.history-label": "Ihre Ergebnisse in zeitlicher Folge: {scores}",
  "train.yours": "Ihr bestes: {score}",

  "verdict.made": "Gelungen.",
  "verdict.points": { one: "Gut für {count} Punkt.", other: "Gut für {count} Punkte." },
  "verdict.on": { one: "Gut, noch {count} Kugel.", other: "Gut, noch {count} Kugeln." },
  "verdict.run": {
    one: "Die Serie endet nach {count} Kugel.",
    other: "Die Serie endet nach {count} Kugeln.",
  },
  "verdict.cleared": "Alle Kugeln versenkt.",
  "fault.scratch": "Misslungen: Der Spielball ist verloren.",
  "fault.pot": "Misslungen: {ball} fällt dort nicht.",
  "fault.pot-any": "Misslungen: Keine Kugel fällt.",
  "fault.first": "Misslungen: {ball} wird nicht zuerst getroffen.",
  "fault.kick": "Misslungen: Der Spielball trifft vor einer Kugel keine Bande.",
  "fault.cushions": "Misslungen: {ball} trifft keine Bande.",
  "fault.carom": "Misslungen: nicht beide Kugeln, oder zu wenige Banden.",
  "fault.stop": "Misslungen: Der Spielball bleibt {length} außerhalb liegen.",
  "fault.hidden": "Misslungen: {ball} ist auf gerader Linie zu treffen.",
  "fault.wrong-first": "Vor {ball} wird eine andere Kugel getroffen.",
  "fault.no-pot": "Keine Kugel fällt.",
  "fault.wrong-ball": "{ball} fällt zu früh.",

  "deviation.table": "Nicht gezählt: Der Tisch wurde geändert. Bauen Sie die Kugeln neu auf.",
  "deviation.balls": "Nicht gezählt: Die Kugeln liegen anders. Bauen Sie die Kugeln neu auf.",
  "deviation.cue": "Nicht gezählt: Der Spielball liegt anders. Bauen Sie die Kugeln neu auf.",
  "deviation.struck":
    "Nicht gezählt: Eine andere Kugel wird gestoßen. Bauen Sie die Kugeln neu auf.",

  "train.damaged":
    "Die laufende Übung war nicht lesbar: Beginnen Sie sie noch einmal. Ihre Ergebnisse sind erhalten.",

  "progress.title": "Ihr Fortschritt",
  "progress.kept": "Er bleibt in diesem Browser. Sichern Sie ihn als Datei, um ihn mitzunehmen.",
  "progress.not-kept":
    "Dieser Browser behält nichts für diese Seite: Sichern Sie Ihren Fortschritt als Datei, bevor Sie sie schließen.",
  "progress.damaged":
    "Der gespeicherte Fortschritt war nicht lesbar. Ein neuer hat begonnen, der alte ist beiseitegelegt: Sichern Sie ihn als Datei.",
  "progress.save-damaged": "Den alten sichern",
  "progress.export": "Als Datei sichern",
  "progress.import": "Aus Datei ergänzen",
  "progress.imported": {
    one: "{count} neues Ergebnis ergänzt.",
    other: "{count} neue Ergebnisse ergänzt.",
  },
  "progress.delete": "Löschen",
  "progress.confirm-delete": {
    one: "{count} Ergebnis endgültig löschen",
    other: "{count} Ergebnisse endgültig löschen",
  },
  "progress.keep": "Behalten",
  "progress.deleted": { one: "{count} Ergebnis gelöscht.", other: "{count} Ergebnisse gelöscht." },
  "progress.not-json": "{file} ist beschädigt oder keine Fortschrittsdatei. Nichts wurde geändert.",
  "progress.other-format":
    "{file} ist kein Fortschritt dieser Seite: Wählen Sie eine Datei, die sie gesichert hat. Nichts wurde geändert.",
  "progress.wrong-value":
    "{file} ist bei {place} beschädigt: Wählen Sie eine andere Kopie. Nichts wurde geändert.",
  "progress.unreadable":
    "{file} ist nicht lesbar: Wählen Sie die Datei noch einmal. Nichts wurde geändert.",

  "sheet.title": "Übungsblatt",
  "sheet.intro": "Bis zu sechs Übungen mit allen Stufen, zum Mitnehmen an den Tisch.",
  "sheet.choose": "Übungen auf dem Blatt",
  "sheet.paper": "Papier",
  "sheet.a4": "A4",
  "sheet.letter": "Letter",
  "sheet.print": "Drucken",
  "sheet.full": "Auf ein Blatt passen sechs Übungen: Nehmen Sie zuerst eine weg.",
  "sheet.none": "Wählen Sie zuerst eine Übung für das Blatt.",
  "sheet.name": "Name",
  "sheet.date": "Datum",
  "sheet.scale": "Maßstab 1 : {scale}",
  "sheet.sum": "Summe",

  "change.drill": "Übung aufbauen",
  "change.leave-drill": "Übung beenden",
};
