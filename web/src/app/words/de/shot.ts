import type * as en from "../en/index.ts";
import type { Translation } from "../entry.ts";

export const shot: Translation<typeof en.shot> = {
  sentence: "{text}.",
  "sentence.gap": " ",

  "ball.cue": "Spielball",
  "ball.white": "Weiße",
  "ball.yellow": "Gelbe",
  "ball.red": "Rote",
  "ball.green": "Grüne",
  "ball.brown": "Braune",
  "ball.blue": "Blaue",
  "ball.pink": "Pinke",
  "ball.black": "Schwarze",
  "ball.numbered": "Kugel {id}",
  "ball.red-n": "Rote {number}",
  "ball.other": "{id}",
  "ball.other-n": "{id} {number}",

  "pocket.bottom-left": "unten links",
  "pocket.bottom-right": "unten rechts",
  "pocket.left": "Mitte links",
  "pocket.right": "Mitte rechts",
  "pocket.top-left": "oben links",
  "pocket.top-right": "oben rechts",
  "pocket.top": "Mitte oben",
  "pocket.bottom": "Mitte unten",
  "pocket.named": "Tasche {pocket}",

  "rail.bottom": "Bande unten",
  "rail.top": "Bande oben",
  "rail.left": "Bande links",
  "rail.right": "Bande rechts",
  "rail.left-lower": "Bande links unten",
  "rail.left-upper": "Bande links oben",
  "rail.right-lower": "Bande rechts unten",
  "rail.top-left": "Bande oben links",
  "rail.top-right": "Bande oben rechts",
  "rail.bottom-left": "Bande unten links",
  "rail.bottom-right": "Bande unten rechts",
  "rail.right-upper": "Bande rechts oben",

  "length.mm": "{length} mm",
  "length.m": "{length} m",

  "obstruction.raise":
    "Dem Queue im Weg: {obstacle}. Heben Sie das Queue auf mindestens {degrees}° an.",
  "obstruction.turn": "Dem Queue im Weg: {obstacle}. Zielen Sie in eine andere Richtung.",

  "outcome.miscue": "Kickser: Die Pomeranze rutscht vom Ball ab.",
  "outcome.no-strike": "Kein Ball wird gestoßen.",
  "outcome.hits": "Trifft zuerst: {ball}.",
  "outcome.hits-after": {
    one: "Trifft zuerst: {ball}, nach {count} Bande.",
    other: "Trifft zuerst: {ball}, nach {count} Banden.",
  },
  "outcome.misses": "Trifft keine Kugel.",
  "outcome.misses-after": {
    one: "Trifft nach {count} Bande keine Kugel.",
    other: "Trifft nach {count} Banden keine Kugel.",
  },
  "outcome.drops": "{ball} fällt in die Tasche {pocket}",
  "outcome.scratch": "Spielball fällt.",
  "outcome.scratch-in": "Spielball fällt in die Tasche {pocket}.",
  "outcome.off": "{ball} verlässt den Tisch",
  "outcome.jumps": "{ball} springt über {other}",
  "outcome.hops": "{ball} springt {height} hoch",
  "outcome.hangs": "{ball} hängt an der Tasche {pocket}",

  "error.overlap": "{ball} überdeckt {other} um {depth}: Rücken Sie die Kugel weg",
  "error.in-rail": "{ball} liegt zu nah an der Bande ({rail}): Rücken Sie die Kugel zur Tischmitte",
  "error.in-pocket": "{ball} liegt über der Tasche {pocket}: Legen Sie die Kugel auf das Tuch",
  "error.outside": "{ball} liegt außerhalb des Tisches: Legen Sie die Kugel auf das Tuch",
  "error.a-ball": "diese Kugel",
  "error.miscue":
    "So weit außen rutscht die Pomeranze ab (Kickser): Bleiben Sie im gestrichelten Kreis.",
  "error.off-ball": "Dort verfehlt die Pomeranze den Ball: Bleiben Sie im gestrichelten Kreis.",
  "error.range": "{name}: {value} ist nicht möglich. Erlaubt ist eine Zahl {range}.",
  "error.range.from-to": "von {low} bis {high}{unit}",
  "error.range.above-to": "über {low} bis {high}{unit}",
  "error.range.from-below": "ab {low} und unter {high}{unit}",
  "error.range.positive": "über 0",
  "error.range.not-negative": "ab 0",
  "error.noise": "{name}: Diese Zahl ist nicht möglich. Erlaubt ist eine kleinere, mindestens 0.",
  "error.no-call": "es ist nichts angesagt: Sagen Sie Kugel und Tasche an, oder Sicherheit",
  "error.no-nomination": "es ist keine Kugel angesagt: Sagen Sie eine der anspielbaren an",
  "error.not-called": "dieser Stoß wird nicht angesagt: Nehmen Sie die Ansage zurück",
  "error.called-ball-gone":
    "die angesagte Kugel liegt nicht auf dem Tisch: Sagen Sie eine andere an",
  "error.no-safety": "Sicherheit wird bei diesem Stoß nicht angesagt: Nehmen Sie die Ansage zurück",
  "error.no-push-out":
    "Push-out ist nur beim ersten Stoß nach einem gültigen Break erlaubt: Nehmen Sie die Ansage zurück",
  "error.wrong-nomination": "diese Kugel ist nicht anspielbar: Sagen Sie eine der anspielbaren an",
  "error.hand.behind-head-string": "legen Sie den Spielball hinter die Kopflinie",
  "error.hand.the-d": "legen Sie den Spielball ins D",
  "error.hand.on-table": "legen Sie den Spielball auf den Tisch",
  "error.hand.touches":
    "der Spielball würde eine Kugel berühren: Legen Sie ihn dorthin, wo Platz ist",
  "error.not-a-choice": "diese Antwort steht nicht zur Wahl: Wählen Sie eine unter dem Tisch",
  "error.frame-over": "das Spiel ist zu Ende: Beginnen Sie ein neues",
  "error.too-many-events":
    "Dieser Stoß hat zu viele Zusammenstöße: Ändern Sie das Tempo oder die Kugeln.",
  "error.other": "Das ist nicht möglich. Einzelheiten auf Englisch: {message}",

  "error.not-json":
    "Sie enthält keinen Stoß, keine Aufzeichnung, kein Spiel und keine Analyse von carom.",
  "error.game": "Das Spiel in dieser Datei ist beschädigt: Wählen Sie eine andere Kopie davon.",
  "error.other-version": "Sie stammt von einer anderen Version von carom.",
  "error.file": "Diese Datei lässt sich nicht öffnen. {why}",
  "error.start": "Der Tisch kann nicht angezeigt werden. {why}",
  "error.unplayable": "Dieser Stoß lässt sich nicht spielen. {why}",
};
