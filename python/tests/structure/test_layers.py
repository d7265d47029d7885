"""Arrows point down: who imports whom, in Rust, Python and TypeScript (ARCHITECTURE.md, Laws)."""

import re
import tomllib
from collections import defaultdict
from pathlib import Path

import pytest

from structure import imports

ROOT = Path(__file__).resolve().parents[3]

LAYERS = tomllib.loads(Path(__file__).with_name("layers.toml").read_text(encoding="utf-8"))
CRATES = {name: set(used) for name, used in LAYERS["crates"].items()}
ROOMS = LAYERS["rooms"]
TREES = sorted({f"crates/{name}/src" for name in CRATES} | set(ROOMS))


def graph_of(tree: str) -> imports.Graph:
    read = {"crates": imports.rust, "python": imports.python, "web": imports.typescript}
    return imports.without_faces(read[tree.partition("/")[0]](ROOT / tree))


@pytest.mark.parametrize("tree", TREES)
def test_no_files_import_each_other_in_a_circle(tree):
    graph = graph_of(tree)
    assert len(graph) > 1
    assert sum(len(targets) for targets in graph.values()) > 0
    assert imports.circles(graph) == []


@pytest.mark.parametrize("tree", sorted(ROOMS))
def test_every_room_uses_only_rooms_below_it(tree):
    rooms = imports.rooms(graph_of(tree))
    order = ROOMS[tree]
    assert sorted(rooms) == sorted(order), "list each room in layers.toml"
    upward = {
        (a, b) for a, below in rooms.items() for b in below if order.index(b) > order.index(a)
    }
    assert upward == set()


def test_every_crate_uses_only_the_crates_that_it_may():
    used = {}
    for manifest in (ROOT / "crates").glob("*/Cargo.toml"):
        table = tomllib.loads(manifest.read_text(encoding="utf-8"))
        used[table["package"]["name"]] = set(table.get("dependencies", {})) & set(CRATES)
    assert used.keys() == CRATES.keys()
    assert {name: used[name] - CRATES[name] for name in used if used[name] - CRATES[name]} == {}


def test_one_noun_names_one_type_among_the_crates():
    declared = defaultdict(list)
    declaration = re.compile(
        r"^\s*pub(?:\(crate\))? (?:struct|enum|trait|union|type) (\w+)", re.MULTILINE
    )
    # The bindings wrap types of the same names.
    for name in CRATES.keys() - {"carom-py", "carom-wasm"}:
        for file in (ROOT / "crates" / name / "src").rglob("*.rs"):
            for noun in declaration.findall(file.read_text(encoding="utf-8")):
                declared[noun].append(file.relative_to(ROOT).as_posix())
    assert len(declared) > 100
    assert {noun: files for noun, files in declared.items() if len(files) > 1} == {}


def test_whatever_implements_recorder_is_called_a_recorder():
    implemented = re.compile(r"\bimpl(?:<[^>]*>)?\s+Recorder\s+for\s+(\w+)")
    names = {
        noun
        for folder in ("crates", "fuzz", "benches")
        for file in (ROOT / folder).rglob("*.rs")
        if "target" not in file.parts
        for noun in implemented.findall(file.read_text(encoding="utf-8"))
    }
    assert len(names) > 5
    assert {name for name in names if not name.endswith("Recorder")} == set()


# The reader of imports itself.


def write(folder: Path, files: dict[str, str]) -> Path:
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return folder


def test_the_reader_finds_a_circle_in_rust(tmp_path):
    source = write(
        tmp_path,
        {
            "lib.rs": "mod a;\nmod b;\npub use a::Apple;\n",
            "a/mod.rs": "mod seed; use crate::b::{self, Bee};\npub struct Apple;",
            "a/seed.rs": "use super::Apple;\n// use crate::b::Bee;",
            "b.rs": "fn f() { let x = crate::Apple; }\npub struct Bee;\n"
            "#[cfg(test)]\nmod tests { use crate::a::seed; }",
        },
    )
    graph = imports.rust(source)
    assert graph["a/mod.rs"] == {"b.rs"}
    assert graph["a/seed.rs"] == {"a/mod.rs"}
    assert graph["b.rs"] == {"a/mod.rs"}
    assert imports.circles(graph) == [["a/mod.rs", "b.rs"]]


def test_the_reader_finds_a_circle_in_python(tmp_path):
    package = write(
        tmp_path / "pkg",
        {
            "__init__.py": "from pkg.a import apple\n",
            "a.py": "def apple():\n    from pkg import b\n",
            "b.py": "from pkg import apple\n",
            "c/__init__.py": "from pkg.c.d import e\n",
            "c/d.py": "from . import f\nfrom ..a import apple as e\n",
            "c/f.py": "import pkg.b\n",
        },
    )
    graph = imports.python(package)
    assert graph["b.py"] == {"a.py"}
    assert graph["c/d.py"] == {"c/f.py", "a.py"}
    assert graph["c/f.py"] == {"b.py"}
    assert imports.circles(imports.without_faces(graph)) == [["a.py", "b.py"]]


def test_the_reader_finds_a_circle_in_typescript(tmp_path):
    source = write(
        tmp_path,
        {
            "a.ts": 'import type { B } from "./rooms/b";\n',
            "rooms/b.ts": 'export const f = () => import("../a.js");\n// from "./c"\n',
            "rooms/index.ts": 'export * from "./b";\n',
            "rooms/c.ts": 'import { B } from ".";\nimport Worker from "./b?worker";\n',
        },
    )
    graph = imports.typescript(source)
    assert graph["a.ts"] == {"rooms/b.ts"}
    assert graph["rooms/b.ts"] == {"a.ts"}
    assert graph["rooms/c.ts"] == {"rooms/index.ts", "rooms/b.ts"}
    assert imports.circles(imports.without_faces(graph)) == [["a.ts", "rooms/b.ts"]]


def test_a_parent_may_pass_its_parts_on():
    graph = {
        "simulate.rs": {"simulate/row.rs"},
        "simulate/row.rs": {"simulate.rs"},
        "a/__init__.py": {"a/b.py"},
        "a/b.py": {"a/__init__.py"},
    }
    assert imports.circles(imports.without_faces(graph)) == []
    assert imports.rooms(graph) == {"simulate": set(), "a": set()}
