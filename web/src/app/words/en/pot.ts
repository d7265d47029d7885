/** Aiming by ball and pocket. */
export const texts = {
  "pot.aimed": "{ball} to the {pocket} pocket: {how}, ± {margin}°.",
  "pot.tap-pocket": "Tap a pocket to aim {ball} at it.",
  "pot.unsolved":
    "{ball} to the {pocket} pocket: no line with this stroke. Change the speed or the spin.",
  "pot.cut": "{hit}, a cut of {degrees}°",
  "pot.straight": "{hit}, straight",
  "pot.no-line":
    "No line for {ball} at the {pocket} pocket with this stroke. Try another speed or spin.",
  "pot.no-line-at-all": "No line for {ball} with this stroke. Try another speed or spin.",
  "pot.no-pockets": "This table has no pockets.",
  "pot.no-ball": "No object ball is selected: press N to select one.",

  "pot.hit.full": "full hit",
  "pot.hit.nearly-full": "nearly full hit",
  "pot.hit.three-quarter": "three-quarter ball",
  "pot.hit.half": "half ball",
  "pot.hit.quarter": "quarter ball",
  "pot.hit.thin": "thin cut",
  "pot.hit.very-thin": "very thin cut",

  "pot.kind.direct": "direct",
  "pot.kind.bank": "bank",
  "pot.kind.kick": "kick",
  "pot.kind.combination": "combination",
  "pot.kind.jump": "jump",
  "pot.kind.massé": "massé",

  "change.aim-pot": "aim {ball} at the {pocket} pocket",
} as const;
