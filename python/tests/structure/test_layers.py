"""Imports go down only, in Rust, Python and TypeScript (ARCHITECTURE.md, Laws)."""

import re
import tomllib
from collections import defaultdict
from pathlib import Path

import pytest

from structure import imports

ROOT = Path(__file__).resolve().parents[3]

LAYERS = tomllib.loads(Path(__file__).with_name("layers.toml").read_text(encoding="utf-8"))
CRATES = {name: set(used) for name, used in LAYERS["crates"].items()}
MODULES = LAYERS["modules"]
# A crate of one file has no imports of its own.
ONE_FILE = {"carom-cuda-kernel"}
TREES = sorted({f"crates/{name}/src" for name in CRATES.keys() - ONE_FILE} | set(MODULES))


def graph_of(tree: str) -> imports.Graph:
    read = {"crates": imports.rust, "python": imports.python, "web": imports.typescript}
    return imports.without_reexports(read[tree.partition("/")[0]](ROOT / tree))


@pytest.mark.parametrize("tree", TREES)
def test_imports_have_no_cycles(tree):
    graph = graph_of(tree)
    assert len(graph) > 1
    assert sum(len(targets) for targets in graph.values()) > 0
    assert imports.cycles(graph) == []


@pytest.mark.parametrize("tree", sorted(MODULES))
def test_a_module_imports_only_modules_below_it(tree):
    modules = imports.top_level(graph_of(tree))
    order = MODULES[tree]
    assert sorted(modules) == sorted(order), "list each module in layers.toml"
    upward = {
        (a, b) for a, used in modules.items() for b in used if order.index(b) > order.index(a)
    }
    assert upward == set()


def test_a_crate_depends_only_on_its_permitted_crates():
    used = {}
    for manifest in (ROOT / "crates").glob("*/Cargo.toml"):
        table = tomllib.loads(manifest.read_text(encoding="utf-8"))
        used[table["package"]["name"]] = set(table.get("dependencies", {})) & set(CRATES)
    assert used.keys() == CRATES.keys()
    assert {name: used[name] - CRATES[name] for name in used if used[name] - CRATES[name]} == {}


def test_only_carom_peers_compiles_the_hook_for_its_root_finders_into_the_engine():
    asks = re.compile(r'"(carom/)?peers"')
    manifests = ROOT.glob("crates/*/Cargo.toml")
    asking = [path for path in manifests if asks.search(path.read_text(encoding="utf-8"))]
    assert [path.parent.name for path in asking] == ["carom-peers"]


def test_no_two_crates_have_public_types_of_one_name():
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


def test_a_type_that_implements_recorder_has_a_name_that_ends_in_recorder():
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


def test_a_rust_module_with_parts_has_its_first_page_in_their_folder():
    files = [file for file in (ROOT / "crates").rglob("*.rs") if "target" not in file.parts]
    assert len(files) > 100
    beside = [file for file in files if file.with_suffix("").is_dir()]
    assert [file.relative_to(ROOT).as_posix() for file in beside] == [], "name it x/mod.rs"


# Tests of imports.py.


def write(folder: Path, files: dict[str, str]) -> Path:
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return folder


def test_a_cycle_in_rust_is_found(tmp_path):
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
    assert imports.cycles(graph) == [["a/mod.rs", "b.rs"]]


def test_a_cycle_in_python_is_found(tmp_path):
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
    assert imports.cycles(imports.without_reexports(graph)) == [["a.py", "b.py"]]


def test_a_cycle_in_typescript_is_found(tmp_path):
    source = write(
        tmp_path,
        {
            "a.ts": 'import type { B } from "./parts/b";\n',
            "parts/b.ts": 'export const f = () => import("../a.js");\n// from "./c"\n',
            "parts/index.ts": 'export * from "./b";\n',
            "parts/c.ts": 'import { B } from ".";\nimport Worker from "./b?worker";\n',
        },
    )
    graph = imports.typescript(source)
    assert graph["a.ts"] == {"parts/b.ts"}
    assert graph["parts/b.ts"] == {"a.ts"}
    assert graph["parts/c.ts"] == {"parts/index.ts", "parts/b.ts"}
    assert imports.cycles(imports.without_reexports(graph)) == [["a.ts", "parts/b.ts"]]


def test_a_parent_may_reexport_names_of_its_parts():
    graph = {
        "simulate/mod.rs": {"simulate/row.rs"},
        "simulate/row.rs": {"simulate/mod.rs"},
        "a/__init__.py": {"a/b.py"},
        "a/b.py": {"a/__init__.py"},
    }
    assert imports.cycles(imports.without_reexports(graph)) == []
    assert imports.top_level(graph) == {"simulate": set(), "a": set()}
