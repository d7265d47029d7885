"""Install the built files as a new user would, and measure."""

from __future__ import annotations

import os
import platform
import shutil
import sys
import tempfile
import time
from collections.abc import Iterable
from pathlib import Path

from release.report import Check
from release.shell import CheckError, need, run

GROUP = "pip install --group release"
# The limits of the project: seconds to the first picture and to the first shot, and megabytes of
# the core's environment without pip and without the byte code that pip compiles.
PICTURE_SECONDS = 15.0
SHOT_SECONDS = 0.3
CORE_MEGABYTES = 100

SHOT = """
import time; start = time.perf_counter()
import carom
trace = carom.break_shot("nine-ball", seed=20).simulate()
print(trace.hash, time.perf_counter() - start)
"""
NODE_SHOT = """
import { load } from "carom-engine";
const start = performance.now();
const trace = (await load()).breakShot("nine-ball", { seed: 20 }).simulate();
console.log(trace.hash, (performance.now() - start) / 1000);
"""


def checks(out: Path) -> tuple[Check, ...]:
    """The checks that install the files of a folder."""
    return (
        Check("pip install, first shot", lambda: core(wheel(out))),
        Check("pip install, first picture", lambda: picture(wheel(out))),
        Check("what each extra adds", lambda: extras(wheel(out))),
        Check("uv pip install", lambda: uv_pip(wheel(out))),
        Check("uvx", lambda: uvx(wheel(out))),
        Check("pipx run", lambda: pipx(wheel(out))),
        Check("npm install, first shot", lambda: npm(out)),
        Check("build from the sdist", lambda: sdist(out)),
    )


def wheel(out: Path) -> Path:
    """The wheel for this machine.

    Raises:
        CheckError: There is none.
    """
    for found in out.glob(f"*-abi3-*{platform.machine()}.whl"):
        return found
    raise CheckError(f"no wheel for {platform.machine()} in {out}")


class Environment:
    """An empty virtual environment in a temporary folder, without this checkout."""

    def __enter__(self) -> Environment:
        self.folder = Path(tempfile.mkdtemp(prefix="carom-install-"))
        run(sys.executable, "-m", "venv", str(self.folder / "env"))
        self.bin = self.folder / "env" / "bin"
        return self

    def __exit__(self, *_error: object) -> None:
        shutil.rmtree(self.folder)

    def pip(self, *asked: str) -> None:
        """Install packages."""
        self.python("-m", "pip", "install", "--quiet", "--disable-pip-version-check", *asked)

    def python(self, *arguments: str) -> str:
        """The output of this environment's Python."""
        return run(str(self.bin / "python"), *arguments, at=self.folder, PYTHONPATH="")

    def megabytes(self) -> tuple[float, float]:
        """The size of the installed packages without pip, and of their byte code, MB."""
        (packages,) = (self.folder / "env" / "lib").glob("python*/site-packages")
        own = ("pip", "setuptools", "pkg_resources", "_distutils_hack")
        parts = [part for part in packages.iterdir() if not part.name.startswith(own)]
        files = [file for part in parts for file in (part, *part.rglob("*")) if file.is_file()]
        compiled = [file for file in files if file.suffix == ".pyc"]
        return _megabytes(set(files) - set(compiled)), _megabytes(compiled)


def _megabytes(files: Iterable[Path]) -> float:
    return sum(file.stat().st_size for file in files) / 1e6


def core(built: Path) -> str:
    """The time of the first shot, and the size of the environment, without any extra."""
    with Environment() as env:
        start = time.perf_counter()
        env.pip(str(built))
        took = time.perf_counter() - start
        first, again = (float(env.python("-c", SHOT).split()[1]) for _ in range(2))
        size, compiled = env.megabytes()
        env.python("-m", "carom", "--version", "--verbose")
    said = (
        f"installed in {took:.1f} s, first shot {first:.2f} s, in the next process {again:.2f} s, "
        f"{size:.0f} MB and {compiled:.0f} MB of byte code"
    )
    if first > SHOT_SECONDS or size > CORE_MEGABYTES:
        raise CheckError(f"{said}; the limits are {SHOT_SECONDS} s and {CORE_MEGABYTES} MB")
    return said


def picture(built: Path) -> str:
    """The time from an empty environment to a picture in a file."""
    with Environment() as env:
        start = time.perf_counter()
        env.pip(f"{built}[picture]")
        run(str(env.bin / "carom"), "break", "--seed", "20", "--png", "break.png", at=env.folder)
        took = time.perf_counter() - start
        if not (env.folder / "break.png").read_bytes().startswith(b"\x89PNG"):
            raise CheckError("break.png is not a picture")
    said = f"{took:.1f} s with the downloads"
    if took > PICTURE_SECONDS:
        raise CheckError(f"{said}; the limit is {PICTURE_SECONDS} s")
    return said


def extras(built: Path) -> str:
    """The megabytes that each extra adds to the core."""
    found = []
    for extra in ("picture", "env", "import", "sweep", "arena", "ray"):
        with Environment() as env:
            env.pip(str(built))
            before = sum(env.megabytes())
            env.pip(f"{built}[{extra}]")
            found.append(f"{extra} {sum(env.megabytes()) - before:.0f} MB")
    return ", ".join(found)


def uv_pip(built: Path) -> str:
    """``uv pip install``."""
    uv = need("uv", GROUP)
    with Environment() as env:
        start = time.perf_counter()
        run(uv, "pip", "install", "--quiet", "--python", str(env.bin / "python"), str(built))
        took = time.perf_counter() - start
        env.python("-c", SHOT)
    return f"{took:.1f} s"


def uvx(built: Path) -> str:
    """``uvx``: the command without an installation."""
    uv = need("uv", GROUP)
    start = time.perf_counter()
    run(uv, "tool", "run", "--from", str(built), "carom", "break", "--seed", "20", at=Path(os.sep))
    return f"{time.perf_counter() - start:.1f} s to the table of events"


def pipx(built: Path) -> str:
    """``pipx run``."""
    program = need("pipx", GROUP)
    with tempfile.TemporaryDirectory() as home:
        start = time.perf_counter()
        run(program, "run", "--spec", str(built), "carom", "break", "--seed", "20", PIPX_HOME=home)
        took = time.perf_counter() - start
    return f"{took:.1f} s to the table of events"


def npm(out: Path) -> str:
    """``npm install`` of the tarball in an empty folder; the first shot in Node, as in Python."""
    (packed,) = out.glob("*.tgz")
    with tempfile.TemporaryDirectory(prefix="carom-install-") as name:
        folder = Path(name)
        (folder / "package.json").write_text('{"private": true, "type": "module"}', "utf-8")
        start = time.perf_counter()
        run("npm", "install", "--no-audit", "--no-fund", "--loglevel=error", str(packed), at=folder)
        took = time.perf_counter() - start
        (folder / "shot.js").write_text(NODE_SHOT, encoding="utf-8")
        hash_, first = run("node", "shot.js", at=folder).split()
    here = run(sys.executable, "-c", SHOT).split()[0]
    if hash_ != here:
        raise CheckError(f"the hash of a break is {hash_} in Node and {here} in Python")
    return f"installed in {took:.1f} s, first shot {float(first):.2f} s, hash {hash_}"


def sdist(out: Path) -> str:
    """A build from the sdist with its isolated environment; and the sentence without cargo."""
    (packed,) = out.glob("carom-*.tar.gz")
    with Environment() as env:
        start = time.perf_counter()
        env.pip(str(packed))
        took = time.perf_counter() - start
        env.python("-c", SHOT)
    return f"built and installed in {took:.0f} s"
