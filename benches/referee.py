"""Instructions of the referee for a player in Python: what a request costs beside the shot.

    python benches/referee.py                  # some minutes; needs valgrind

A player returns prepared plays. callgrind counts a match in which it concedes at once, and one in
which it plays on. The difference is that of the shots. Instructions outside of the extension
module, that is in Python, are those of the requests and of the reading of the answers.
Instructions of the extension module that convert are counted as part of the shot.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

#: Largest number of requests of a player in a frame.
GAMES = {"nine-ball": 12, "three-cushion": 40}

PROGRAM = """
import json, sys
import carom
from carom.arena import MatchPlan, play_pair

game, most = sys.argv[1], int(sys.argv[2])
count = 0

FREE = [carom.Play(carom.Strike(3.0, 0.064 * k)) for k in range(97)]
STRIKES = [carom.Strike(5.0, 1.5 + 0.01 * k) for k in range(9)]
HAND = [carom.Play(strike, cue_ball=(0.5, 0.3)) for strike in STRIKES]

class Prepared:
    asked = 0

    def choose(self, situation):
        global count
        self.asked += 1
        if self.asked > most:
            return "concede"
        count += 1
        request = situation.frame.request
        if request.kind == "choice":
            return request.choices[0]
        if situation.refused is not None:
            return "concede"
        plays = HAND if request.in_hand else FREE
        return plays[self.asked % len(plays)]

plan = MatchPlan(Prepared, Prepared, game=game, secret="ab" * 32, simulations=1)
play_pair(plan, 0)
print(count)
"""


def instructions(game: str, most: int, folder: Path) -> tuple[Counter[str], int]:
    """Instructions by the object file in which they are, and the number of answered requests."""
    out = folder / "callgrind.out"
    command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", sys.executable]
    done = subprocess.run(
        [*command, "-c", PROGRAM, game, str(most)],
        check=True,
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONHASHSEED": "0"},
    )
    counts: Counter[str] = Counter()
    names: dict[str, str] = {}
    place, is_call = "", False
    for line in out.read_text(encoding="utf-8", errors="replace").splitlines():
        if line.startswith(("ob=", "cob=")):
            key, _, name = line.partition("=")[2].partition(" ")
            if name:
                names[key] = name
            if line.startswith("ob="):
                place = names[key]
        elif line.startswith("calls="):
            is_call = True
        elif line.startswith(tuple("+-*0123456789")):
            # The line after a call has the instructions of the called function.
            if not is_call:
                counts[place] += int(line.split()[1])
            is_call = False
    return counts, int(done.stdout)


def main() -> None:
    """Print the counts of a request and of a shot of each game."""
    found = {}
    for game, most in GAMES.items():
        with tempfile.TemporaryDirectory() as folder:
            without, none = instructions(game, 0, Path(folder))
            played, shots = instructions(game, most, Path(folder))
        added = played - without
        python = sum(n for place, n in added.items() if "carom" not in place)
        found[game] = {
            "requests": shots - none,
            "instructions_of_a_request": round(added.total() / (shots - none)),
            "of_them_in_python": round(python / (shots - none)),
        }
    print(json.dumps(found, indent=2))


if __name__ == "__main__":
    main()
