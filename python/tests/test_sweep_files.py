"""`carom sweep` writes parts completely or not at all, so a kill changes no result."""

from __future__ import annotations

import errno
import hashlib
import json
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import carom
import duckdb
import polars as pl
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from carom import InputError, Sweep
from carom.lock import locked
from carom.sweeps.parts import Parts

ROOT = Path(__file__).parents[2]
RACK = ROOT / "shots" / "eight_ball_break.json"

Spec = dict[str, Any]


def hashes(folder: Path) -> dict[str, str]:
    return {p.name: hashlib.sha256(p.read_bytes()).hexdigest() for p in folder.glob("*.parquet")}


def read(folder: Path) -> pa.Table:
    return pa.concat_tables([pq.read_table(p) for p in sorted(folder.glob("*.parquet"))])


# Files.


def test_the_files_are_the_same_for_any_number_of_threads(spec: Spec, tmp_path: Path) -> None:
    for threads in (1, 3):
        report = carom.sweep(spec, tmp_path / str(threads), threads=threads, part_rows=37)
        assert (report.rows, report.parts, report.parts_before) == (200, 6, 0)
    assert hashes(tmp_path / "1") == hashes(tmp_path / "3")
    assert len(hashes(tmp_path / "1")) == 6


def test_the_rows_are_the_same_in_parts_of_any_size(spec: Spec, tmp_path: Path) -> None:
    whole = Sweep.from_dict(spec).table()
    for rows in (1, 64, 1000):
        carom.sweep(spec, tmp_path / str(rows), part_rows=rows)
        assert read(tmp_path / str(rows)).equals(whole)


def test_the_parts_of_a_very_large_table_are_counted_and_sorted(tmp_path: Path) -> None:
    parts = Parts(tmp_path, rows=10**17 + 1, part_rows=10**5)
    assert len(parts) == 10**12 + 1
    assert parts.range(10**12) == (10**17, 10**17 + 1)
    names = [parts.path(k).name for k in (0, 9, 10**6, 10**12)]
    assert names == sorted(names)


