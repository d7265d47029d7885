"""Reads the imports of source files, in Rust, Python and TypeScript.

A graph maps every file to the files that it takes names from, as paths relative to the folder that
was read. A name that a parent re-exports (``pub use``, ``__init__.py``, ``index.ts``) counts as
taken from the file that defines it. Imports of tests inside source files do not count.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path, PurePosixPath

Graph = dict[str, set[str]]


def is_parent(a: str, b: str) -> bool:
    """Whether file ``a`` is the parent of a module that file ``b`` is a part of.

    Parents are ``mod.rs``, ``lib.rs``, ``__init__.py`` and ``index.ts`` of a folder.
    """
    path = PurePosixPath(a)
    names_folder = path.name in {"mod.rs", "lib.rs", "__init__.py", "index.ts"}
    return names_folder and a != b and path.parent in PurePosixPath(b).parents


def without_reexports(graph: Graph) -> Graph:
    """The graph without the imports of a parent from its own parts."""
    return {a: {b for b in targets if not is_parent(a, b)} for a, targets in graph.items()}


def top_level(graph: Graph) -> Graph:
    """The graph of the files and folders at the top; a file and a folder are one module each."""
    result: Graph = {}
    for a, targets in graph.items():
        if is_root_file(a):
            continue
        here = _top_level(a)
        result.setdefault(here, set()).update(
            _top_level(b) for b in targets if _top_level(b) != here and not is_root_file(b)
        )
    return result


def is_root_file(file: str) -> bool:
    """Whether the file is the parent of the whole tree, which re-exports names of every module."""
    return file in {"lib.rs", "__init__.py", "__main__.py", "index.ts"}


def _top_level(file: str) -> str:
    return PurePosixPath(file).parts[0].partition(".")[0]


def cycles(graph: Graph) -> list[list[str]]:
    """The groups of files that import each other, directly or indirectly (Tarjan 1972)."""
    index: dict[str, int] = {}
    low: dict[str, int] = {}
    stack: list[str] = []
    found: list[list[str]] = []

    def visit(a: str) -> None:
        index[a] = low[a] = len(index)
        stack.append(a)
        for b in sorted(graph.get(a, ())):
            if b not in index:
                visit(b)
                low[a] = min(low[a], low[b])
            elif b in stack:
                low[a] = min(low[a], index[b])
        if low[a] == index[a]:
            group = stack[stack.index(a) :]
            del stack[stack.index(a) :]
            if len(group) > 1:
                found.append(sorted(group))

    for a in sorted(graph):
        if a not in index:
            visit(a)
    return sorted(found)


# Rust


_RUST_NOISE = re.compile(
    r"//[^\n]*"
    r"|/\*.*?\*/"
    r'|b?r(?P<fence>#*)".*?"(?P=fence)'
    r'|"(?:[^"\\]|\\.)*"'
    r"|'(?:[^'\\]|\\.)'",
    re.DOTALL,
)
_TEST_MODULE = re.compile(
    r"#\[cfg\((?:all\()?test\b[^\]]*\]\s*(?:#\[[^\]]*\]\s*)*mod\s+(\w+)\s*([;{])"
)
_USE = re.compile(r"^\s*(?P<shown>pub(?:\([^)]*\))?\s+)?use\s+(?P<tree>[^;=]+);", re.MULTILINE)
_INLINE = re.compile(r"\b(?:crate|self|super)(?:\s*::\s*\w+)+")


def rust(source: Path) -> Graph:
    """The files of a crate's ``src`` without programs, which may import every module."""
    modules: dict[tuple[str, ...], str] = {}
    for file in sorted(source.rglob("*.rs")):
        relative = file.relative_to(source)
        if relative.parts[0] == "bin" or relative.name == "main.rs":
            continue
        parts = relative.with_suffix("").parts
        if parts[-1] in {"mod", "lib"}:
            parts = parts[:-1]
        modules[parts] = relative.as_posix()
    crate = _Crate(source, modules)
    graph: Graph = {}
    for module, name in modules.items():
        if crate.is_test(module):
            continue
        targets = {modules[t] for t in crate.taken(module) if not crate.is_test(t)}
        graph[name] = targets - {name}
    return graph


