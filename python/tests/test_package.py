"""The package itself: its import time, its size and its types."""

from __future__ import annotations

import inspect
import subprocess
import sys
import tomllib
import zlib
from pathlib import Path

import carom
import pytest

# The project's limits for memory after the import and for the wheel, which `make release` measures.
IMPORT_MEGABYTES = 60
PROJECT = tomllib.loads((Path(__file__).parents[2] / "pyproject.toml").read_text(encoding="utf-8"))
WHEEL_MEGABYTES = PROJECT["tool"]["carom"]["wheel-megabytes"]


def python(program: str) -> str:
    return subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    ).stdout


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="needs Linux's /proc")
def test_importing_takes_little_memory() -> None:
    # VmHWM and not ru_maxrss, because a new process inherits its parent's peak in ru_maxrss.
    program = (
        "import carom, re\n"
        "status = open('/proc/self/status').read()\n"
        "print(int(re.search(r'VmHWM:\\s+(\\d+) kB', status)[1]) / 1000)"
    )
    assert float(python(program)) < IMPORT_MEGABYTES


def test_importing_loads_no_heavy_library() -> None:
    heavy = {"numpy", "matplotlib", "typer", "rich", "jsonschema"}
    program = "import sys, carom; print(' '.join(m for m in sys.modules if '.' not in m))"
    assert heavy.isdisjoint(python(program).split())


def test_the_compressed_package_is_smaller_than_its_limit() -> None:
    folder = Path(carom.__file__).parent
    files = [
        p
        for p in folder.rglob("*")
        if p.is_file()
        and "__pycache__" not in p.parts
        and p.suffix in {".py", ".so", ".pyi", ".pyd", ".html"}
    ]
    assert any(p.name.startswith("_core") and p.suffix == ".so" for p in files)
    packed = sum(len(zlib.compress(p.read_bytes())) for p in files)
    assert packed < WHEEL_MEGABYTES * 1e6


def test_the_package_has_the_marker_of_a_typed_package() -> None:
    assert (Path(carom.__file__).parent / "py.typed").exists()


def test_every_public_name_exists_and_has_a_docstring() -> None:
    for name in carom.__all__:
        thing = getattr(carom, name)
        assert name == "__version__" or thing.__doc__, name


def test_drawing_writes_nothing_to_the_home_directory(tmp_path: Path) -> None:
    program = (
        "import carom, carom.picture\n"
        "s = carom.Shot('wpa-9ft', {'cue': (0.6, 0.6)}, carom.Strike(speed=1, azimuth=1))\n"
        "carom.picture.svg(s.simulate())\n"
    )
    subprocess.run(
        [sys.executable, "-c", program],
        check=True,
        env={"HOME": str(tmp_path), "PATH": "/usr/bin:/bin"},
        capture_output=True,
    )
    assert list(tmp_path.iterdir()) == []


def test_dir_lists_every_public_name_also_those_that_are_loaded_later() -> None:
    names = python("import carom; print(*dir(carom))").split()
    assert set(carom.__all__) <= set(names)
    assert {"sweep", "Sweep", "picture", "convert", "page", "bench", "serve"} <= set(names)


def test_the_methods_of_a_shot_show_self_and_no_shot() -> None:
    for name, method in inspect.getmembers(carom.Shot, inspect.isfunction):
        if name.startswith("_"):
            continue
        assert next(iter(inspect.signature(method).parameters)) == "self", name
        assert "        shot: " not in (method.__doc__ or ""), name
    questions = (carom.evaluate, carom.solve, carom.pot_map)
    assert all("        shot: " in (question.__doc__ or "") for question in questions)
