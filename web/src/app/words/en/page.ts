/** The frame of the page: header, tabs, help, keys, first steps. */
export const texts = {
  "page.skip": "Skip to the table",
  "page.history": "History",
  "page.camera": "Camera",
  "page.table": "Table",
  "page.table-role": "billiards table",
  "page.table-keys":
    "Table. Arrow keys turn the cue and change its speed, Enter shoots, question mark lists all keys.",
  "page.draw": "Draw",
  "page.shot": "Shot",
  "page.settings": "Settings",

  "history.undo": "Undo",
  "history.redo": "Redo",
  "history.undo-change": "Undo: {change}",
  "history.redo-change": "Redo: {change}",
  "history.undone": "Undone: {change}",
  "history.redone": "Redone: {change}",
  "history.nothing-to-undo": "There is nothing to undo.",
  "history.nothing-to-redo": "There is nothing to redo.",

  "page.tools": "Tools",
  "page.activity": "Activity",
  "activity.analyse": "Analyse",
  "activity.play": "Play",
  "activity.train": "Train",
  "activity.library": "Library",

  "camera.top": "From above",
  "camera.orbit": "Free camera: drag to turn it",
  "camera.cue": "Behind the cue",

  "theme.auto": "Theme: as the system",
  "theme.light": "Theme: light",
  "theme.dark": "Theme: dark",
  "page.help": "Help and keys",

  "page.close-sheet": "Close the settings",
  "page.hide-panel": "Hide the settings",
  "page.show-panel": "Show the settings",
  "tab.state": "Replay",
  "tab.aim": "Aim",
  "tab.lines": "Best",
  "tab.tree": "Shots",
  "tab.layout": "Layout",
  "tab.physics": "Physics",
  "tab.game": "Game",
  "tab.whatif": "What if",
  "tab.train": "Drills",
  "tab.library": "Library",

  "steps.title": "First steps",
  "steps.pot":
    "Pot the 9: drag on the table until the line clicks into the lit pocket, then shoot.",
  "steps.stop": "Now pot the 1 and leave the cue ball in the circle: strike it lower, and harder.",
  "steps.well-done": "Well done.",
  "steps.again": "Not yet.",
  "steps.end":
    "Well done. Best names the best shots of any position; under Play you play the machine, under Train you practise.",
  "steps.skip": "Skip",
  "steps.wait": "The first steps wait: Undo brings them back.",
  "language.label": "Language",
  "language.hint": "The page loads again, with everything as it is now.",
  "language.not-stored":
    "The browser does not let this page store the language: open the page in a tab of its own, or change the language of the browser.",

  "help.title": "How to use this table",
  "help.pot": "Pot",
  "help.pot-text":
    "Tap a ball, then a pocket. The aim stays solved while you change speed, spin and elevation.",
  "help.aim": "Aim",
  "help.aim-text":
    "Drag on the cloth to turn the cue; it clicks into pots. Or tap the cloth to aim at that point. A finger that moves slowly aims finely, and so does the wheel at the edge of the table.",
  "help.strike": "Strike",
  "help.strike-text":
    "Click the ball under Aim to place the tip: English, follow or draw. Set speed, elevation and direction beside it.",
  "help.ahead": "Look ahead",
  "help.ahead-text":
    "While you aim, the page simulates the whole shot, draws the paths of the balls, and describes the outcome below the table.",
  "help.shoot": "Shoot",
  "help.shoot-text":
    "Plays the shot. Or press on the cue, pull it back and release it: the pull sets the speed, and at its start nothing is played. “Take it from here” continues from where the balls stop.",
  "help.move": "Move balls",
  "help.move-text":
    "Drag a ball to move it. At a place that is not allowed it turns red, the page gives the reason, and the ball goes back.",
  "help.draw": "Draw",
  "help.draw-text":
    "With the pencil above the table, lines, arrows, circles, areas and labels are drawn on it; they snap to balls, pockets, diamonds and contacts. Links, files and pictures have them.",
  "help.game": "Play a game",
  "help.game-text":
    "Under Play, persons and machines play a frame with a referee. A call that is required follows the aim; tap a ball and a pocket to call others. Undo also takes back shots.",
  "help.keep": "Continue later",
  "help.keep-text":
    "Close the page whenever you like: it offers to continue when you open it again. Under Play it lists your games, saves everything as a file and reads it back.",
  "help.else": "Everything else",
  "help.else-text":
    "Layout has racks, tables and balls; Physics has cloth, balls and rails, and their numbers.",
  "help.keys": "Keys",
  "help.keys-hint": "Arrow keys, Enter and Space work while the table has the focus.",
  "help.software": "Software inside this page, and its licenses",
  "help.licenses": "Licenses",
  "help.steps": "Show the first steps",
  "help.close": "Close",

  "key.turn": "Turn the cue by 1°; with Shift by 0.1°",
  "key.speed": "Change the cue speed by 0.1 m/s; with Shift by 0.01 m/s",
  "key.shoot": "Shoot",
  "key.next-ball": "Select the next ball; with Shift the previous one",
  "key.aim-at": "Aim at the centre of the selected ball",
  "key.no-ball": "No ball is selected: press N to select one.",
  "key.pot":
    "Aim the selected ball at a pocket; again: at the next pocket, with Shift the previous one",
  "key.fine": "Fine adjustment on or off: drags and keys have a tenth of their effect",
  "key.sound": "Sound of the replay on or off",
  "key.play": "Play or pause the replay",
  "key.events": "In a replay: go to the previous or next event",
  "key.take": "Take it from here: the final positions become the new layout",
  "key.escape": "End the replay; while aiming: cancel a pull of the cue, clear the selection",
  "key.undo": "Undo",
  "key.redo": "Redo",
  "key.draw": "Draw on the table, or end it",
  "key.top": "View from above",
  "key.orbit": "Free camera",
  "key.cue": "View from behind the cue",
  "key.help": "Show this help",
  "keyname.enter": "Enter",
  "keyname.space": "Space",
  "keyname.escape": "Esc",
  "keyname.control": "Ctrl",
  "keyname.shift": "Shift",
} as const;