class _Crate:
    def __init__(self, source: Path, modules: dict[tuple[str, ...], str]) -> None:
        self.modules = modules
        self.text: dict[tuple[str, ...], str] = {}
        self.tests: set[tuple[str, ...]] = set()
        for module, name in modules.items():
            text = _RUST_NOISE.sub(" ", (source / name).read_text(encoding="utf-8"))
            self.text[module] = self._without_tests(module, text)
        self.shown = {m: list(self._uses(m, only_shown=True)) for m in modules}

    def is_test(self, module: tuple[str, ...]) -> bool:
        return any(module[: len(t)] == t for t in self.tests)

    def taken(self, module: tuple[str, ...]) -> set[tuple[str, ...]]:
        paths = [path for path, _ in self._uses(module, only_shown=False)]
        paths += [re.split(r"\s*::\s*", m.group()) for m in _INLINE.finditer(self.text[module])]
        found = (self._definer(module, path) for path in paths)
        return {f for f in found if f is not None}

    def _without_tests(self, module: tuple[str, ...], text: str) -> str:
        while match := _TEST_MODULE.search(text):
            end = match.end()
            if match.group(2) == ";":
                self.tests.add((*module, match.group(1)))
            else:
                depth = 1
                while depth and end < len(text):
                    depth += {"{": 1, "}": -1}.get(text[end], 0)
                    end += 1
            text = text[: match.start()] + text[end:]
        return text

    def _uses(
        self, module: tuple[str, ...], *, only_shown: bool
    ) -> Iterator[tuple[list[str], str]]:
        """The paths that the module's ``use`` declarations name, and under which name each."""
        for match in _USE.finditer(self.text[module]):
            if match.group("shown") or not only_shown:
                yield from _leaves(match.group("tree"))

    def _definer(
        self, module: tuple[str, ...], path: list[str], depth: int = 0
    ) -> tuple[str, ...] | None:
        """The module whose file defines what ``path`` names, seen from ``module``."""
        at: tuple[str, ...]
        first, rest = path[0], path[1:]
        if first == "crate":
            at = ()
        elif first == "self":
            at = module
        elif first == "super":
            at = module[:-1]
            while rest and rest[0] == "super":
                at, rest = at[:-1], rest[1:]
        elif (*module, first) in self.modules:
            at = (*module, first)
        else:
            return None
        while rest and (*at, rest[0]) in self.modules:
            at, rest = (*at, rest[0]), rest[1:]
        if not rest or depth > 8:
            return at if at in self.modules else None
        for shown, name in self.shown.get(at, []):
            if name in {rest[0], "*"} and shown != path:
                found = self._definer(at, shown, depth + 1)
                if found is not None and (name != "*" or self._defines(found, rest[0])):
                    return found
        return at if at in self.modules else None

    def _defines(self, module: tuple[str, ...], name: str) -> bool:
        return (
            re.search(
                rf"\b(?:fn|struct|enum|trait|type|const|static|mod)\s+{name}\b", self.text[module]
            )
            is not None
        )


def _leaves(tree: str, prefix: tuple[str, ...] = ()) -> Iterator[tuple[list[str], str]]:
    """The paths in a use tree, and the names that they are used under."""
    tree = tree.strip()
    head, brace, _ = tree.partition("{")
    if brace:
        inside = tree[len(head) + 1 : tree.rindex("}")]
        stem = tuple(s for s in re.split(r"\s*::\s*", head.strip()) if s)
        for part in _split(inside):
            yield from _leaves(part, prefix + stem)
        return
    if not tree:
        return
    path, _, renamed = (p.strip() for p in re.sub(r"\s+as\s+", " as ", tree).partition(" as "))
    segments = list(prefix) + [s for s in re.split(r"\s*::\s*", path) if s]
    if segments[-1] == "self" and len(segments) > 1:
        segments.pop()
    yield segments, renamed or segments[-1]


def _split(text: str) -> Iterator[str]:
    depth, start = 0, 0
    for i, c in enumerate(text):
        depth += {"{": 1, "}": -1}.get(c, 0)
        if c == "," and depth == 0:
            yield text[start:i]
            start = i + 1
    yield text[start:]


