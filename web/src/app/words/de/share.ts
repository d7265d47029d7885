import type * as en from "../en/index.ts";
import type { Translation } from "../entry.ts";

export const texts: Translation<typeof en.share> = {
  "share.share": "Teilen",
  "share.title": "Diesen Stoß teilen",
  "share.close": "Schließen",
  "share.files": "Dateien",
  "share.python": "Als Python kopieren",
  "share.python-copied": "Python-Programm kopiert.",
  "share.game-python": "Spiel als Python kopieren",
  "share.game-copied": "Das Spiel ist als Python-Programm kopiert.",
  "share.record": "Aufzeichnung des Spiels herunterladen",
  "share.copy-shot": "Stoßdatei kopieren",
  "share.shot-copied": "Stoßdatei kopiert.",
  "share.download-shot": "Stoßdatei herunterladen",
  "share.download-trace": "Aufzeichnung herunterladen",
  "share.trace-downloaded": "Aufzeichnung heruntergeladen.",
  "share.no-trace":
    "Dieser Stoß hat keine Aufzeichnung: Ändern Sie ihn, bis er sich spielen lässt.",
  "share.picture": "Bild des Tisches, wie Sie ihn sehen",
  "share.png": "PNG herunterladen",
  "share.link-heading": "Link mit allem auf dieser Seite",
  "share.link": "Link",
  "share.copy-link": "Link kopieren",
  "share.link-copied": "Link kopiert.",
  "share.here":
    "Diesen Link öffnet nur dieser Computer, denn seine Adresse ist {host}. Andere brauchen eine Seite, die sie erreichen: Setzen Sie, was auf das # folgt, hinter deren Adresse.",
  "share.no-film":
    "Der Link enthält die gefilmten Wege nicht: Laden Sie die Stoßdatei herunter, um sie zu behalten.",
  "share.no-link":
    "Im Rahmen einer anderen Seite gibt es keinen Link: Kopieren Sie stattdessen die Stoßdatei.",
  "share.text": "Text zum Kopieren",
  "share.not-allowed":
    "Der Browser erlaubt dieser Seite das Kopieren nicht. Hier ist der Text, markiert:",

  "open.open": "Öffnen",
  "open.hint":
    "Einen Stoß, eine Aufzeichnung, ein Spiel, ein Match oder eine Analyse öffnen; Sie können die Datei auch auf die Seite ziehen",
  "open.file": "Stoßdatei oder Aufzeichnung",
  "open.drop": "Zum Öffnen ablegen",
  "open.opened": "{file} ist geöffnet.",
  "open.too-large":
    "{file} hat {megabytes} MB, zu viel für einen Stoß: Wählen Sie eine andere Datei.",
  "open.unreadable": "{file} lässt sich nicht lesen: Wählen Sie die Datei noch einmal.",
  "open.one": "Legen Sie nur eine Datei ab.",
  "open.link-opened": "Der Link ist geöffnet. Rückgängig führt zum vorigen Stoß.",
  "change.open-trace": "Aufzeichnung öffnen",
  "change.open-shot": "Stoß öffnen",
  "change.open-link": "Link öffnen",

  "link.refused":
    "Dieser Link lässt sich nicht öffnen. Kopieren Sie ihn noch einmal von der Seite. {why}",
  "link.no-shot": "Dieser Link enthält keinen Stoß.",
  "link.version":
    "Dieser Link stammt von einer anderen Version der Seite (er hat Version {version}, diese Seite liest Version {own}): Öffnen Sie ihn mit jener Version.",
  "link.too-long":
    "Dieser Link ist zu lang für einen Stoß: Kopieren Sie ihn noch einmal von der Seite.",
  "link.damaged":
    "Dieser Link ist beschädigt oder unvollständig: Kopieren Sie noch einmal den ganzen Link.",
  "link.moves":
    "Das Spiel in diesem Link hat {moves} Züge; diese Seite öffnet höchstens {most}: Beenden Sie das Spiel, und kopieren Sie den Link dann neu.",
  "link.game":
    "Das Spiel in diesem Link ist nicht lesbar: Bitten Sie um einen Link, der von dieser Seite kopiert ist.",
  "link.move": "Zug {number} dieses Spiels: {why}",

  "film.heading": "Video des Stoßes",
  "film.speed": "Tempo",
  "film.normal": "normal",
  "film.slower": { other: "{count}-mal langsamer" },
  "film.download": "Video herunterladen",
  "film.cancel": "Abbrechen",
  "film.encoded": "Fortschritt des Videos",
  "film.encoding": "Wird berechnet …",
  "film.ready": "Das Video ist fertig, {megabytes} MB.",
  "film.cancelled": "Abgebrochen.",
  "film.cannot":
    "Dieser Browser kann keine Videos erzeugen: Nehmen Sie Chrome, Edge, Firefox oder Safari in einer neuen Version.",

  "share.link-text": "Link als Text",
  "share.copy-text": "Als Text kopieren",
  "share.text-copied": "Text kopiert.",
  "share.save-text": "Als Datei speichern",
  "share.local":
    "Diese Seite ist eine Datei auf Ihrem Gerät; ihre Adresse lässt sich anderswo nicht öffnen. Senden Sie den Text oder die Datei: „Öffnen“ auf jeder carom-Seite liest die Datei, und der Text gehört hinter die Adresse einer Seite, die ein Server liefert, etwa „carom play“.",
};
