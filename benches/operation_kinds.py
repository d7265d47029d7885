"""Operations of every kind of impact and search of the engine.

    python benches/operation_kinds.py

Stored in ``validation/leckie_greenspan_2006/operation_kinds.json``. The program
``crates/carom-peers/examples/kinds.rs`` does each kind once for each of its inputs. valgrind's
callgrind counts how often each instruction is executed, and the disassembly tells which of them are
additions, subtractions, multiplications, divisions or square roots of doubles; an instruction on a
vector counts once for each of its doubles. The counts are the same in each run of one compiled
program, but another compiler may give slightly different ones. It takes a minute.
"""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path
from typing import Any

import callgrind
from carom.bench import goldens

ROOT = Path(__file__).resolve().parents[1]
STORED = ROOT / "validation" / "leckie_greenspan_2006" / "operation_kinds.json"
#: The arithmetic of doubles, with and without AVX: scalar (s) or packed (p).
ARITHMETIC = re.compile(r"v?(add|sub|mul|div|sqrt)([sp])d$")
#: Single doubles in a packed instruction, by the register that it names.
LANES = {"ymm": 4, "xmm": 2}


def main() -> int:
    """Counts and stores."""
    missing = [tool for tool in ("valgrind", "objdump") if shutil.which(tool) is None]
    if missing:
        print(f"not installed: {', '.join(missing)}; apt install valgrind binutils")
        return 1
    stamp = goldens.stamp("python benches/operation_kinds.py")
    program = callgrind.build("carom-peers", "kinds")
    kinds = count(program)
    compiler = subprocess.run(["rustc", "--version"], check=True, capture_output=True, text=True)
    result = stamp | {"compiler": compiler.stdout.strip(), "kinds": kinds}
    STORED.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    for kind in kinds:
        print(f"{kind['group']:36} {kind['name']:48} {kind['operations']:10.1f}")
    return 0


def count(program: Path) -> list[dict[str, Any]]:
    """Mean operations and instructions of one impact or search of each kind."""
    weights = arithmetic(program)
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "counts"
        lines = run(program, out)
        return [
            kind | per_input(executed(Path(f"{out}.{k}")), weights, kind["inputs"])
            for k, kind in enumerate(map(json.loads, lines), start=1)
        ]


def run(program: Path, out: Path) -> list[str]:
    """Runs the program under callgrind, which writes `out`.1, `out`.2 …; returns its output."""
    options = ("--dump-instr=yes", "--compress-pos=no", "--compress-strings=no")
    command = ["valgrind", "--tool=callgrind", *options, "--collect-atstart=no"]
    command += ["--toggle-collect=*counted_pass*", "--dump-after=*end_of_kind*"]
    command += [f"--callgrind-out-file={out}", str(program)]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()


def executed(file: Path) -> Counter[tuple[str, int]]:
    """How often each instruction was executed: the object file's name and the address in it."""
    counts: Counter[tuple[str, int]] = Counter()
    name, skip = "", False
    for line in file.read_text(encoding="utf-8").splitlines():
        if line.startswith("ob="):
            name = Path(line[3:]).name
        elif line.startswith("calls="):
            skip = (
                True  # The next line has the cost of the called function, which is listed itself.
            )
        elif line.startswith("0x"):
            if not skip:
                address, _, instructions = line.split()
                counts[name, int(address, 16)] += int(instructions)
            skip = False
    return counts


def arithmetic(program: Path) -> dict[tuple[str, int], tuple[str, int]]:
    """The arithmetic instructions of a program: the operation and the doubles that it acts on."""
    command = ["objdump", "--disassemble", "--no-show-raw-insn", str(program)]
    listing = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    found = {}
    for line in listing.splitlines():
        fields = line.split(None, 2)
        if len(fields) == 3 and (match := ARITHMETIC.match(fields[1])):
            operation, form = match.groups()
            lanes = LANES["ymm" if "ymm" in fields[2] else "xmm"] if form == "p" else 1
            found[program.name, int(fields[0].rstrip(":"), 16)] = (operation, lanes)
    return found


def per_input(
    counts: Counter[tuple[str, int]],
    weights: dict[tuple[str, int], tuple[str, int]],
    inputs: int,
) -> dict[str, float]:
    """Means per input: operations, of which divisions and square roots, and instructions."""
    sums: Counter[str] = Counter()
    for place, times in counts.items():
        if place in weights:
            operation, lanes = weights[place]
            sums[operation] += lanes * times

    def mean(total: int) -> float:
        return round(total / inputs, 1)

    return {
        "operations": mean(sums.total()),
        "divisions": mean(sums["div"]),
        "square_roots": mean(sums["sqrt"]),
        "instructions": mean(counts.total()),
    }


if __name__ == "__main__":
    sys.exit(main())