# Python


def python(package: Path) -> Graph:
    """The files of a package, with imports inside functions and for type checkers.

    ``import package`` and then ``package.name`` in code takes the name from the file that defines
    it. In an annotation it does not count: annotations are not evaluated, and ``__init__.py``
    re-exports all types.
    """
    files = {
        ".".join((package.name, *_dotted(f.relative_to(package)))): f
        for f in sorted(package.rglob("*.py"))
        if "validation" not in f.relative_to(package).parts[:1]
    }
    trees = {name: ast.parse(f.read_text(encoding="utf-8")) for name, f in files.items()}
    passed_on = {name: dict(_imported(trees[name], name, files[name])) for name in files}

    def definer(module: str, name: str | None) -> str | None:
        if name is not None and f"{module}.{name}" in files:
            return f"{module}.{name}"
        if module not in files:
            return None
        if name is not None and files[module].name == "__init__.py" and name in passed_on[module]:
            return definer(*passed_on[module][name]) or module
        return module

    graph: Graph = {}
    for name, file in files.items():
        taken = {definer(m, n) for _, (m, n) in _imported(trees[name], name, file)}
        taken |= {definer(package.name, n) for n in _through_root(trees[name], package.name)}
        key = file.relative_to(package).as_posix()
        graph[key] = {files[t].relative_to(package).as_posix() for t in taken if t} - {key}
    return graph


def _dotted(relative: Path) -> tuple[str, ...]:
    parts = relative.with_suffix("").parts
    return parts[:-1] if parts[-1] == "__init__" else parts


def _imported(
    tree: ast.Module, module: str, file: Path
) -> Iterator[tuple[str, tuple[str, str | None]]]:
    """Each imported name, with the module that it is taken from and its name there."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield alias.asname or alias.name, (alias.name, None)
        elif isinstance(node, ast.ImportFrom):
            base = node.module or ""
            if node.level:
                up = module.split(".")
                up = up[: len(up) - node.level + (file.name == "__init__.py")]
                base = ".".join([*up, *([node.module] if node.module else [])])
            for alias in node.names:
                yield alias.asname or alias.name, (base, alias.name)


def _through_root(tree: ast.AST, root: str) -> Iterator[str]:
    """The names that code outside annotations takes as attributes of the root package."""
    for field, value in ast.iter_fields(tree):
        if field in {"annotation", "returns"}:
            continue
        for node in value if isinstance(value, list) else [value]:
            if not isinstance(node, ast.AST):
                continue
            if (
                isinstance(node, ast.Attribute)
                and isinstance(node.value, ast.Name)
                and node.value.id == root
            ):
                yield node.attr
            yield from _through_root(node, root)


# TypeScript


_TS_NOISE = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
_TS_IMPORT = re.compile(r"""(?:\bfrom\s*|\bimport\s*\(\s*|\bimport\s+)(["'])(?P<path>\.[^"']*)\1""")


def typescript(source: Path) -> Graph:
    """The files of a TypeScript folder; styles and built files are left out."""
    files = {
        f.relative_to(source).as_posix()
        for f in source.rglob("*.ts")
        if not f.name.endswith(".d.ts") and "pkg" not in f.parts and "node_modules" not in f.parts
    }
    graph: Graph = {}
    for name in sorted(files):
        text = _TS_NOISE.sub(" ", (source / name).read_text(encoding="utf-8"))
        targets = set()
        for match in _TS_IMPORT.finditer(text):
            path = match.group("path").partition("?")[0]
            target = (source / name).parent.joinpath(path).resolve()
            for candidate in (
                target,
                target.with_suffix(".ts"),
                target / "index.ts",
                target.parent / f"{target.name}.ts",
            ):
                relative = _relative(candidate, source)
                if relative in files:
                    targets.add(relative)
                    break
        graph[name] = targets - {name}
    return graph


def _relative(path: Path, folder: Path) -> str:
    path, folder = path.resolve(), folder.resolve()
    return path.relative_to(folder).as_posix() if path.is_relative_to(folder) else ""
