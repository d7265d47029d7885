import type * as en from "../en/index.ts";
import type { Translation } from "../entry.ts";

export const texts: Translation<typeof en.aim> = {
  "aim.tip": "Treffpunkt",
  "aim.tip-hint":
    "Klicken Sie auf den Ball, oder nehmen Sie die Pfeiltasten: links und rechts für Effet, oben für Nachläufer, unten für Rückläufer. Außerhalb des gestrichelten Kreises rutscht das Queue ab.",
  "aim.stroke": "Stoß",
  "aim.side": "Seite",
  "aim.height": "Höhe",
  "aim.centre": "Mitte",
  "aim.speed": "Tempo",
  "aim.speed-unit": "Einheit des Tempos",
  "aim.elevation": "Neigung",
  "aim.automatic": "Automatisch",
  "aim.automatic-elevation": "Neigung automatisch",
  "aim.automatic-hint":
    "Automatisch: die kleinste Neigung eines wirklichen Stoßes, bei der das Queue über Banden und Kugeln passt",
  "aim.direction": "Richtung",
  "aim.left": "‹ {degrees}°",
  "aim.right": "{degrees}° ›",
  "aim.turn-left": "Queue um {degrees}° nach links drehen",
  "aim.turn-right": "Queue um {degrees}° nach rechts drehen",
  "aim.fine": "Fein",
  "aim.fine-hint": "Feineinstellung: Ziehen und Tasten wirken nur ein Zehntel so stark (F)",
  "aim.fine-on": "Feineinstellung ein",
  "aim.fine-off": "Feineinstellung aus",
  "aim.struck": "Gestoßene Kugel",
  "aim.raise": "Queue anheben",
  "aim.shoot": "Stoßen",
  "aim.take": "Von hier weiterspielen",
  "aim.take-short": "Weiter",
  "aim.other-struck": "{ball} liegt nicht mehr auf dem Tisch: Gestoßen wird jetzt {struck}",
  "aim.no-ball-left":
    "Auf dem Tisch liegt keine Kugel mehr: Nehmen Sie den Stoß zurück, oder bauen Sie unter Lage neu auf.",

  "face.role": "Treffpunkt der Pomeranze",
  "face.position": "Treffpunkt: {offset}",
  "face.right": "{percent} % Effet rechts",
  "face.left": "{percent} % Effet links",
  "face.follow": "{percent} % Nachläufer",
  "face.draw": "{percent} % Rückläufer",
  "face.both": "{side}, {height}",
  "face.centre": "Mitte",

  "unit.tips": "Pomeranzen",
  "unit.tips-short": "Pom.",
  "unit.degrees": "Grad",
  "unit.azimuth": "Grad gegen den Uhrzeigersinn, von der Richtung der kurzen Banden aus",
  "unit.metres": "Metern",
  "unit.millimetres": "Millimetern",
  "unit.metres-per-second": "Metern pro Sekunde",
  "unit.per-cent": "Prozent",
  "field.in-unit": " in {unit}",
  "field.not-a-number": "{name}: Schreiben Sie eine Zahl.",
  "field.not-a-seed": "Startwert: Schreiben Sie eine ganze Zahl ab 0.",

  "change.tip": "Treffpunkt verschieben",
  "change.centre": "Treffpunkt in die Mitte",
  "change.speed": "Tempo ändern",
  "change.elevation": "Queue anheben",
  "change.automatic": "Neigung automatisch",
  "change.aim": "Zielen",
  "change.aim-at": "Zielen auf {ball}",
  "change.struck": "andere Kugel stoßen",
  "change.strike": "{ball} stoßen",
  "change.take": "von hier weiterspielen",

  "power.label": "Stärke",
  "power.speed": "{speed} {unit}, {word}",
  "power.soft": "weich",
  "power.lag": "Ausstoßen",
  "power.firm": "fest",
  "power.hard": "hart",
  "power.break": "Anstoß",

  "aim.guides": "Tangente und natürlicher Winkel",
  "aim.guides-hint":
    "Hinter der Geisterkugel: wohin ein gleitender Spielball läuft, und wohin ein rollender.",

  "aim.diamonds": "Diamantsystem",
  "aim.diamonds-hint":
    "Für einen Vorbänder oder die Bande eines Balls: die Zahlen eines veröffentlichten Systems, wo die Linie die Diamanten kreuzt, sein Ziel (Ring) und wo der Ball ankommt (Punkt).",

  "diamonds.corner-five": "Corner-Five: {from} − {over} = {predicted}.",
  "diamonds.plus": "Plus-System: {from} + {over} = {predicted}.",
  "diamonds.two-to-one": "Zwei zu eins: 2 × {over} − {from} = {predicted}.",
  "diamonds.actual": "{said} Der Ball kommt bei {actual} an: {difference} Diamanten daneben.",
  "diamonds.equal": "{said} Der Ball kommt dort an.",
  "diamonds.not-there": "{said} Der Ball kommt nicht dorthin.",
  "diamonds.none":
    "Zu dieser Linie passt kein Diamantsystem: Zielen Sie über eine, zwei oder drei Banden.",
};
