"""What is installed: versions, features and extras; and the sentence where an extra is missing."""

from __future__ import annotations

import json
import subprocess
import sys
import tomllib
from pathlib import Path

import carom
import numpy as np
import pytest
from carom.installed import EXTRAS, commit_of
from carom.learn import Posterior
from carom.learn.table_model import TableModel

ROOT = Path(__file__).parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def command(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "carom", *arguments], capture_output=True, text=True, check=False
    )


def test_the_version_of_the_results_is_that_of_the_goldens() -> None:
    stored = (ROOT / "goldens" / "version.txt").read_text(encoding="utf-8")
    assert carom.build_info()["results"] == int(stored)


def test_the_build_names_engine_features_vectors_and_commit() -> None:
    info = carom.build_info()
    assert info["engine"] == f"carom {carom.__version__}"
    assert {"std", "json", "parallel"} <= set(info["features"])
    assert "peers" not in info["features"]
    assert info["vectors"] in {"AVX-512", "AVX2", "SSE2", "NEON", "plain"}
    assert info["commit"] == commit_of(ROOT)
    assert json.loads(json.dumps(info)) == info


def test_a_folder_without_git_has_no_commit(tmp_path: Path) -> None:
    assert commit_of(tmp_path) is None


def test_the_version_is_one_line_and_with_verbose_a_line_for_each_fact() -> None:
    assert command("--version").stdout == f"carom {carom.__version__}\n"
    info = carom.build_info()
    for order in (("--version", "--verbose"), ("--verbose", "--version")):
        lines = command(*order).stdout.splitlines()
        assert lines[0] == info["engine"]
        facts = dict(line.split(maxsplit=1) for line in lines[1:])
        assert facts["results"] == f"version {info['results']}"
        assert facts["vectors"] == info["vectors"]
        assert facts["features"].split(", ") == info["features"]


def test_verbose_alone_is_refused_and_no_command_shows_the_help() -> None:
    alone = command("--verbose")
    assert alone.returncode == 2
    assert "--version --verbose" in alone.stderr
    assert "Usage:" in command().stdout + command().stderr


def test_the_extras_are_those_of_the_package() -> None:
    assert EXTRAS.keys() == PROJECT["optional-dependencies"].keys()


SHOT = "s = carom.Shot('wpa-9ft', {'cue': (0.6, 0.6)}, carom.Strike(speed=1, azimuth=1))"
# An extra, the module that it brings, and a use of it.
USES = (
    ("picture", "matplotlib", f"{SHOT}; carom.picture.svg(s.simulate())"),
    ("env", "gymnasium", "import carom.env"),
    ("env", "pettingzoo", "import carom.env; carom.env.aec()"),
    ("train", "stable_baselines3", "import carom.env.sb3"),
    ("import", "msgpack", "carom.convert.pooltool(b'\\x81')"),
    ("sweep", "pyarrow", "from carom.lazy import pq; pq.read_table"),
    (
        "arena",
        "statsmodels",
        "from carom.arena import bradley_terry; bradley_terry.families.Binomial",
    ),
    ("learn", "pyarrow", "from carom.learn import parquet; parquet.pq.read_table"),
    ("ray", "ray", "from carom import cluster; cluster.ray()"),
)


@pytest.mark.parametrize(("extra", "module", "use"), USES)
def test_a_use_without_its_extra_names_the_extra(extra: str, module: str, use: str) -> None:
    program = f"import sys; sys.modules[{module!r}] = None\nimport carom\n{use}"
    ended = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=False
    )
    assert ended.returncode == 1
    assert f"carom[{extra}]" in ended.stderr.splitlines()[-1]


def test_every_extra_has_a_use() -> None:
    assert {extra for extra, _, _ in USES} == EXTRAS.keys()


def test_the_command_names_the_extra_of_a_picture(tmp_path: Path) -> None:
    program = (
        "import sys; sys.modules['matplotlib'] = None\n"
        "from carom.cli import main; sys.argv = ['carom', 'break', '--png', 'a.png']; main()"
    )
    ended = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=False, cwd=tmp_path
    )
    assert ended.returncode == 2
    assert "pip install 'carom[picture]'" in ended.stderr


def test_what_is_learned_names_its_engine_and_is_read_without_it() -> None:
    model = TableModel("carom-10ft")
    count = len(model.free)
    file = Posterior(model, np.full(count, 0.1), 1e-6 * np.eye(count), 3).to_dict()
    assert file.pop("engine") == f"carom {carom.__version__}"
    assert Posterior.from_dict(file).to_dict()["posterior"] == file["posterior"]
