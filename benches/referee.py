"""Instructions of the referee: what it adds to a simulation, and what a player in Python adds.

    python benches/referee.py                  # some minutes; needs valgrind

The counts are stored in ``benches/results/referee.json``.

*The referee.* The example `referee_cost` of carom-arena plays frames with prepared plays once and
twice, and simulates their shots once more alone. The differences are the instructions of the frames
and of the simulations.

*A player in Python* returns prepared plays. callgrind counts a match of one pair, and one of more
pairs; the difference is that of the shots of the others. Instructions of the extension module that
convert are counted with those of the shot.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path
from typing import Any

import callgrind
from carom.bench import report

#: Pairs of frames that are counted.
PAIRS = 5
STORED = Path(__file__).parent / "results" / "referee.json"
#: Largest number of requests of a player in a frame.
GAMES = {"nine-ball": 12, "three-cushion": 40}

PROGRAM = """
import json, sys
import carom
from carom.arena import MatchPlan, play_pair

game, most, pairs = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
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
for number in range(pairs):
    play_pair(plan, number)
print(count)
"""


def instructions(game: str, most: int, pairs: int, folder: Path) -> tuple[Counter[str], int]:
    """Instructions by the object file in which they are, and the number of answered requests."""
    out = folder / "callgrind.out"
    command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", sys.executable]
    done = subprocess.run(
        [*command, "-c", PROGRAM, game, str(most), str(pairs)],
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


def of_python(game: str, most: int) -> dict[str, Any]:
    """The counts of a request to a player in Python, with the shot that it asks for."""
    with tempfile.TemporaryDirectory() as folder:
        once, none = instructions(game, most, 1, Path(folder))
        more, shots = instructions(game, most, 1 + PAIRS, Path(folder))
    added = more - once
    libc = sum(n for place, n in added.items() if "/libc." in place)
    engine = sum(n for place, n in added.items() if "_core." in place)
    return {
        "requests": shots - none,
        "instructions_of_a_request": round(added.total() / (shots - none)),
        "of_them_in_the_extension": round(engine / (shots - none)),
        "of_them_in_libc": round(libc / (shots - none)),
        "of_them_in_python": round((added.total() - engine - libc) / (shots - none)),
    }


def of_referee(program: Path, game: str) -> dict[str, Any]:
    """The counts of a shot in a frame of the arena, and of its simulation alone."""
    once, printed = callgrind.count(program, game, 1, 0)
    twice, _ = callgrind.count(program, game, 2, 0)
    alone, _ = callgrind.count(program, game, 1, 1)
    shots, frames, simulations = int(printed), twice - once, alone - once
    return {
        "shots": shots,
        "instructions_of_a_shot": round(frames / shots),
        "of_its_simulation": round(simulations / shots),
        "overhead": round(frames / simulations - 1, 4),
    }


def main() -> None:
    """Count and store a request and a shot of each game."""
    program = callgrind.build("carom-arena", "referee_cost")
    result = report.where() | {
        "referee": {game: of_referee(program, game) for game in GAMES},
        "python": {game: of_python(game, most) for game, most in GAMES.items()},
    }
    STORED.write_text(json.dumps(result, indent=2) + "\n", encoding="utf-8")
    print(json.dumps(result, indent=2))


if __name__ == "__main__":
    main()
