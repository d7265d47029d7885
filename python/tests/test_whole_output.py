"""Every output is complete, or an error that names it: on a full disk, in a full pipe."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import threading
from collections.abc import Callable
from pathlib import Path

import carom
import pytest
from carom import InputError
from carom.files import read_text, write_whole

fcntl = pytest.importorskip("fcntl")

ROOT = Path(__file__).parents[2]
SHOT = ROOT / "shots" / "half_ball_cut.json"


def limited(
    *command: str | Path, folder: Path, unbuffered: bool = False, room: int = 1
) -> tuple[int, str]:
    """The exit code and stderr of a command that can write `room` KiB into each file."""
    environment = os.environ | {"PYTHONUNBUFFERED": "1" if unbuffered else ""}
    done = subprocess.run(
        ["bash", "-c", f'ulimit -f {room}; "$@" > out', "bash", *map(str, command)],
        cwd=folder,
        env=environment,
        stderr=subprocess.PIPE,
        text=True,
        timeout=120,
        check=False,
    )
    return done.returncode, done.stderr


def last_line(told: str) -> str:
    """The error without Matplotlib's messages about its own files."""
    return told.splitlines()[-1] if told else ""


CAROM = (sys.executable, "-m", "carom")


@pytest.mark.parametrize("unbuffered", [True, False])
@pytest.mark.parametrize(
    "arguments",
    [
        ("break", "--seed", "20", "--json"),
        ("break", "--seed", "20"),
        ("break", "--presets"),
        ("tables", "--json"),
        ("schema", "shot"),
        ("physics", "pool"),
        ("evaluate", "--help"),
    ],
)
def test_half_of_an_output_on_a_full_disk_is_an_error(
    arguments: tuple[str | Path, ...], unbuffered: bool, tmp_path: Path
) -> None:
    code, told = limited(*CAROM, *arguments, folder=tmp_path, unbuffered=unbuffered)
    assert told == "carom: stdout: File too large; check where the output is redirected\n"
    assert code == 2


def test_a_slow_reader_of_a_pipe_that_does_not_block_gets_the_whole_output() -> None:
    reader, writer = os.pipe()
    os.set_blocking(writer, False)
    command = [*CAROM, "break", "--seed", "20", "--json"]
    environment = os.environ | {"PYTHONUNBUFFERED": "1"}
    with subprocess.Popen(
        command, stdout=writer, stderr=subprocess.PIPE, env=environment
    ) as process:
        os.close(writer)
        limit = threading.Timer(120, process.kill)
        limit.start()
        with os.fdopen(reader, "rb", buffering=0) as pipe:
            parts = list(iter(lambda: pipe.read(1000), b""))
        _, told = process.communicate()
        limit.cancel()
    assert (process.returncode, told) == (0, b"")
    text = b"".join(parts)
    assert len(text) > 1 << 16, "the output fits into the pipe, so this test shows nothing"
    assert json.loads(text)["format"] == "carom-trace/1"


@pytest.mark.parametrize("option", ["--png", "--svg"])
def test_a_picture_on_a_full_disk_leaves_no_half_of_a_file(option: str, tmp_path: Path) -> None:
    for there in (False, True):
        picture = tmp_path / "picture"
        if there:
            picture.write_text("an older one", encoding="utf-8")
        code, told = limited(*CAROM, "shot", SHOT, option, "picture", folder=tmp_path)
        assert (code, last_line(told)) == (2, "carom: picture: File too large; check the path")
        left = {path.name for path in tmp_path.iterdir()}
        assert left == ({"out", "picture"} if there else {"out"})
    assert picture.read_text(encoding="utf-8") == "an older one"


SAVE = """
import sys, carom, carom.picture
shot = carom.break_shot("snooker")
try:
    {}
except OSError as error:
    sys.exit(f"{{error.filename}}: {{error.strerror}}")
"""


@pytest.mark.parametrize(
    "call",
    [
        "shot.save('file.svg')",
        "shot.simulate().save('file.svg')",
        "carom.picture.save(shot.simulate(), 'file.svg')",
    ],
)
def test_saving_on_a_full_disk_leaves_no_half_of_a_file(call: str, tmp_path: Path) -> None:
    program = SAVE.format(call)
    code, told = limited(sys.executable, "-c", program, folder=tmp_path)
    assert (code, last_line(told)) == (1, "file.svg: File too large")
    assert [path.name for path in tmp_path.iterdir()] == ["out"]


