import type * as en from "../en/index.ts";
import type { Translation } from "../entry.ts";

export const texts: Translation<typeof en.page> = {
  "page.skip": "Zum Tisch springen",
  "page.history": "Verlauf",
  "page.camera": "Kamera",
  "page.table": "Tisch",
  "page.table-role": "Billardtisch",
  "page.table-keys":
    "Tisch. Pfeiltasten drehen das Queue und ändern das Tempo, die Eingabetaste stößt, das Fragezeichen zeigt alle Tasten.",
  "page.draw": "Zeichnen",
  "page.shot": "Stoß",
  "page.settings": "Einstellungen",

  "history.undo": "Rückgängig",
  "history.redo": "Wiederholen",
  "history.undo-change": "Rückgängig: {change}",
  "history.redo-change": "Wiederholen: {change}",
  "history.undone": "Rückgängig gemacht: {change}",
  "history.redone": "Wiederholt: {change}",
  "history.nothing-to-undo": "Es gibt nichts rückgängig zu machen.",
  "history.nothing-to-redo": "Es gibt nichts zu wiederholen.",

  "page.tools": "Werkzeuge",
  "page.activity": "Tätigkeit",
  "activity.analyse": "Analyse",
  "activity.play": "Spielen",
  "activity.train": "Üben",
  "activity.library": "Sammlung",

  "camera.top": "Von oben",
  "camera.orbit": "Freie Kamera: durch Ziehen drehen",
  "camera.cue": "Hinter dem Queue",

  "theme.auto": "Farben: wie das System",
  "theme.light": "Farben: hell",
  "theme.dark": "Farben: dunkel",
  "page.help": "Hilfe und Tasten",

  "page.close-sheet": "Einstellungen schließen",
  "page.hide-panel": "Einstellungen ausblenden",
  "page.show-panel": "Einstellungen einblenden",
  "tab.state": "Wiederholung",
  "tab.aim": "Zielen",
  "tab.lines": "Beste",
  "tab.tree": "Stöße",
  "tab.layout": "Lage",
  "tab.physics": "Physik",
  "tab.game": "Spiel",
  "tab.whatif": "Streuung",
  "tab.train": "Übungen",
  "tab.library": "Sammlung",

  "steps.title": "Erste Schritte",
  "steps.pot":
    "Lochen Sie die 9: Ziehen Sie auf dem Tisch, bis die Linie in die helle Tasche springt, und stoßen Sie.",
  "steps.stop":
    "Lochen Sie jetzt die 1, der Spielball bleibt im Kreis liegen: Treffen Sie ihn tiefer und fester.",
  "steps.well-done": "Gut gemacht.",
  "steps.again": "Noch nicht.",
  "steps.end":
    "Gut gemacht. Die besten Stöße jeder Lage nennt die Analyse; unter Spielen spielt man gegen die Maschine, unter Üben übt man.",
  "steps.skip": "Später",
  "steps.wait": "Die ersten Schritte warten: Rückgängig bringt sie zurück.",
  "language.label": "Sprache",
  "language.hint": "Die Seite lädt neu, mit allem, wie es jetzt ist.",
  "language.not-stored":
    "Der Browser lässt diese Seite die Sprache nicht speichern: Öffnen Sie die Seite in einem eigenen Tab, oder ändern Sie die Sprache des Browsers.",

  "help.title": "So benutzen Sie diesen Tisch",
  "help.pot": "Versenken",
  "help.pot-text":
    "Tippen Sie eine Kugel an, dann eine Tasche. Das Ziel bleibt, während Sie Tempo, Effet und Neigung ändern.",
  "help.aim": "Zielen",
  "help.aim-text":
    "Ziehen Sie auf dem Tuch, um das Queue zu drehen; es rastet ein, wo eine Kugel fällt. Oder tippen Sie auf das Tuch, um dorthin zu zielen. Ein langsamer Finger zielt fein, und ebenso das Rad am Rand des Tisches.",
  "help.strike": "Treffpunkt",
  "help.strike-text":
    "Klicken Sie unter Zielen auf die Kugel: Effet, Nachläufer oder Rückläufer. Daneben stehen Tempo, Neigung und Richtung.",
  "help.ahead": "Vorausschau",
  "help.ahead-text":
    "Während Sie zielen, berechnet die Seite den ganzen Stoß, zeichnet die Wege der Kugeln und beschreibt unter dem Tisch, was geschieht.",
  "help.shoot": "Stoßen",
  "help.shoot-text":
    "Spielt den Stoß. Oder drücken Sie auf das Queue, ziehen Sie es zurück und lassen Sie los: Der Zug bestimmt das Tempo; am Anfang des Zugs wird nichts gespielt. „Von hier weiterspielen“ macht aus der Endlage die neue Lage.",
  "help.move": "Kugeln verschieben",
  "help.move-text":
    "Ziehen Sie eine Kugel. Wo sie nicht liegen darf, wird sie rot, die Seite nennt den Grund, und die Kugel geht zurück.",
  "help.draw": "Zeichnen",
  "help.draw-text":
    "Mit dem Stift über dem Tisch zeichnen Sie Linien, Pfeile, Kreise, Flächen und Beschriftungen; sie rasten an Kugeln, Taschen, Diamanten und Treffpunkten ein. Links, Dateien und Bilder enthalten sie.",
  "help.game": "Ein Spiel spielen",
  "help.game-text":
    "Unter Spielen spielen Personen und Maschinen mit Schiedsrichter. Eine Ansage, die nötig ist, folgt dem Ziel; tippen Sie Kugel und Tasche an, um andere anzusagen. Auch Stöße lassen sich rückgängig machen.",
  "help.keep": "Später weitermachen",
  "help.keep-text":
    "Schließen Sie die Seite jederzeit: Beim nächsten Öffnen bietet sie an, fortzusetzen. Unter „Spielen“ stehen Ihre Spiele; dort lässt sich alles als Datei speichern und zurückholen.",
  "help.else": "Alles andere",
  "help.else-text":
    "Unter Lage stehen Aufbau, Tische und Kugeln, unter Physik Tuch, Kugeln und Banden mit ihren Zahlen.",
  "help.keys": "Tasten",
  "help.keys-hint": "Pfeiltasten, Eingabe- und Leertaste wirken, wenn der Tisch den Fokus hat.",
  "help.software": "Software in dieser Seite und ihre Lizenzen",
  "help.licenses": "Lizenzen",
  "help.steps": "Erste Schritte zeigen",
  "help.close": "Schließen",

  "key.turn": "Queue um 1° drehen; mit Umschalt um 0,1°",
  "key.speed": "Tempo um 0,1 m/s ändern; mit Umschalt um 0,01 m/s",
  "key.shoot": "Stoßen",
  "key.next-ball": "Nächste Kugel wählen; mit Umschalt die vorige",
  "key.aim-at": "Auf die Mitte der gewählten Kugel zielen",
  "key.no-ball": "Keine Kugel ist gewählt: Drücken Sie N, um eine zu wählen.",
  "key.pot":
    "Gewählte Kugel auf eine Tasche zielen; noch einmal: auf die nächste, mit Umschalt auf die vorige",
  "key.fine": "Feineinstellung ein oder aus: Ziehen und Tasten wirken ein Zehntel so stark",
  "key.sound": "Ton der Wiederholung ein oder aus",
  "key.play": "Wiederholung abspielen oder anhalten",
  "key.events": "In der Wiederholung: zum vorigen oder nächsten Ereignis",
  "key.take": "Von hier weiterspielen: Die Endlage wird die neue Lage",
  "key.escape": "Wiederholung beenden; beim Zielen: Ausholen abbrechen, Auswahl aufheben",
  "key.undo": "Rückgängig",
  "key.redo": "Wiederholen",
  "key.draw": "Auf den Tisch zeichnen, oder das Zeichnen beenden",
  "key.top": "Blick von oben",
  "key.orbit": "Freie Kamera",
  "key.cue": "Blick hinter dem Queue",
  "key.help": "Diese Hilfe zeigen",
  "keyname.enter": "Eingabe",
  "keyname.space": "Leertaste",
  "keyname.escape": "Esc",
  "keyname.control": "Strg",
  "keyname.shift": "Umschalt",
};
