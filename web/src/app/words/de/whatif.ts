import type * as en from "../en/index.ts";
import type { Translation } from "../entry.ts";

export const texts: Translation<typeof en.whatif> = {
  "whatif.simulate": "Fehler der Person am Tisch berechnen",
  "whatif.intro": {
    other:
      "Niemand stößt genau so wie beabsichtigt. Geben Sie an, wie groß Ihre Fehler sind, und sehen Sie {count} Varianten dieses Stoßes.",
  },
  "whatif.result": "Ergebnis",
  "whatif.size": "Größe der Fehler (Standardabweichung)",
  "whatif.like": "Wie",
  "whatif.own": "Eigene Werte",
  "whatif.players": "Spielstärken (geschätzt)",
  "whatif.olympiad": "Computer-Olympiade",
  "whatif.olympiad-half": "Olympiade × ½",
  "whatif.olympiad-double": "Olympiade × 2",
  "whatif.random": "Zufallszahlen",
  "whatif.seed": "Startwert",
  "whatif.another": "Anderer",
  "whatif.seed-hint": "Derselbe Startwert gibt dieselben Fehler, hier und in Python.",
  "whatif.seed-range": "Startwert: Schreiben Sie eine ganze Zahl von 0 bis {largest}.",
  "whatif.cling": "Haften zwischen Kugeln",
  "whatif.legend-stops": "Farben auf dem Tuch: wo der Spielball stoppt",
  "whatif.few": "wenige Varianten",
  "whatif.many": "viele",
  "whatif.legend-paths": "Die weißen Linien sind die Wege des Spielballs in {count} der Varianten.",
  "whatif.no-worker":
    "Dieser Browser kann nicht im Hintergrund rechnen: Öffnen Sie die Seite in einem anderen.",

  "sigma.speed": "Tempo",
  "sigma.azimuth": "Richtung",
  "sigma.elevation": "Neigung",
  "sigma.side_m": "Treffpunkt, seitlich",
  "sigma.height_m": "Treffpunkt, Höhe",
  "sigma.cling_probability": "Haftende Kontakte",
  "sigma.cling_friction": "Deren Reibung",

  "chance.heading": "Aussicht, zu fallen",
  "chance.ball": "Kugel",
  "chance.scratch": "{ball} (Foul)",
  "chance.simulated": "Berechnete Varianten",
  "chance.simulating": "Wird berechnet …",
  "chance.count": {
    one: "{count} Variante in {milliseconds} ms",
    other: "{count} Varianten in {milliseconds} ms",
  },
  "chance.off": "{ball} verlässt den Tisch: {chance}",
  "chance.failed":
    "{failed} von {count} Varianten ließen sich nicht spielen; dort fällt keine Kugel: {why}",
  "chance.none": "In keiner Variante fällt eine Kugel.",
  "chance.of-ball": "{ball} {chance}",
  "chance.likely": "Aussicht, zu fallen: {balls}.",
  "chance.unknown": "noch nicht bekannt",
  "chance.less": "unter {percent}",
  "chance.more": "über {percent}",
  "chance.value": "{percent} ± {error}",
  "chance.percent": "{number} %",

  "change.noise-on": "Fehler berechnen",
  "change.noise-off": "ohne Fehler",
  "change.noise": "Fehler der Person",
  "change.sigma": "Fehler: {name}",
  "change.seed": "Startwert",
};
