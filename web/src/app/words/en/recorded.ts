/** Frames of matches between programs. */
export const texts = {
  "recorded.match": "Match {first} – {second}",
  "recorded.finished": {
    one: "{game}, {count} frame. Choose it to look at its shots.",
    other: "{game}, {count} frames. Choose one to look at its shots.",
  },
  "recorded.goes-on": {
    one: "{game}, {count} frame so far. The match goes on.",
    other: "{game}, {count} frames so far. The match goes on.",
  },
  "recorded.frame": "Frame {number}",
  "recorded.players": "{first} against {second}:",
  "recorded.won": "{name} won, {why};",
  "recorded.no-winner": "no winner, {why};",
  "recorded.shots": { one: "{count} shot", other: "{count} shots" },
  "recorded.close": "Close",
  "recorded.frames": "Frames of the match",
  "recorded.of-match": "Frame {number} of a match.",
  "recorded.no-end": "The frame goes on.",
  "recorded.differs":
    "Shot {number} does not end as the record says. It was made by {made}, and this page has {own}: open it with that version.",
  "recorded.split":
    "Chance of {name} to win: solid lines are decisions, dashed lines are luck. Press a step to see its shot.",
  "recorded.expected":
    "Chance of {name} to win, as the players expected it. Press a step to see its shot.",
  "recorded.curve": "Chance of {name} to win, from {from} % to {to} %",
  "recorded.step-decision": "Shot {number}, decision: {change} %, to {chance} %",
  "recorded.step-luck": "Shot {number}, luck: {change} %, to {chance} %",
  "recorded.step-both": "Shot {number}: {change} %, to {chance} %",
  "recorded.intended": "intended",
  "recorded.executed": "executed",
  "recorded.azimuth": "azimuth °",
  "recorded.elevation": "elevation °",
  "recorded.side": "side, tips",
  "recorded.height": "height, tips",
  "recorded.chance": "Expected to win: {chance} %.",
  "recorded.luck": "Decision {decision} %, luck {luck} %.",
  "recorded.refused": {
    one: "{count} answer was refused before.",
    other: "{count} answers were refused before.",
  },
  "change.open-frame": "open a frame of a match",
} as const;
