/** The texts of the layout from a photo in German. */

import type { PhotoTexts } from "./en.ts";

export const texts: PhotoTexts = {
  open: "Lage aus einem Foto",
  title: "Lage aus einem Foto",
  close: "Schließen",
  table: "Tisch",
  presentTable: "Der jetzige Tisch",
  choose: "Foto wählen oder aufnehmen",
  another: "Anderes Foto",
  drop: "Fotografieren Sie den ganzen Tisch mit allen Taschen, so steil von oben wie möglich. Sie können ein Foto auch hierher ziehen oder einfügen.",
  privacy: "Das Foto bleibt auf diesem Gerät.",
  file: "Foto eines Tisches",
  photo: "Foto des Tisches. Die Pfeiltasten bewegen das Kreuz, die Eingabetaste setzt einen Punkt.",
  pockets:
    "Tippen Sie in die Mitte jedes Taschenlochs auf der Höhe des Tuchs: Ecken und Mitteltaschen, in beliebiger Reihenfolge. Halten und Bewegen zeigt die Lupe. {count} von 6.",
  corners:
    "Tippen Sie auf die vier Ecken der Bandenkanten und auf die Mitten der langen Banden, in beliebiger Reihenfolge. Halten und Bewegen zeigt die Lupe. {count} von 6.",
  four: "Nur mit den Ecken weiter",
  balls:
    "Tippen Sie auf die Mitte: {ball}. Halten und Bewegen zeigt die Lupe; ziehen Sie eine Kugel, um sie zu verschieben.",
  found:
    "Gefundene Kugeln: {count} (gestrichelt). Tippen Sie eine an, um sie zu bestätigen, und wählen Sie dann eine andere Nummer, wenn sie falsch ist; ziehen Sie sie, um sie zu verschieben. Tippen Sie auf eine Kugel, die fehlt.",
  lens: "Das Objektiv biegt gerade Linien um {percent} %. Die Seite rechnet es heraus; ein Foto aus größerer Entfernung, ohne Weitwinkel, ist genauer.",
  all: "Alle Kugeln liegen auf dem Tisch. Ziehen Sie eine Kugel, um sie zu verschieben.",
  accuracy: "Die Kugeln liegen auf etwa {error} mm genau.",
  misfit:
    "Diese Punkte passen nicht zu diesem Tisch. Ziehen Sie sie auf seine Taschen, oder wählen Sie den Tisch.",
  ballsLarge: "Die Kugeln sind zu groß für diesen Tisch. Wählen Sie den Tisch.",
  ballsSmall: "Die Kugeln sind zu klein für diesen Tisch. Wählen Sie den Tisch.",
  looksLike: "Sie passen zu: {table}.",
  noCamera:
    "Kein Tisch sieht so aus. Machen Sie die Punkte rückgängig, und tippen Sie auf die vier Ecken und dann auf die zwei Mitten.",
  offTable: "Dieser Punkt liegt nicht auf dem Tisch. Tippen Sie auf die Mitte einer Kugel.",
  noLayout: "Diese Kugeln passen nicht auf den Tisch. Entfernen oder verschieben Sie eine.",
  notPhoto:
    "{file} ist kein Foto, das dieser Browser zeigen kann. Wählen Sie eine JPEG-, PNG- oder WebP-Datei.",
  tooLarge: "{file} hat {size} MB, zu viel für ein Foto. Wählen Sie ein kleineres.",
  tooSmall:
    "{file} ist zu klein, um Kugeln darin zu finden. Wählen Sie ein Foto mit mindestens {least} Bildpunkten.",
  noRails: "Ein unbegrenztes Tuch hat keine Ecken. Wählen Sie einen Tisch.",
  tray: "Nächste Kugel",
  cue: "der Spielball",
  "ball.cue": "Spielball",
  "ball.white": "Weiße",
  "ball.yellow": "Gelbe",
  "ball.red": "Rote",
  "ball.green": "Grüne",
  "ball.brown": "Braune",
  "ball.blue": "Blaue",
  "ball.pink": "Pinke",
  "ball.black": "Schwarze",
  ball: "Kugel {id}",
  placed: "{ball}, auf dem Tisch",
  landmark: "Punkt {number} des Tisches. Die Pfeiltasten bewegen ihn.",
  handle: "{ball} im Foto. Die Pfeiltasten bewegen sie, Entf entfernt sie.",
  suggestedHandle:
    "{ball} im Foto, von der Seite gefunden. Die Eingabetaste bestätigt sie, die Pfeiltasten bewegen sie, Entf entfernt sie.",
  preview: "Die bisherige Lage. Anzahl der Kugeln: {count}",
  undo: "Rückgängig",
  remove: "Entfernen",
  turn: "Umdrehen",
  use: "Diese Lage übernehmen",

  "table.wpa-9ft": "Pool, 9 Fuß",
  "table.wpa-8ft": "Pool, 8 Fuß",
  "table.bar-7ft": "Pool, 7 Fuß",
  "table.showood-7ft": "Pool, Showood 7 Fuß",
  "table.snooker-12ft": "Snooker, 12 Fuß",
  "table.english-7ft": "English Pool, 7 Fuß",
  "table.carom-10ft": "Karambol, 10 Fuß",
  "table.carom-9ft": "Karambol, 9 Fuß",
  "table.chinese-9ft": "Chinesisches 8-Ball (Heyball), 9 Fuß",
  "table.poolfiz": "Poolfiz",
};