def test_parts_of_several_row_groups_have_the_same_rows(
    spec: Spec, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("carom.sweeps.parts.GROUP", 32)
    carom.sweep(spec, tmp_path, part_rows=150)
    file = pq.ParquetFile(tmp_path / "part-000000.parquet")
    assert [file.metadata.row_group(k).num_rows for k in range(5)] == [32, 32, 32, 32, 22]
    assert read(tmp_path).equals(Sweep.from_dict(spec).table())


def test_a_file_names_its_sweep(spec: Spec, tmp_path: Path) -> None:
    sweep = Sweep.from_dict(spec)
    sweep.run(tmp_path, part_rows=100)
    said = pq.read_metadata(tmp_path / "part-000001.parquet").metadata
    assert said[b"carom.version"].decode() == carom.__version__
    assert said[b"carom.sweep.sha256"].decode() == sweep.sha256
    assert said[b"carom.sweep.first_row"] == b"100"
    again = Sweep.from_json(said[b"carom.sweep"].decode())
    assert again.sha256 == sweep.sha256
    manifest = json.loads((tmp_path / "sweep.json").read_text(encoding="utf-8"))
    assert Sweep.from_dict(manifest["spec"]).sha256 == sweep.sha256
    field = pq.read_schema(tmp_path / "part-000000.parquet").field("duration")
    assert field.metadata[b"is"] == b"time of the last event, s"


def test_a_second_run_writes_only_missing_parts(spec: Spec, tmp_path: Path) -> None:
    carom.sweep(spec, tmp_path, part_rows=25)
    before = hashes(tmp_path)
    times = {p.name: p.stat().st_mtime_ns for p in tmp_path.glob("*.parquet")}
    gone = {"part-000000.parquet", "part-000005.parquet"}
    for name in gone:
        (tmp_path / name).unlink()
    (tmp_path / "part-000005.parquet.elsewhere-1-0.unfinished").write_bytes(b"half")
    report = carom.sweep(spec, tmp_path)
    assert (report.parts, report.parts_before, report.rows) == (8, 6, 200)
    assert hashes(tmp_path) == before
    for path in tmp_path.glob("*.parquet"):
        assert (path.stat().st_mtime_ns == times[path.name]) == (path.name not in gone)
    assert not list(tmp_path.glob("*.unfinished"))


def test_a_folder_of_another_sweep_is_refused(spec: Spec, tmp_path: Path) -> None:
    carom.sweep(spec, tmp_path, part_rows=100)
    with pytest.raises(InputError, match="holds another sweep"):
        carom.sweep(spec | {"seed": 5}, tmp_path)
    with pytest.raises(InputError, match="parts of 100 rows, and part_rows is 50"):
        carom.sweep(spec, tmp_path, part_rows=50)
    manifest = tmp_path / "sweep.json"
    said = json.loads(manifest.read_text(encoding="utf-8"))
    manifest.write_text(json.dumps(said | {"carom": "0.0.1"}), encoding="utf-8")
    with pytest.raises(InputError, match=r"begun by carom 0\.0\.1"):
        carom.sweep(spec, tmp_path)
    manifest.unlink()
    with pytest.raises(InputError, match="belongs to no sweep"):
        carom.sweep(spec, tmp_path)


def test_a_folder_stores_dated_names_of_presets(pot: dict[str, Any], tmp_path: Path) -> None:
    rectangle = {**pot, "table": {"length": 2.54, "width": 1.27, "pockets": "none"}}
    del rectangle["physics"]
    vary = {
        "physics": {"grid": ["pool-valley", {"base": "pool", "gravity": 9.81}]},
        "strike.speed": {"grid": [1.0, 2.0]},
    }
    spec = {"format": "carom-sweep/1", "shots": [pot, rectangle], "vary": vary}
    carom.sweep(spec, tmp_path)
    stored = json.loads((tmp_path / "sweep.json").read_text(encoding="utf-8"))["spec"]
    assert stored["shots"][0]["table"] == "wpa-9ft-2026-12"
    assert stored["shots"][0]["physics"] == "pool-2026-12"
    assert stored["shots"][1]["physics"] == "pool-2026-12"
    assert stored["vary"]["physics"]["grid"] == [
        "pool-valley-2026-12",
        {"base": "pool-2026-12", "gravity": 9.81},
    ]
    said = pq.read_metadata(tmp_path / "part-000000.parquet").metadata
    assert json.loads(said[b"carom.sweep"]) == stored
    again = Sweep.from_dict(stored)
    assert again.sha256 == Sweep.from_dict(spec).sha256
    assert again.table().equals(Sweep.from_dict(spec).table())
    assert carom.sweep(stored, tmp_path).parts_before == 1


def test_a_table_that_varies_keeps_its_own_physics_in_the_stored_spec(pot: dict[str, Any]) -> None:
    pot["table"] = {"length": 3.569, "width": 1.778, "pockets": "none"}
    del pot["physics"]
    grid = {"table": {"grid": [pot["table"], "carom-10ft"]}}
    sweep = Sweep.from_dict({"format": "carom-sweep/1", "shots": pot, "vary": grid})
    assert "physics" not in sweep.to_dict()["shots"][0]
    assert sweep.to_dict()["vary"]["table"]["grid"] == [pot["table"], "carom-10ft-2026-12"]
    assert Sweep.from_dict(sweep.to_dict()).table().equals(sweep.table())
    pool, carom_table = (sweep.shot(row).to_dict() for row in (0, 1))
    assert "physics" not in pool
    carom_table["physics"] = "carom"
    shots = (carom.Shot.from_dict(carom_table), sweep.shot(1))
    assert shots[0].simulate().hash == shots[1].simulate().hash


def begun_before(spec: Spec, folder: Path, values: Spec) -> None:
    """The first part and the manifest of a folder as older versions wrote them.

    The folder has ``spec`` with names without dates; the rows are those of ``values``.
    """
    old, player = Sweep.from_dict(spec).spec, Sweep.from_dict(values)._player
    parts = Parts(folder, rows=old.rows, part_rows=100, sha256=old.undated_sha256)
    parts.write(player, 0)
    manifest = {
        "format": "carom-sweep-parts/1",
        "carom": carom.__version__,
        "sha256": old.undated_sha256,
        "rows": old.rows,
        "part_rows": 100,
        "spec": old.undated,
    }
    (folder / "sweep.json").write_text(json.dumps(manifest), encoding="utf-8")


def test_an_older_folder_with_names_without_dates_is_continued(spec: Spec, tmp_path: Path) -> None:
    begun_before(spec, tmp_path, spec)
    stored = json.loads((tmp_path / "sweep.json").read_text(encoding="utf-8"))
    assert stored["spec"]["shots"][0]["physics"] == "pool"
    assert stored["sha256"] != Sweep.from_dict(spec).sha256
    report = carom.sweep(spec, tmp_path)
    assert (report.parts, report.parts_before) == (2, 1)
    assert read(tmp_path).equals(Sweep.from_dict(spec).table())
    said = [pq.read_metadata(path).metadata for path in sorted(tmp_path.glob("*.parquet"))]
    assert {s[b"carom.sweep.sha256"].decode() for s in said} == {stored["sha256"]}
    assert carom.sweep(stored["spec"], tmp_path).parts_before == 2


def test_an_older_folder_is_refused_if_its_names_had_other_values(
    spec: Spec, tmp_path: Path
) -> None:
    then = json.loads(json.dumps(spec))
    for shot in then["shots"]:
        shot["physics"] = "pool-2026-11"
    begun_before(spec, tmp_path, then)
    with pytest.raises(InputError, match=r"part-000000\.parquet: its rows differ .*without a date"):
        carom.sweep(spec, tmp_path)


def test_a_broken_or_foreign_part_is_refused_by_name(spec: Spec, tmp_path: Path) -> None:
    carom.sweep(spec, tmp_path, part_rows=100)
    second = tmp_path / "part-000001.parquet"
    second.write_bytes((tmp_path / "part-000000.parquet").read_bytes())
    with pytest.raises(InputError, match="it is not part 1 of this sweep"):
        carom.sweep(spec, tmp_path)
    second.write_bytes(b"PAR1")
    with pytest.raises(InputError, match=r"part-000001.parquet: it cannot be read"):
        carom.sweep(spec, tmp_path)


def test_a_flipped_byte_inside_a_part_is_found_by_the_next_run(spec: Spec, tmp_path: Path) -> None:
    # Seen: a flipped byte in the data of a part passed a resume and read as other numbers.
    carom.sweep(spec, tmp_path, part_rows=100)
    part = tmp_path / "part-000001.parquet"
    good = part.read_bytes()
    for place in range(4, len(good) - 4, len(good) // 20):
        flipped = bytearray(good)
        flipped[place] ^= 1
        part.write_bytes(flipped)
        with pytest.raises(InputError, match=r"(?s)part-000001\.parquet: .*; delete the file"):
            carom.sweep(spec, tmp_path)
    part.unlink()
    carom.sweep(spec, tmp_path)
    assert part.read_bytes() == good


def test_readers_that_verify_pages_find_a_flipped_byte(spec: Spec, tmp_path: Path) -> None:
    carom.sweep(spec, tmp_path, part_rows=200)
    part = tmp_path / "part-000000.parquet"
    column = pq.read_metadata(part).row_group(0).column(0)
    flipped = bytearray(part.read_bytes())
    flipped[column.data_page_offset + column.total_compressed_size - 1] ^= 1
    part.write_bytes(flipped)
    with pytest.raises(OSError, match=r"CRC|checksum"):
        pq.read_table(part, page_checksum_verification=True)


def test_the_checksums_are_those_of_sha256sum(spec: Spec, tmp_path: Path) -> None:
    carom.sweep(spec, tmp_path, part_rows=100)
    for name, digest in hashes(tmp_path).items():
        text = (tmp_path / f"{name}.sha256").read_text(encoding="ascii")
        assert text == f"{digest}  {name}\n"


def test_parts_of_an_older_carom_without_checksums_are_read_and_the_report_says_so(
    spec: Spec, tmp_path: Path
) -> None:
    assert "checksum" not in str(carom.sweep(spec, tmp_path, part_rows=50))
    for name in ("part-000000.parquet.sha256", "part-000002.parquet.sha256"):
        (tmp_path / name).unlink()
    report = carom.sweep(spec, tmp_path)
    assert (report.parts_before, report.parts_unchecked) == (4, 2)
    assert "2 parts have no checksum, so they were not checked" in str(report)


def test_more_files_than_a_folder_should_hold_are_refused(spec: Spec, tmp_path: Path) -> None:
    spec["vary"]["strike.speed"]["count"] = 10**9
    with pytest.raises(InputError, match=r"^part_rows: .* more than 1000000 files; give part_rows"):
        carom.sweep(spec, tmp_path / "out", part_rows=7)
    assert not (tmp_path / "out").exists()


def test_ctrl_c_stops_a_table_in_memory(spec: Spec, tmp_path: Path) -> None:
    program = (
        "import json, sys, carom\n"
        "sweep = carom.Sweep.load('spec.json')\n"
        "sweep.parameters(0, 1)\n"
        "print('begun', flush=True)\n"
        "sweep.table(threads=2)\n"
    )
    long = slow(spec) | {"samples": 5_000_000}
    (tmp_path / "spec.json").write_text(json.dumps(long), encoding="utf-8")
    process = subprocess.Popen(
        [sys.executable, "-c", program],
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )
    assert process.stdout is not None
    assert process.stdout.readline() == b"begun\n"
    time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    _, told = process.communicate(timeout=30)
    assert told.splitlines()[-1] == b"KeyboardInterrupt"


@pytest.fixture(params=["with locks", "without locks"])
def locks(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> str:
    """A system with locks of files, and one without."""
    if request.param == "without locks":
        monkeypatch.setattr("carom.lock.lock", no_locks)
    return str(request.param)


def no_locks(_: int) -> None:
    raise OSError(errno.ENOLCK, "No locks available")


@pytest.mark.usefixtures("locks")
def test_two_runs_do_not_write_in_one_folder(spec: Spec, tmp_path: Path) -> None:
    carom.sweep(spec, tmp_path)
    with (
        locked(tmp_path, "sweep"),
        pytest.raises(InputError, match="another run writes to it; wait until it ends"),
    ):
        carom.sweep(spec, tmp_path)
    assert carom.sweep(spec, tmp_path).parts_before == 1
    assert not list(tmp_path.glob("sweep.[!j]*"))


@pytest.mark.usefixtures("locks")
def test_a_run_that_began_after_the_look_at_the_folder_is_noticed(
    spec: Spec, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # Two runs of a new folder both saw no manifest; each wrote its own, and both had a lock.
    folder = tmp_path / "out"
    with ExitStack() as other:

        def check(_: object) -> None:
            folder.mkdir()
            other.enter_context(locked(folder, "sweep"))

        monkeypatch.setattr("carom.sweeps.play.RowPlayer.check", check)
        with pytest.raises(InputError, match="another run writes to it"):
            carom.sweep(spec, folder)
    assert not (folder / "sweep.json").exists()


RUN = """
import sys, json, errno, carom, carom.lock
def no_locks(file):
    raise OSError(errno.ENOLCK, "No locks available")
if sys.argv[3] == "without locks":
    carom.lock.lock = no_locks
spec = carom.Sweep.from_dict(json.loads(sys.argv[1]))
print("ready", flush=True)
sys.stdin.readline()
try:
    print(spec.run(sys.argv[2], part_rows=500).rows)
except carom.InputError as error:
    print(error)
"""


def test_of_two_runs_that_begin_at_once_one_runs_and_the_other_says_so(
    spec: Spec, tmp_path: Path, locks: str
) -> None:
    command = [sys.executable, "-c", RUN, json.dumps(slow(spec)), str(tmp_path / "out"), locks]
    runs = [
        subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        for _ in range(2)
    ]
    try:
        for run in runs:
            assert run.stdout is not None
            assert run.stdout.readline() == "ready\n"
        for run in runs:
            assert run.stdin is not None
            run.stdin.write("go\n")
            run.stdin.flush()
        told = sorted(run.communicate(timeout=100)[0] for run in runs)
    finally:
        for run in runs:
            run.kill()
    assert told[0].startswith(f"{tmp_path / 'out'}: another run writes to it; wait until it ends")
    assert told[1] == "10000\n"
    assert len(hashes(tmp_path / "out")) == 20
    assert [path.name for path in (tmp_path / "out").glob("sweep.*")] == ["sweep.json"]


def test_the_file_of_a_killed_run_stops_nobody_without_locks(
    spec: Spec, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("carom.lock.lock", no_locks)
    program = "import os, socket; print(socket.gethostname(), os.getpid(), 1)"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, check=True)
    (tmp_path / "sweep.running").write_bytes(done.stdout.strip())
    assert carom.sweep(spec, tmp_path).rows == 200
    assert not list(tmp_path.glob("sweep.[!j]*"))


@pytest.mark.parametrize("owner", ["elsewhere 17 3", ""])
def test_without_locks_a_run_on_another_machine_is_not_taken_for_a_killed_one(
    spec: Spec, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, owner: str
) -> None:
    monkeypatch.setattr("carom.lock.lock", no_locks)
    running = tmp_path / "sweep.running"
    running.write_text(owner, encoding="utf-8")
    with pytest.raises(InputError) as refused:
        carom.sweep(spec, tmp_path)
    assert str(refused.value).endswith(f"if that run was killed, delete {running}")
    assert running.read_text(encoding="utf-8") == owner


def test_a_finished_table_in_a_folder_that_cannot_be_written_is_read(
    spec: Spec, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    carom.sweep(spec, tmp_path)

    def refuse(*_: object) -> int:
        raise OSError(errno.EROFS, "Read-only file system")

    monkeypatch.setattr("carom.lock.os.open", refuse)
    assert carom.sweep(spec, tmp_path).parts_before == 1


def slow(spec: Spec) -> Spec:
    """A sweep of some seconds."""
    return spec | {"shots": [str(RACK)], "samples": 1000}


def started(spec: Spec, folder: Path) -> subprocess.Popen[bytes]:
    """A running `carom sweep`, with some parts done and some not."""
    (folder / "spec.json").write_text(json.dumps(spec), encoding="utf-8")
    command = [sys.executable, "-m", "carom", "sweep", "spec.json", "--out", "out"]
    command += ["--part-rows", "500"]
    process = subprocess.Popen(command, cwd=folder, stderr=subprocess.PIPE)
    deadline = time.monotonic() + 60
    while len(list((folder / "out").glob("*.parquet"))) < 3:
        assert process.poll() is None
        assert time.monotonic() < deadline
        time.sleep(0.01)
    return process


@pytest.mark.parametrize("how", ["SIGKILL", "SIGTERM", "SIGINT"])
def test_a_killed_run_continues_without_lost_or_duplicate_rows(
    spec: Spec, tmp_path: Path, how: str
) -> None:
    spec = slow(spec)
    process = started(spec, tmp_path)
    process.send_signal(getattr(signal, how))
    process.communicate(timeout=60)
    done = hashes(tmp_path / "out")
    report = carom.sweep(spec, tmp_path / "out")
    assert 3 <= report.parts_before == len(done) < report.parts == 20
    after = hashes(tmp_path / "out")
    assert done.items() <= after.items()
    table = read(tmp_path / "out")
    assert table["row"].to_pylist() == list(range(10_000))
    assert table.slice(6_000, 300).equals(Sweep.from_dict(spec).table(6_000, 6_300))
    assert not list((tmp_path / "out").glob("*.unfinished"))


def test_ctrl_c_exits_with_130_and_says_how_to_continue(spec: Spec, tmp_path: Path) -> None:
    process = started(slow(spec), tmp_path)
    process.send_signal(signal.SIGINT)
    _, told = process.communicate(timeout=60)
    assert process.returncode == 130
    assert told.decode() == "carom: stopped; the same command continues from here\n"
    assert not list((tmp_path / "out").glob("*.unfinished"))


def test_memory_does_not_grow_with_the_number_of_rows(tmp_path: Path) -> None:
    # Two threads, because the number of parts in memory grows with the number of threads.
    program = (
        "import sys, resource, carom\n"
        "spec = {'format': 'carom-sweep/1', 'shots': sys.argv[1], 'samples': int(sys.argv[2]),\n"
        "        'vary': {'strike.speed': {'uniform': [0.1, 0.3]}}}\n"
        "carom.sweep(spec, sys.argv[3], threads=2, part_rows=10_000)\n"
        "print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)\n"
    )
    peaks = []
    for samples in (60_000, 300_000):
        command = [
            sys.executable,
            "-c",
            program,
            str(RACK),
            str(samples),
            str(tmp_path / str(samples)),
        ]
        done = subprocess.run(command, capture_output=True, text=True, check=True)
        peaks.append(int(done.stdout))
    # If all rows were kept in memory, the second peak would be about 1.5 times the first.
    assert peaks[1] < 1.2 * peaks[0]


# Queries.


def test_duckdb_and_polars_read_the_same_table(spec: Spec, tmp_path: Path) -> None:
    carom.sweep(spec, tmp_path, part_rows=50)
    files = str(tmp_path / "*.parquet")
    table = Sweep.from_dict(spec).table()
    ones = table.filter(pa.compute.equal(table["first_contact"], "1"))
    sql = "SELECT count(*), sum(end_x[1]) FROM read_parquet(?) WHERE first_contact = '1'"
    count, total = duckdb.execute(sql, [files]).fetchone() or (0, 0.0)
    ours = sum(row[0] for row in ones["end_x"].to_pylist())
    assert (count, total) == (len(ones), pytest.approx(ours))
    frame = pl.scan_parquet(files).filter(pl.col("first_contact") == "1")
    found = frame.select(pl.len(), pl.col("end_x").arr.get(0).sum()).collect().row(0)
    assert found == (len(ones), pytest.approx(ours))


# The command.


def test_the_command_writes_the_table_and_prints_a_summary(
    spec: Spec, tmp_path: Path, run: Callable[..., subprocess.CompletedProcess[str]]
) -> None:
    (tmp_path / "shot.json").write_text(json.dumps(spec["shots"][0]), encoding="utf-8")
    (tmp_path / "spec.json").write_text(json.dumps(spec | {"shots": "shot.json"}), encoding="utf-8")
    done = run("sweep", "spec.json", "--out", "out", "--json")
    assert (done.returncode, done.stderr) == (0, "")
    report = json.loads(done.stdout)
    assert (report["rows"], report["parts"], report["failed"]) == (100, 1, 0)
    assert len(read(tmp_path / "out")) == 100
    again = run("sweep", "-", "--out", "out", stdin=(tmp_path / "spec.json").read_bytes())
    assert again.returncode == 0
    assert "1 of the parts existed before" in again.stdout


def test_the_command_refuses_a_bad_spec_with_2(
    run: Callable[..., subprocess.CompletedProcess[str]],
) -> None:
    done = run("sweep", "-", "--out", "out", stdin='{"format": "carom-sweep/1"}')
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith("carom: shots: the key is missing")


def test_carom_is_imported_without_pyarrow() -> None:
    program = "import carom, sys; assert 'pyarrow' not in sys.modules, 'slow to import'"
    subprocess.run([sys.executable, "-c", program], check=True)
