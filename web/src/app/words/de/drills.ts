import type * as en from "../en/index.ts";
import type { Translation } from "../entry.ts";

export const texts: Translation<typeof en.drills> = {
  "drill.stop": "Stoppball",
  "drill.stun": "Stun entlang der Tangente",
  "drill.follow": "Nachläufer in Stufen",
  "drill.draw": "Rückläufer in Stufen",
  "drill.straight": "Gerade Stöße nach Abstand",
  "drill.cuts": "Schnittleiter",
  "drill.thin": "Dünne Schnitte",
  "drill.spot": "Kugel vom Fußpunkt",
  "drill.wheel": "Wagenrad",
  "drill.rail": "Kugeln an der Bande",
  "drill.lag": "Tempo: auf und ab",
  "drill.kick": "Vorbande",
  "drill.bank": "Bande quer in die Mitte",
  "drill.safety": "Sicherheit hinter einer Kugel",
  "drill.break": "Anstoß, Spielball in der Mitte",
  "drill.three": "Zwei Kugeln, dann die 8",
  "drill.ghost": "Gegen den Geist: 7, 8, 9",
  "drill.long": "Lange Stöße",
  "drill.colours": "Farben abräumen",
  "drill.cushions": "Dreiband von außen",

  "drill-goal.stop":
    "Versenken Sie die 1, der Spielball bleibt im Kreis liegen. Nach jedem Erfolg wird der Abstand größer.",
  "drill-goal.stun": "Versenken Sie die 1 und legen Sie den Spielball nahe an die Marke.",
  "drill-goal.follow":
    "Versenken Sie die 1, der Spielball läuft nach vorn in den Kreis. Nach jedem Erfolg wird der Weg länger.",
  "drill-goal.draw":
    "Versenken Sie die 1 und ziehen Sie den Spielball zurück in den Kreis. Nach jedem Erfolg wird der Weg länger.",
  "drill-goal.straight":
    "Versenken Sie die 1. Sie liegt in der Mitte zwischen Spielball und Tasche, nach jedem Erfolg weiter weg.",
  "drill-goal.cuts": "Versenken Sie die 1. Der Schnitt wächst nach jedem Erfolg von 15° bis 65°.",
  "drill-goal.thin": "Schneiden Sie die 1 dünn in die Tasche.",
  "drill-goal.spot":
    "Legen Sie den Spielball hinter die Kopflinie und versenken Sie die 1 vom Fußpunkt.",
  "drill-goal.wheel":
    "Versenken Sie die 1 in der Mitteltasche, der Spielball bleibt im Kreis liegen: fünf Kreise der Reihe nach.",
  "drill-goal.rail":
    "Versenken Sie die 1, die an der Bande liegt. Nach jedem Erfolg wird der Winkel schwerer.",
  "drill-goal.lag":
    "Spielen Sie den Spielball hin und zurück, er bleibt nahe an der Kopfbande liegen.",
  "drill-goal.kick": "Die 8 ist im Weg: Treffen Sie die 9 über mindestens eine Bande.",
  "drill-goal.bank": "Spielen Sie die 1 über eine Bande in die Mitteltasche.",
  "drill-goal.safety": "Treffen Sie die 9 und verstecken Sie den Spielball vor ihr hinter der 8.",
  "drill-goal.break":
    "Anstoß: zuerst die 1, eine Kugel fällt, der Spielball bleibt. In der Mitte zählt er doppelt.",
  "drill-goal.three":
    "Legen Sie den Spielball, versenken Sie die 1 und die 2 in beliebiger Folge, dann die 8, ohne Fehler.",
  "drill-goal.ghost":
    "Legen Sie den Spielball und räumen Sie ab: zuerst die niedrigste Kugel treffen. Ein Fehler beendet die Serie.",
  "drill-goal.long":
    "Legen Sie den Spielball ins D und versenken Sie die Rote in der fernen Ecktasche.",
  "drill-goal.colours":
    "Legen Sie den Spielball und versenken Sie die Farben von Gelb bis Schwarz, ohne Fehler.",
  "drill-goal.cushions": "Treffen Sie beide Kugeln, die zweite nach mindestens drei Banden.",

  "drill-source.stop": "Ein Thema aus Byrne’s Standard Book of Pool and Billiards (1978).",
  "drill-source.follow": "Ein Thema aus Byrne’s Standard Book of Pool and Billiards (1978).",
  "drill-source.draw": "Ein Thema aus Byrne’s Standard Book of Pool and Billiards (1978).",
  "drill-source.bank": "Ein Thema aus Byrne’s Standard Book of Pool and Billiards (1978).",
  "drill-source.cushions": "Ein Thema aus Byrne’s Standard Book of Pool and Billiards (1978).",
  "drill-source.spot": "Ein Thema aus Martin und Reeves, The 99 Critical Shots in Pool (1977).",
};
