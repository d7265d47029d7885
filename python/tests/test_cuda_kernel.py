"""The CUDA kernel without a card: its PTX is built, read, translated to C and run here."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from graphlib import TopologicalSorter
from importlib.util import find_spec
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
DRIVER = ROOT / "crates" / "carom-cuda" / "tests" / "driver.c"

# Bounds per thread, bytes, as ptxas 12.9 counts them for sm_70. A card reserves the stack for all
# threads that it can hold.
MOST_STACK = 32_768
MOST_SPILLS = 6_000


# gcc fuses operations with these.
FUSED = ("-ffp-contract=fast", "-fexpensive-optimizations", "-mfma")


@pytest.fixture(scope="session")
def ptx(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The kernel; the tests are skipped only without the nightly Rust that builds it."""
    path = tmp_path_factory.mktemp("kernel") / "carom.ptx"
    built = subprocess.run(
        ["bash", ROOT / "scripts" / "cuda_kernel.sh", path],
        check=False,
        capture_output=True,
        text=True,
    )
    if built.returncode == 3:
        pytest.skip(f"the kernel was not built: {built.stderr.strip()}")
    assert built.returncode == 0, built.stderr
    return path


@pytest.fixture(scope="session")
def translated(ptx: Path) -> Path:
    """The kernel in C."""
    path = ptx.with_suffix(".c")
    subprocess.run([sys.executable, ROOT / "scripts" / "ptx_to_c.py", ptx, path], check=True)
    return path


def driver(source: Path, folder: Path, *options: str) -> dict[str, str]:
    """The environment in which the driver is ``driver.c`` with the translated kernel."""
    folder.mkdir()
    compiler = ["gcc", "-O1", "-w", "-fPIC", "-shared", "-fno-strict-aliasing", *options]
    library = ["-Wl,-soname,libcuda.so.1", "-o", folder / "libcuda.so.1", source, DRIVER, "-lm"]
    subprocess.run([*compiler, *library], check=True)
    return os.environ | {"LD_LIBRARY_PATH": str(folder)}


@pytest.fixture(scope="session")
def exact(translated: Path) -> dict[str, str]:
    """The driver whose every operation rounds on its own, as the PTX says."""
    return driver(translated, translated.parent / "exact", "-ffp-contract=off")


def functions(text: str) -> dict[str, str]:
    """The body of every function of a PTX, by name."""
    head = re.compile(r"^(?:\.visible )?\.(?:func|entry)\s*(?:\([^)]*\))?\s*([\w$]+)", re.MULTILINE)
    found = list(head.finditer(text))
    ends = [match.start() for match in found[1:]] + [len(text)]
    return {
        match[1]: text[match.end() : end]
        for match, end in zip(found, ends, strict=True)
        if "{" in text[match.end() : end]
    }


def test_every_operation_on_doubles_rounds_on_its_own(ptx: Path) -> None:
    text = ptx.read_text(encoding="ascii")
    operations = re.findall(
        r"\b(?:add|sub|mul|div|sqrt|rcp|mad|fma|rsqrt)\.[\w.]*f(?:32|64)\b", text
    )
    assert len(operations) > 10_000
    kinds = set(operations)
    # ptxas fuses `add.f64` and `mul.f64`, but not these.
    assert kinds <= {f"{name}.rn.f64" for name in ("add", "sub", "mul", "div", "sqrt", "rcp")}


def test_no_function_calls_itself_or_an_unknown_one(ptx: Path) -> None:
    bodies = functions(ptx.read_text(encoding="ascii"))
    calls = {
        name: set(re.findall(r"\bcall(?:\.uni)?\s+(?:\([^)]*\),\s*)?([\w$]+)", body))
        for name, body in bodies.items()
    }
    # An indirect call names a register.
    assert not any(
        re.search(r"\bcall[.\w]*\s+(?:\([^)]*\),\s*)?%", body) for body in bodies.values()
    )
    assert set().union(*calls.values()) <= set(bodies)
    assert {"carom_play", "carom_sizes"} <= set(TopologicalSorter(calls).static_order())


