"""`carom sweep --ray` writes the same files, also when a worker or a machine is lost half-way.

Ray runs in separate processes, because it leaves threads, handlers and warnings behind.
"""

from __future__ import annotations

import hashlib
import json
import socket
import subprocess
import sys
from pathlib import Path
from typing import Any

import carom
import pytest
from carom import Sweep

ROOT = Path(__file__).parents[2]

pytest.importorskip("ray", reason="the extra `ray` is not installed")

PROGRAM = """
import functools, json, os, signal, sys
from unittest import mock
import pyarrow as pa
from carom import InputError, Sweep
from carom.sweeps import on_ray
from ray._private import services

sweep = Sweep.load("spec.json")
# Seen: Ray joined the cluster of another test, which ended this program with its own end.
hidden = {
    "find_gcs_addresses": functools.cache(set),
    "find_bootstrap_address": lambda folder: None,
}
try:
    with mock.patch.multiple(services, **hidden):
        sweep.run("nowhere", ray="auto")
except InputError as error:
    refused = str(error)
killed = []
write = on_ray.write

def write_and_kill(*arguments):
    for receipt in write(*arguments):
        if not killed:
            # The worker has begun another part by now.
            os.kill(receipt.worker, signal.SIGKILL)
            killed.append(receipt.worker)
        yield receipt

on_ray.write = write_and_kill
report = sweep.run("killed", threads=2, part_rows=1000, ray=True)
on_ray.write = write
for k in (3, 5):
    os.remove(f"killed/part-{k:06}.parquet")
again = sweep.run("killed", ray=True)

rows = list(sweep.dataset().iter_batches(batch_size=None, batch_format="pyarrow"))
pa.parquet.write_table(pa.concat_tables(rows), "dataset.parquet")
reports = {"first": report.to_dict(), "again": again.to_dict()}
print(json.dumps({"refused": refused, "killed": killed, **reports}))
"""


CLUSTER = """
import json, os, pathlib, subprocess, sys
import ray
from carom import Sweep
from carom.sweeps import on_ray
from ray.cluster_utils import Cluster

sweep = Sweep.load("spec.json")
cluster = Cluster(initialize_head=True, head_node_args={"num_cpus": 1})
to_lose = cluster.add_node(num_cpus=1)
cluster.add_node(num_cpus=1)
cluster.wait_for_nodes()
# As on any cluster, the processes of the machines have another current folder.
os.makedirs("elsewhere")
os.chdir("elsewhere")
lost = []
write = on_ray.write

def write_and_lose(*arguments):
    for receipt in write(*arguments):
        if not lost:
            cluster.remove_node(to_lose, allow_graceful=False)
            lost.append(to_lose.node_id)
        yield receipt

on_ray.write = write_and_lose
report = sweep.run("lost", part_rows=1000, ray=cluster.address)
on_ray.write = write
left = sum(node["Alive"] for node in ray.nodes())

# The machines have another version of carom, or one that cannot be loaded. Each time another
# process asks: threads of Ray Data may outlive ray.shutdown(), and then end the process.
refused = []
for text in ("__version__ = '0.0.1'", "raise ImportError('none here')"):
    (pathlib.Path("other") / "carom" / "sweeps").mkdir(parents=True, exist_ok=True)
    pathlib.Path("other/carom/__init__.py").write_text(text)
    pathlib.Path("other/carom/sweeps/play.py").write_text("")
    ask = [sys.executable, "../refused.py", cluster.address, str(len(refused))]
    done = subprocess.run(ask, stdout=subprocess.PIPE, text=True, check=True)
    refused += json.loads(done.stdout.splitlines()[-1])
print(json.dumps({"left": left, "refused": refused, "report": report.to_dict()}), flush=True)
ray.shutdown()
cluster.shutdown()
"""


REFUSED = """
import json, os, sys
import ray
from carom import InputError, Sweep

address, number = sys.argv[1:]
sweep = Sweep.load("../spec.json")
other = {"env_vars": {"PYTHONPATH": os.path.abspath("other"), "N": number}}
ray.init(address=address, runtime_env=other, log_to_driver=False)
refused = []
for ask in (lambda: sweep.run("refused", ray="auto"), lambda: sweep.dataset()):
    try:
        ask()
    except InputError as error:
        refused.append(str(error))
print(json.dumps(refused), flush=True)
"""


