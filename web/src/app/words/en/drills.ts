/** The drills: names, goals, and the books whose themes they have. */
export const texts = {
  "drill.stop": "Stop shot",
  "drill.stun": "Stun along the tangent",
  "drill.follow": "Follow in steps",
  "drill.draw": "Draw in steps",
  "drill.straight": "Straight-ins by distance",
  "drill.cuts": "Cut ladder",
  "drill.thin": "Thin cuts",
  "drill.spot": "Spot shot",
  "drill.wheel": "Wagon wheel",
  "drill.rail": "Balls on the rail",
  "drill.lag": "Speed lag",
  "drill.kick": "Kick off one rail",
  "drill.bank": "Cross-side bank",
  "drill.safety": "Safety behind a ball",
  "drill.break": "Break and keep the middle",
  "drill.three": "Two balls, then the 8",
  "drill.ghost": "Ghost: 7, 8, 9",
  "drill.long": "Long pots",
  "drill.colours": "Clear the colours",
  "drill.cushions": "Three-cushion natural",

  "drill-goal.stop":
    "Pot the 1 and stop the cue ball in the circle. The distance grows with every success.",
  "drill-goal.stun": "Pot the 1 and leave the cue ball near the mark.",
  "drill-goal.follow":
    "Pot the 1 and roll the cue ball forward into the circle. The way grows with every success.",
  "drill-goal.draw":
    "Pot the 1 and draw the cue ball back into the circle. The way grows with every success.",
  "drill-goal.straight":
    "Pot the 1. It lies halfway between the cue ball and the pocket, and farther away after every success.",
  "drill-goal.cuts": "Pot the 1. The cut grows from 15° to 65° with every success.",
  "drill-goal.thin": "Cut the 1 thinly into the pocket.",
  "drill-goal.spot": "Place the cue ball behind the head string and pot the 1 from the foot spot.",
  "drill-goal.wheel":
    "Pot the 1 in the side pocket and leave the cue ball in the circle: five circles in turn.",
  "drill-goal.rail": "Pot the 1, which touches the rail. The angle gets harder with every success.",
  "drill-goal.lag": "Play the cue ball up the table and back, and stop it near the head rail.",
  "drill-goal.kick": "The 8 is in the way: hit the 9 off one rail or more.",
  "drill-goal.bank": "Bank the 1 off a rail into the side pocket.",
  "drill-goal.safety": "Hit the 9 and hide the cue ball from it behind the 8.",
  "drill-goal.break":
    "Break: the 1 first, a ball falls, the cue ball stays. It counts double in the middle.",
  "drill-goal.three":
    "Place the cue ball, pot the 1 and the 2 in any order, then the 8, without a miss.",
  "drill-goal.ghost":
    "Place the cue ball and run out: hit the lowest ball first. The run ends with a miss.",
  "drill-goal.long": "Place the cue ball in the D and pot the red in the far corner.",
  "drill-goal.colours":
    "Place the cue ball and pot the colours from yellow to black, without a miss.",
  "drill-goal.cushions": "Hit both balls, the second one after three cushions or more.",

  "drill-source.stop": "A theme of Byrne’s Standard Book of Pool and Billiards (1978).",
  "drill-source.follow": "A theme of Byrne’s Standard Book of Pool and Billiards (1978).",
  "drill-source.draw": "A theme of Byrne’s Standard Book of Pool and Billiards (1978).",
  "drill-source.bank": "A theme of Byrne’s Standard Book of Pool and Billiards (1978).",
  "drill-source.cushions": "A theme of Byrne’s Standard Book of Pool and Billiards (1978).",
  "drill-source.spot": "A theme of Martin and Reeves, The 99 Critical Shots in Pool (1977).",
} as const;