def test_a_full_folder_of_a_sweep_is_named_and_not_stdout(tmp_path: Path) -> None:
    spec = {
        "format": "carom-sweep/1",
        "shots": str(SHOT),
        "vary": {"strike.speed": {"uniform": [1.0, 3.0]}},
        "samples": 5000,
    }
    (tmp_path / "spec.json").write_text(json.dumps(spec), encoding="utf-8")
    for room, file in ((1, "sweep.json"), (8, "part-000000.parquet")):
        command = (*CAROM, "sweep", "spec.json", "--out", "table", "--threads", "1")
        code, told = limited(*command, folder=tmp_path, room=room)
        assert (code, told) == (2, f"carom: table/{file}: File too large; check the path\n")
    assert not list((tmp_path / "table").glob("*.unfinished"))
    report = carom.sweep(tmp_path / "spec.json", tmp_path / "table")
    assert report.rows == 5000


def test_a_file_is_replaced_with_its_permissions_and_through_its_link(tmp_path: Path) -> None:
    file, link = tmp_path / "file", tmp_path / "link"
    write_whole(file, "one")
    file.chmod(0o640)
    link.symlink_to(file)
    write_whole(link, "two")
    assert link.is_symlink()
    assert (file.read_text(encoding="utf-8"), file.stat().st_mode & 0o777) == ("two", 0o640)
    assert {path.name for path in tmp_path.iterdir()} == {"file", "link"}


def test_a_new_file_has_the_usual_permissions(tmp_path: Path) -> None:
    before = os.umask(0o027)
    try:
        write_whole(tmp_path / "file", b"content")
    finally:
        os.umask(before)
    assert (tmp_path / "file").stat().st_mode & 0o777 == 0o640


def test_a_name_as_long_as_the_system_allows_can_be_written(tmp_path: Path) -> None:
    write_whole(tmp_path / ("n" * 255), "content")
    assert len(list(tmp_path.iterdir())) == 1


def test_a_file_that_cannot_be_replaced_is_written_in_place(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def busy(*_: object) -> None:
        raise OSError(16, "Device or resource busy")

    file = tmp_path / "file"
    file.write_text("old", encoding="utf-8")
    monkeypatch.setattr(Path, "replace", busy)
    write_whole(file, "new")
    assert file.read_text(encoding="utf-8") == "new"
    assert len(list(tmp_path.iterdir())) == 1


def test_a_device_is_written_and_not_replaced() -> None:
    write_whole("/dev/null", "content")
    assert Path("/dev/null").is_char_device()


# Text in other encodings.


@pytest.mark.parametrize("encoding", ["utf-16", "utf-16-le", "utf-16-be", "utf-32", "utf-32-le"])
def test_a_file_in_utf_16_is_named_as_such(encoding: str, tmp_path: Path) -> None:
    file = tmp_path / "shot.json"
    file.write_bytes(SHOT.read_text(encoding="utf-8").encode(encoding))
    loads: list[Callable[[Path], object]] = [
        carom.Shot.load,
        carom.Trace.load,
        carom.Sweep.load,
        carom.convert.pooltool,
    ]
    for load in loads:
        with pytest.raises(InputError) as refused:
            load(file)
        assert str(refused.value) == (
            f"{file}: it is {encoding[:6].upper()} text, not UTF-8; save it as UTF-8, in "
            "PowerShell with Out-File -Encoding utf8 instead of >"
        )


def test_stdin_in_utf_16_is_named_as_such() -> None:
    text = SHOT.read_text(encoding="utf-8").encode("utf-16")
    for command in ("shot", "import", "play"):
        done = subprocess.run([*CAROM, command, "-"], input=text, capture_output=True, check=False)
        assert done.returncode == 2
        assert done.stderr.startswith(b"carom: stdin: it is UTF-16 text, not UTF-8; save it as")


def test_a_text_has_the_same_ends_of_lines_on_every_platform(tmp_path: Path) -> None:
    (tmp_path / "file").write_bytes("a\r\nb\rc\nä".encode())
    assert read_text(tmp_path / "file") == "a\nb\nc\nä"