def played(folder: Path, program: str, samples: int) -> dict[str, Any]:
    """Write a spec into a folder, run a program there, and return what it prints."""
    spec = {
        "format": "carom-sweep/1",
        "shots": str(ROOT / "shots" / "eight_ball_break.json"),
        "vary": {"strike.speed": {"uniform": [6, 10]}},
        "samples": samples,
        "noise": "olympiad",
    }
    (folder / "spec.json").write_text(json.dumps(spec), encoding="utf-8")
    (folder / "refused.py").write_text(REFUSED, encoding="utf-8")
    done = subprocess.run(
        [sys.executable, "-c", program],
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    said: dict[str, Any] = json.loads(done.stdout.splitlines()[-1])
    return said


@pytest.fixture(scope="module")
def ran(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, dict[str, Any]]:
    """A folder with a sweep by Ray in which a worker was killed half-way, and the report."""
    folder = tmp_path_factory.mktemp("ray")
    return folder, played(folder, PROGRAM, 16_000)


@pytest.fixture(scope="module")
def on_machines(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, dict[str, Any]]:
    """The same by a cluster of three machines, one of which is lost half-way."""
    folder = tmp_path_factory.mktemp("machines")
    return folder, played(folder, CLUSTER, 24_000)


def hashes(folder: Path) -> dict[str, str]:
    return {p.name: hashlib.sha256(p.read_bytes()).hexdigest() for p in folder.iterdir()}


def test_a_killed_worker_changes_no_bit_of_any_file(ran: tuple[Path, dict[str, Any]]) -> None:
    folder, report = ran
    assert len(report["killed"]) == 1
    # Two workers at a time, and one that replaced the killed one.
    assert report["first"]["workers"] >= 3
    assert (report["first"]["rows"], report["first"]["parts"]) == (16_000, 16)
    Sweep.load(folder / "spec.json").run(folder / "here", part_rows=1000)
    assert hashes(folder / "killed") == hashes(folder / "here")


def test_an_address_without_a_cluster_is_refused(ran: tuple[Path, dict[str, Any]]) -> None:
    _, report = ran
    assert report["refused"].startswith("address: no Ray cluster answers at 'auto'; start one")


def test_ray_continues_an_earlier_run(ran: tuple[Path, dict[str, Any]]) -> None:
    _, report = ran
    assert report["again"]["parts_before"] == 14
    assert report["again"]["rows"] == 16_000


def test_a_dataset_of_ray_has_the_same_rows_in_order(ran: tuple[Path, dict[str, Any]]) -> None:
    import pyarrow.parquet as pq

    folder, _ = ran
    found = pq.read_table(folder / "dataset.parquet")
    assert found.equals(Sweep.load(folder / "spec.json").table())


def test_a_machine_that_is_lost_changes_no_bit_of_any_file(
    on_machines: tuple[Path, dict[str, Any]],
) -> None:
    folder, said = on_machines
    assert said["left"] == 2
    assert (said["report"]["rows"], said["report"]["parts"]) == (24_000, 24)
    Sweep.load(folder / "spec.json").run(folder / "here", part_rows=1000)
    assert hashes(folder / "elsewhere" / "lost") == hashes(folder / "here")


def test_a_machine_with_another_or_no_carom_is_refused_by_its_name(
    on_machines: tuple[Path, dict[str, Any]],
) -> None:
    _, said = on_machines
    host, needs = socket.gethostname(), f"every machine needs carom[ray] {carom.__version__}"
    other = f"{host} has carom 0.0.1; {needs}"
    none = f"{host} cannot load carom (none here); {needs}"
    assert [text.split(",")[0] for text in said["refused"]] == [other, other, none, none]


def test_a_machine_without_access_to_the_folder_is_refused(tmp_path: Path) -> None:
    from carom.sweeps.on_ray import _check_folder

    with pytest.raises(
        carom.InputError, match=r"has no access to .*choose a folder that all machines"
    ):
        _check_folder(tmp_path / "nowhere" / "sign")


@pytest.mark.parametrize("parts", [0, 1, 5, 77, 1000, 200_000])
@pytest.mark.parametrize("cores", [1, 2, 64])
def test_tasks_shrink_and_contain_every_part_once_in_order(parts: int, cores: int) -> None:
    from carom.sweeps.on_ray import _tasks

    tasks = list(_tasks(list(range(parts)), cores))
    assert [part for task in tasks for part in task] == list(range(parts))
    sizes = [len(task) for task in tasks]
    assert sizes == sorted(sizes, reverse=True)
    assert not sizes or sizes[-1] == 1
    assert len(tasks) <= 10_000 + 12 * cores
