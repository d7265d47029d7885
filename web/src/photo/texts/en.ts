/** The texts of the layout from a photo. `{name}` stands for a value. */

export const texts = {
  open: "Layout from a photo",
  title: "Layout from a photo",
  close: "Close",
  table: "Table",
  presentTable: "The present table",
  choose: "Choose or take a photo",
  another: "Another photo",
  drop: "Photograph the whole table with all pockets, as steeply from above as you can. You can also drop a photo here, or paste it.",
  privacy: "The photo stays on this device.",
  file: "Photo of a table",
  photo: "Photo of the table. Arrow keys move the cross, Enter sets a point.",
  pockets:
    "Tap the middle of each pocket's hole, at the height of the cloth: the corners and the side pockets, in any order. Hold and move for the magnifier. {count} of 6.",
  corners:
    "Tap the four corners of the edge of the cushions, and the middles of the long cushions, in any order. Hold and move for the magnifier. {count} of 6.",
  four: "Continue with the corners only",
  balls: "Tap the middle of {ball}. Hold and move for the magnifier; drag a ball to move it.",
  found:
    "Balls that were found: {count} (dashed). Tap one to confirm it, then choose another number if it is wrong; drag it to move it. Tap a ball that is missing.",
  lens: "The lens bends straight lines by {percent} %. The page allows for it; a photo from farther away, without wide angle, is more exact.",
  all: "All balls are on the table. Drag a ball to move it.",
  accuracy: "Balls are within about {error} mm.",
  misfit:
    "These points do not look like this table. Drag them onto its pockets, or choose the table.",
  ballsLarge: "The balls look too large for this table. Choose the table.",
  ballsSmall: "The balls look too small for this table. Choose the table.",
  looksLike: "They fit: {table}.",
  noCamera:
    "No table looks like these points. Undo, and tap the four corners and then the two middles.",
  offTable: "This point is not on the table. Tap the middle of a ball.",
  noLayout: "These balls do not fit on the table. Remove a ball, or move one.",
  notPhoto: "{file} is not a photo that this browser can show. Choose a JPEG, PNG or WebP file.",
  tooLarge: "{file} has {size} MB, too much for a photo. Choose a smaller one.",
  tooSmall: "{file} is too small to find balls in. Choose a photo of at least {least} pixels.",
  noRails: "An unbounded cloth has no corners. Choose a table.",
  tray: "Ball to place",
  cue: "the cue ball",
  "ball.cue": "cue ball",
  "ball.white": "white",
  "ball.yellow": "yellow",
  "ball.red": "red",
  "ball.green": "green",
  "ball.brown": "brown",
  "ball.blue": "blue",
  "ball.pink": "pink",
  "ball.black": "black",
  ball: "ball {id}",
  placed: "{ball}, on the table",
  landmark: "Point {number} of the table. Arrow keys move it.",
  handle: "{ball} in the photo. Arrow keys move it, Delete removes it.",
  suggestedHandle:
    "{ball} in the photo, found by the page. Enter confirms it, arrow keys move it, Delete removes it.",
  preview: "The layout so far. Number of balls: {count}",
  undo: "Undo",
  remove: "Remove",
  turn: "Turn round",
  use: "Use this layout",

  // Tables as players call them; others are shown by their name.
  "table.wpa-9ft": "Pool, 9 ft",
  "table.wpa-8ft": "Pool, 8 ft",
  "table.bar-7ft": "Pool, 7 ft",
  "table.showood-7ft": "Pool, Showood 7 ft",
  "table.snooker-12ft": "Snooker, 12 ft",
  "table.english-7ft": "English pool, 7 ft",
  "table.carom-10ft": "Carom, 10 ft",
  "table.carom-9ft": "Carom, 9 ft",
  "table.chinese-9ft": "Chinese eight-ball (heyball), 9 ft",
  "table.poolfiz": "Poolfiz",
} as const;

/** The same texts in any language. */
export type PhotoTexts = Readonly<Record<keyof typeof texts, string>>;