@pytest.mark.stress
def test_ptxas_assembles_the_kernel_within_its_bounds(ptx: Path) -> None:
    package = find_spec("nvidia.cuda_nvcc") if find_spec("nvidia") else None
    if package is None or not package.submodule_search_locations:
        pytest.skip("ptxas is not installed: pip install --group gpu")
    ptxas = Path(package.submodule_search_locations[0]) / "bin" / "ptxas"
    ptxas.chmod(0o755)
    command = [ptxas, "-v", "--fmad=false", "-arch=sm_70", ptx, "-o", ptx.with_suffix(".cubin")]
    done = subprocess.run(command, check=False, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    # It cannot be computed where a function calls itself.
    assert "stack size cannot be statically determined" not in done.stderr.lower()
    stacks = [int(size) for size in re.findall(r"(\d+) bytes cumulative stack size", done.stderr)]
    spills = [int(size) for size in re.findall(r"(\d+) bytes spill stores", done.stderr)]
    assert 0 < max(stacks) <= MOST_STACK
    assert max(spills) <= MOST_SPILLS


# Plays the same shots on both and compares the bits; argument: the kernel.
COMPARE = """
import sys
from pathlib import Path
import numpy as np
import carom, carom.device

carom.device.KERNEL = Path(sys.argv[1])
shots = [carom.Shot.load(path) for path in sorted(Path(sys.argv[2]).glob("*.json"))]
same = lambda a, b: (
    np.array_equal(a.final_position.view(np.int64), b.final_position.view(np.int64))
    and np.array_equal(a.pocket, b.pocket) and np.array_equal(a.events, b.events)
    and a.errors == b.errors
)
results = [[carom.simulate_batch(shots, device=device) for device in ("cpu", "cuda")]]
noise = carom.Noise.preset("club")
for shot in shots:
    if shot.strike is not None:
        both = [shot.vary(noise, 12, seed=3, device=device) for device in ("cpu", "cuda:0")]
        results.append(both)
pot = next(shot for shot in shots if shot.strike is not None)
speeds = np.linspace(0.5, 5, 40)
results.append([pot.batch(speed=speeds, device=device) for device in ("cpu", "cuda")])
sweep = carom.Sweep.from_dict({
    "format": "carom-sweep/1",
    "shots": "shots/half_ball_cut.json",
    "vary": {"strike.speed": {"grid": [0.0, 1.5, 3.5]}, "physics": {"grid": ["pool", "ideal"]}},
    "noise": "club",
    "variants": 10,
    "columns": ["events", "duration", "pocket", "end_x", "end_y"],
})
tables = [sweep.table(device=device) for device in ("cpu", "cuda")]
assert len(tables[0]) == 60 and tables[0].equals(tables[1]), tables
here, there = (pot.evaluate(noise, 200, device=device) for device in ("cpu", "cuda"))
assert np.array_equal(here.cue_ball_ends, there.cue_ball_ends, equal_nan=True)
assert all(same(*pair) for pair in results), [same(*pair) for pair in results]
assert sum(len(pair[0]) for pair in results) > 250
print("same", sum(len(pair[0]) for pair in results))
"""


def test_shots_have_the_same_bits_in_translated_ptx(ptx: Path, exact: dict[str, str]) -> None:
    gz = ptx.with_suffix(".ptx.gz")
    subprocess.run(["bash", "-c", f"gzip -c '{ptx}' > '{gz}'"], check=True)
    command = [sys.executable, "-c", COMPARE, gz, ROOT / "shots"]
    done = subprocess.run(command, env=exact, check=False, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("same")
    # driver.c reports memory that was not freed.
    assert "not freed" not in done.stderr


@pytest.mark.stress
def test_random_shots_of_all_families_have_the_same_bits(
    ptx: Path, translated: Path, exact: dict[str, str]
) -> None:
    build = ["cargo", "build", "--release", "--quiet", "-p", "carom-cuda", "--example", "compare"]
    subprocess.run(build, check=True, cwd=ROOT)
    program = ROOT / "target" / "release" / "examples" / "compare"
    done = subprocess.run(
        [program, ptx, "--count", "13000"], env=exact, check=False, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stdout + done.stderr
    played = re.search(r"(\d+) shots, (\d+) events, 0 with other bits", done.stdout)
    assert played is not None
    assert int(played[1]) >= 10_000
    # The control: where operations may be fused, the device is refused when it is opened.
    fused = driver(translated, translated.parent / "fused", *FUSED)
    refused = subprocess.run([program, ptx], env=fused, check=False, capture_output=True, text=True)
    assert refused.returncode == 3
    assert "other bits" in refused.stderr
