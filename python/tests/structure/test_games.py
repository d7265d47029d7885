"""Code reads the facts of a game: few lines name one, and no match has a catch-all."""

import re
from collections.abc import Iterator
from pathlib import Path

import carom

ROOT = Path(__file__).parents[3]

# The most lines outside the engine and the rules that name a game to tell it from others.
MOST_LINES = 12

# A test of a game by its name in Rust, and in Python and TypeScript.
RUST = re.compile(r"\bGame::[A-Z][a-z]\w*")
NAMES = "|".join(carom.rule_sets())
WORD = re.compile(
    rf"""[!=]=\s*["']({NAMES})["']|["']({NAMES})["']\s*[!=]==?|case ["']({NAMES})["']"""
)
LISTED = re.compile(rf"""^\s*["']({NAMES})["'],?\s*$|Set\(\[["']({NAMES})["']""")

# An arm of a match on a game or on one of its facts.
ARM = re.compile(
    r"^(\s*)\|?\s*\(?(?:Task::Game\()?(?:Game|Objective|Scoring|OpeningKind|GameState)::[A-Z]"
)


def rust_without_tests(path: Path) -> list[str]:
    text = path.read_text(encoding="utf-8")
    return text.split("#[cfg(test)]\nmod tests")[0].splitlines()


def lines_with_a_name() -> Iterator[str]:
    for crate in sorted((ROOT / "crates").iterdir()):
        if crate.name in ("carom", "carom-rules"):
            continue
        for path in sorted((crate / "src").rglob("*.rs")):
            if path.name == "tests.rs":
                continue
            for number, line in enumerate(rust_without_tests(path), 1):
                if RUST.search(line) and not line.lstrip().startswith("//"):
                    yield f"{path.relative_to(ROOT)}:{number}: {line.strip()}"
    for folder, pattern in (("python/carom", "*.py"), ("web/src", "*.ts")):
        for path in sorted((ROOT / folder).rglob(pattern)):
            if "words" in path.parts or "pkg" in path.parts:
                continue
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                if WORD.search(line) or LISTED.search(line):
                    yield f"{path.relative_to(ROOT)}:{number}: {line.strip()}"


def catch_alls() -> Iterator[str]:
    """Arms ``_ =>`` in a match that has an arm for a game or for one of its facts."""
    for path in sorted((ROOT / "crates").glob("*/src/**/*.rs")):
        lines = rust_without_tests(path)
        for number, line in enumerate(lines):
            if not (arm := ARM.match(line)) or "=>" not in line:
                continue
            indent = arm[1]
            for later, other in enumerate(lines[number + 1 :], number + 2):
                if other.strip() and not other.startswith(indent):
                    break
                if other.startswith(f"{indent}_ =>"):
                    yield f"{path.relative_to(ROOT)}:{later}: {other.strip()}"
                    break


def test_few_lines_outside_the_rules_tell_games_apart_by_name() -> None:
    found = list(lines_with_a_name())
    remedy = "read the game's facts instead (CONTRIBUTING, Add a game)"
    assert len(found) <= MOST_LINES, "\n".join([remedy, *found])


def test_no_match_on_games_has_a_catch_all() -> None:
    found = sorted(set(catch_alls()))
    assert found == [], "a new game would get its answer silently; name every case"
