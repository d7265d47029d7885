"""Tournaments: `carom.arena.Tournament`, `carom arena run`."""

from __future__ import annotations

import copy
import hashlib
import json
import pickle
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import carom
import jsonschema
import pytest
from carom import InputError
from carom.arena import Tournament
from carom.arena.named_players import named_player
from carom.arena.tournament_schedule import Round, swiss_round

if TYPE_CHECKING:
    from conftest import CommandLine

SECRET = "ab" * 32
FILE: dict[str, Any] = {
    "format": "carom-tournament/1",
    "secret": SECRET,
    "players": ["greedy:10", "pool-master:10", "deep-green-0:10"],
    "events": [
        {"name": "all", "type": "round-robin", "game": "nine-ball", "pairs": 2, "block": 1},
    ],
}


def file(**changes: Any) -> dict[str, Any]:
    return copy.deepcopy(FILE) | changes


def event(**changes: Any) -> dict[str, Any]:
    """The file with one event that has these values too."""
    return file(events=[FILE["events"][0] | changes])


def records(folder: Path) -> dict[str, str]:
    """The hashes of all records by their paths."""
    return {
        path.relative_to(folder).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in folder.rglob("*.jsonl")
    }


@pytest.fixture(scope="module")
def played(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of a finished tournament."""
    out = tmp_path_factory.mktemp("tournament")
    assert Tournament(FILE).run(out, threads=2).finished
    return out


def test_everybody_meets_everybody_in_a_round_robin(played: Path) -> None:
    result = Tournament(FILE).run(played)
    assert (result.finished, result.pairs, result.pairs_now) == (True, 6, 0)
    (table,) = result.standings
    assert table.condition == "nine-ball"
    assert {row.player: row.frames for row in table.players} == dict.fromkeys(FILE["players"], 8)
    assert sum(row.points for row in table.players) == 12
    assert len(records(played)) == 6
    assert "6 pairs of frames, 0 of them now; finished" in str(result)
    assert json.loads(json.dumps(result.to_dict()))["pairs"] == 6


def test_every_record_of_a_tournament_replays(played: Path) -> None:
    for path in sorted(played.rglob("match.jsonl"))[:2]:
        assert carom.replay_match(path.read_text()).difference is None


def test_matches_have_secrets_of_their_own(played: Path, tmp_path: Path) -> None:
    def secrets(folder: Path) -> list[str]:
        paths = sorted(folder.rglob("match.jsonl"))
        return [json.loads(path.read_text().splitlines()[-1])["secret"] for path in paths]

    assert len(set(secrets(played))) == 6
    assert SECRET not in secrets(played)
    without = file(players=FILE["players"][:2])
    del without["secret"]
    for name in ("one", "other"):
        Tournament(without).run(tmp_path / name)
    drawn = secrets(tmp_path / "one") + secrets(tmp_path / "other")
    assert len(set(drawn)) == 4


def test_a_further_player_and_more_pairs_play_only_what_is_missing(tmp_path: Path) -> None:
    first = file(players=FILE["players"][:2])
    assert Tournament(first).run(tmp_path).pairs_now == 2
    before = records(tmp_path)
    assert Tournament(FILE).run(tmp_path).pairs_now == 4
    assert Tournament(event(pairs=3)).run(tmp_path).pairs_now == 3
    after = records(tmp_path)
    assert len(after) == 9
    assert before.items() <= after.items()
    # In another order of the players nothing is missing.
    reordered = event(pairs=3) | {"players": FILE["players"][::-1]}
    assert Tournament(reordered).run(tmp_path).pairs_now == 0


def test_what_an_ended_program_left_beside_a_whole_record_is_removed(tmp_path: Path) -> None:
    # Seen: killed between the two, a program left played.jsonl beside match.jsonl for ever.
    file = event(pairs=1)
    Tournament(file).run(tmp_path)
    expected = records(tmp_path)
    (whole, *_) = tmp_path.rglob("match.jsonl")
    for name in ("played.jsonl", "secret"):
        whole.with_name(name).write_text("left", encoding="utf-8")
    assert Tournament(file).run(tmp_path).pairs_now == 0
    assert records(tmp_path) == expected
    assert not list(tmp_path.rglob("secret"))


PROGRAM = """
import json, os, signal, sys, time
from pathlib import Path
from carom.arena import Tournament

file = json.loads(sys.argv[1])

def size(folder):
    return sum(path.stat().st_size for path in folder.rglob("*.jsonl"))

def run(folder, threads, kill):
    child = os.fork()
    if not child:
        try:
            Tournament(file).run(folder, threads=threads)
        finally:
            os._exit(0)
    if kill:
        before = size(folder)
        # The child is killed while it goes on, at another place each time.
        while size(folder) <= before and not os.waitpid(child, os.WNOHANG)[0]:
            time.sleep(0.001)
        try:
            os.kill(child, signal.SIGKILL)
        except ProcessLookupError:
            return
    try:
        os.waitpid(child, 0)
    except ChildProcessError:
        pass

for threads in (1, 2, 7):
    run(Path(f"threads-{threads}"), threads, kill=False)
for attempt in range(10):
    run(Path("killed"), 1 + attempt % 3, kill=True)
unfinished = len(list(Path("killed").rglob("match.jsonl")))
run(Path("killed"), 2, kill=False)
print(unfinished)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="it needs fork")
def test_records_do_not_depend_on_threads_and_kills(tmp_path: Path) -> None:
    small = event(pairs=6, block=2)
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM, json.dumps(small)],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=True,
        timeout=300,
    )
    assert int(done.stdout) < 9, "the last kill came before the end"
    expected = records(tmp_path / "threads-1")
    assert len(expected) == 9
    for name in ("threads-2", "threads-7", "killed"):
        assert records(tmp_path / name) == expected, name


def test_conditions_are_the_product_of_the_lists() -> None:
    several = event(noise=["olympiad", "olympiad:0.5"], simulations=[5, 10], game=["nine-ball"])
    (found,) = Tournament(several)._file.events
    assert [each.title for each in found.conditions] == [
        "nine-ball, noise olympiad, 5 simulations a decision",
        "nine-ball, noise olympiad, 10 simulations a decision",
        "nine-ball, noise olympiad:0.5, 5 simulations a decision",
        "nine-ball, noise olympiad:0.5, 10 simulations a decision",
    ]
    assert len({each.key for each in found.conditions}) == 4
    same = Tournament(event(noise="olympiad:1"))._file.events[0].conditions[0]
    other = Tournament(event(noise="olympiad"))._file.events[0].conditions[0]
    assert same.key == other.key, "the same errors"


def test_a_gauntlet_meets_all_others(tmp_path: Path) -> None:
    gauntlet = event(type="gauntlet", players=["greedy:10"], pairs=1)
    (table,) = Tournament(gauntlet).run(tmp_path).standings
    frames = {row.player: row.frames for row in table.players}
    assert frames == {"greedy:10": 4, "pool-master:10": 2, "deep-green-0:10": 2}


def test_a_swiss_tournament_draws_its_rounds_from_the_results(tmp_path: Path) -> None:
    players = [*FILE["players"], "deep-green-1:10", "pick-pocket:10"]
    swiss = event(type="swiss", rounds=3, pairs=1) | {"players": players}
    result = Tournament(swiss).run(tmp_path)
    assert (result.finished, result.pairs) == (True, 6)
    rounds = [json.loads(path.read_text()) for path in sorted(tmp_path.rglob("round-*.json"))]
    met = [frozenset(pair) for each in rounds for pair in each["pairs"]]
    assert len(set(met)) == 6, "two players meet only once"
    assert len({each["bye"] for each in rounds}) == 3
    assert Tournament(swiss).run(tmp_path).pairs_now == 0


def test_in_a_swiss_round_players_with_equal_points_meet() -> None:
    first = Round((("a", "b"), ("c", "d")), None)
    points = {"a": (1.0, 0.6), "b": (0.0, 0.4), "c": (1.0, 0.9), "d": (0.0, 0.1)}
    assert swiss_round("abcd", points, [first]).pairs == (("a", "c"), ("b", "d"))
    second = Round((("a", "c"), ("b", "d")), None)
    points = {"a": (2.0, 1.2), "b": (1.0, 0.9), "c": (1.0, 1.1), "d": (0.0, 0.3)}
    assert swiss_round("abcd", points, [first, second]).pairs == (("a", "d"), ("b", "c"))


def test_a_test_of_a_change_ends_when_it_decides(tmp_path: Path) -> None:
    players = [{"name": "new", "player": "pick-pocket:10"}, {"name": "base", "player": "greedy:10"}]
    test = event(type="test", players=["new", "base"], shares=[0.05, 0.3], pairs=40)
    result = Tournament(test | {"players": players}).run(tmp_path)
    (found,) = result.tests
    assert found.players == ("new", "base")
    assert found.test.accepted == "p1"
    assert found.pairs < 40
    assert "new against base" in str(result)
    assert Tournament(test | {"players": players}).run(tmp_path).pairs_now == 0


def test_a_test_of_normalised_elo(tmp_path: Path) -> None:
    players = [{"name": "new", "player": "pick-pocket:10"}, {"name": "base", "player": "greedy:10"}]
    test = event(type="test", players=["new", "base"], nelo=[-1500, -1000], pairs=40)
    (found,) = Tournament(test | {"players": players}).run(tmp_path).tests
    assert (found.test.unit, found.test.accepted) == ("nelo", "p1")
    assert found.nelo > -1000
    assert "test of -1500 against -1000 normalised Elo: accepts -1000" in str(found)
    (header,) = [path.read_text().splitlines()[0] for path in tmp_path.rglob("match.jsonl")]
    assert json.loads(header)["test"]["unit"] == "nelo"
    # In Elo it is a test of shares.
    (elo,) = Tournament(event(type="test", players=FILE["players"][:2], elo=[0, 35]))._file.events
    assert elo.shares == pytest.approx((0.5, 0.5502), abs=1e-4)
    assert Tournament(test | {"players": players}).run(tmp_path).pairs_now == 0


def test_a_break_is_given_to_both_players(tmp_path: Path) -> None:
    strike = {"strike": {"speed": 8, "azimuth_deg": 90}, "cue_ball": [0.635, 0.6]}
    several = event(same_break=["rail", strike], pairs=1) | {"players": FILE["players"][:2]}
    tournament = Tournament(several)
    (found,) = tournament._file.events
    assert found.conditions[0].title == "nine-ball, break rail"
    assert len({each.key for each in found.conditions}) == 2
    assert Tournament(FILE)._file.events[0].conditions[0].key != found.conditions[0].key
    assert tournament.run(tmp_path).finished
    rail = carom.break_shot("nine-ball", preset="rail")
    breaks = {}
    for path in sorted(tmp_path.rglob("match.jsonl")):
        header, *frames, _ = map(json.loads, path.read_text().splitlines())
        for frame in frames:
            assert frame["moves"][0]["given"] is True
            assert frame["moves"][0]["play"] == header["same_break"]
        breaks[path.parts[-4]] = header["same_break"]["strike"]
    by_preset, by_strike = (breaks[each.key] for each in found.conditions)
    assert by_preset["azimuth"] == rail.azimuth
    assert (by_strike["speed"], by_strike["azimuth"]) == pytest.approx((8, 1.5707963))


class Conceder:
    """A player that gives up."""

    name = "conceder"

    def choose(self, situation: carom.Situation) -> str:
        return "concede"


def test_players_are_also_objects_and_classes_in_files(tmp_path: Path) -> None:
    (tmp_path / "mine.py").write_text(
        "class Mine:\n    def choose(self, situation):\n        return 'concede'\n"
    )
    players = [Conceder(), {"name": "mine", "player": "mine.py:Mine"}, "greedy:10"]
    mixed = event(pairs=1) | {"players": players}
    (table,) = Tournament(mixed, folder=tmp_path).run(tmp_path / "out", threads=2).standings
    assert table.players[0].player == "greedy:10"
    assert table.players[0].points == 4
    assert {row.player for row in table.players} == {"conceder", "mine", "greedy:10"}


def test_files_of_one_name_in_two_folders_are_two_players(tmp_path: Path) -> None:
    # Seen: an old and a new version of mine.py met, and one module replaced the other.
    for folder in ("old", "new"):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "mine.py").write_text(
            f"class Mine:\n    name = {folder!r}\n\nclass Other(Mine):\n    pass\n"
            "def choose(self, situation):\n    return 'concede'\n\nMine.choose = choose\n"
        )
    old, new, other = (
        named_player("one", word, tmp_path)
        for word in ("old/mine.py:Mine", "new/mine.py:Mine", "old/mine.py:Other")
    )
    assert (old.name, new.name) == ("old", "new")
    for player in (old, new, other):
        assert pickle.loads(pickle.dumps(player)) is player


PROGRAM_THAT_CONCEDES = """
import json, sys
for line in sys.stdin:
    message = json.loads(line)
    if message["type"] == "hello":
        print(json.dumps({"type": "hello", "name": "conceder", "version": "1"}), flush=True)
    elif message["type"] == "match":
        print(json.dumps({"type": "ready"}), flush=True)
    elif message["type"] == "request":
        print(json.dumps({"type": "concede", "id": message["id"]}), flush=True)
"""


@pytest.mark.skipif(sys.platform != "linux", reason="programs play on Linux")
def test_names_of_files_are_relative_to_the_file_of_the_tournament(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    league, elsewhere = tmp_path / "league", tmp_path / "elsewhere"
    for place in (league, elsewhere):
        place.mkdir()
    (league / "program.py").write_text(PROGRAM_THAT_CONCEDES)
    (league / "mine.py").write_text(
        "class Mine:\n    def choose(self, situation):\n        return 'concede'\n"
    )
    written = event(pairs=1, frame_simulations=1000) | {
        "players": [
            {
                "name": "program",
                "player": f"exec[menu=3]:'{sys.executable}' program.py --level 1.5",
            },
            {"name": "mine", "player": "mine.py:Mine"},
        ]
    }
    (league / "league.json").write_text(json.dumps(written))
    monkeypatch.chdir(elsewhere)
    result = Tournament.load(league / "league.json").run(tmp_path / "out")
    assert result.finished
    (path,) = (tmp_path / "out").rglob("match.jsonl")
    header, *frames, _ = map(json.loads, path.read_text().splitlines())
    assert [frame["end"]["reason"] for frame in frames] == ["conceded"] * 2
    (program,) = [each for each in header["players"] if "program" in each["settings"]]
    assert program["settings"]["program"][1:] == ["program.py", "--level", "1.5"]
    assert list(program["settings"]["sha256"])[1:] == ["program.py"]
    assert program["settings"]["settings"] == {"menu": 3}
    # The tournament continues in another folder, and there it has the same records.
    monkeypatch.chdir(league)
    assert Tournament.load("league.json").run(tmp_path / "out").pairs_now == 0
    Tournament.load("league.json").run(tmp_path / "again")
    assert records(tmp_path / "again") == records(tmp_path / "out")


def test_processes_give_the_records_of_one_thread(tmp_path: Path) -> None:
    (tmp_path / "drawing.py").write_text(DRAWING)
    players = [{"name": "drawing", "player": "drawing.py:Drawing"}, "greedy:10", "pool-master:10"]
    test = {"name": "t", "type": "test", "players": ["drawing", "greedy:10"], "shares": [0.05, 0.6]}
    swiss = {"name": "s", "type": "swiss", "pairs": 1}
    settings = {"game": "nine-ball", "simulations": 10, "patience": 6}
    written = file(
        players=players,
        events=[
            FILE["events"][0] | {"patience": 6, "simulations": 10},
            test | settings | {"pairs": 6},
            swiss | settings,
        ],
    )
    tournament = Tournament(written, folder=tmp_path)
    one = tournament.run(tmp_path / "one", threads=1)
    two = tournament.run(tmp_path / "two", processes=2)
    assert (one.finished, two.finished) == (True, True)
    assert records(tmp_path / "one") == records(tmp_path / "two")
    assert len(records(tmp_path / "one")) == 6 + 1 + 2
    assert tournament.run(tmp_path / "one", processes=1).pairs_now == 0


DRAWING = """
import random
import carom


class Drawing:
    def choose(self, situation):
        request = situation.frame.request
        if request.kind == "choice":
            return request.choices[0]
        azimuth = random.Random(situation.seed).uniform(0, 6.28)
        place = (0.635, 0.5) if request.in_hand else None
        return carom.Play(carom.Strike(3.0, azimuth), cue_ball=place)
"""


def test_processes_are_refused_before_the_first_frame(tmp_path: Path) -> None:
    class Local(Conceder):
        pass

    local = event(pairs=1) | {"players": [{"name": "a", "player": Local}, "greedy:10"]}
    out = tmp_path / "out"
    for options, place in (
        ({"processes": 2}, "players.a"),
        ({"processes": 0}, "processes"),
        ({"processes": 2, "threads": 1}, "threads"),
        ({"processes": 2, "ray": True}, "ray"),
    ):
        with pytest.raises(InputError) as refused:
            Tournament(local).run(out, **options)
        assert refused.value.place == place
    assert not out.exists()


def test_a_killed_process_ends_the_run_which_continues(tmp_path: Path) -> None:
    (tmp_path / "deadly.py").write_text(DRAWING + DEADLY)
    (tmp_path / "armed").touch()
    players = [{"name": "deadly", "player": "deadly.py:Deadly"}, "greedy:10"]
    written = event(pairs=3, patience=6, simulations=10) | {"players": players}
    tournament = Tournament(written, folder=tmp_path)
    with pytest.raises(InputError, match="while it played pair 0; the same call continues"):
        tournament.run(tmp_path / "out", processes=2)
    (tmp_path / "armed").unlink()
    assert tournament.run(tmp_path / "out", processes=2).finished


DEADLY = """
import os, signal
from pathlib import Path

ARMED = Path(__file__).with_name("armed")

class Deadly(Drawing):
    def choose(self, situation):
        if ARMED.exists():
            os.kill(os.getpid(), getattr(signal, "SIGKILL", signal.SIGTERM))
        return super().choose(situation)
"""


def test_a_changed_player_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    small = file(players=FILE["players"][:2])
    Tournament(small).run(tmp_path)
    entry = carom._core.player_entry

    def changed(name: str, folder: Path) -> dict[str, Any]:
        found = entry(name, folder)
        found["settings"]["decisions"] = "0" * 16
        return found

    monkeypatch.setattr("carom._core.player_entry", changed)
    with pytest.raises(InputError, match="decides otherwise") as refused:
        Tournament(small).run(tmp_path)
    assert (refused.value.kind, refused.value.place) == ("changed", "players.greedy:10")


def test_a_name_stands_for_one_player(tmp_path: Path) -> None:
    def named(player: str) -> dict[str, Any]:
        return event(pairs=1) | {"players": ["greedy:10", {"name": "mine", "player": player}]}

    Tournament(named("pool-master:10")).run(tmp_path)
    with pytest.raises(InputError, match=r"^players.mine: the name stood for pool-master:10"):
        Tournament(named("pick-pocket:10")).run(tmp_path)


WRONG: dict[str, tuple[dict[str, Any], str]] = {
    "another format": (file(format="carom-tournament/9"), "format"),
    "an unknown key": (file(player=[]), "player"),
    "one player": (file(players=["greedy"]), "players"),
    "a player twice": (file(players=["greedy", "greedy"]), "players[1]"),
    "no such player": (file(players=["greedy", "someone"]), "players[1]"),
    "a short secret": (file(secret="abc"), "secret"),
    "no events": (file(events=[]), "events"),
    "a name of no folder": (event(name="a/b"), "events[0].name"),
    "an unknown type": (event(type="cup"), "events[0].type"),
    "an unknown setting": (event(nois="olympiad"), "events[0].nois"),
    "no such game": (event(game="croquet"), "events[0].game"),
    "no such noise": (event(noise="loud"), "events[0].noise"),
    "two clocks": (event(time=1, clock=2), "events[0].clock"),
    "an empty list": (event(noise=[]), "events[0].noise"),
    "no time": (event(time=[1, 0]), "events[0].time[1]"),
    "no pairs": (event(pairs=0), "events[0].pairs"),
    "rounds of a round robin": (event(rounds=2), "events[0].rounds"),
    "a match of three": (event(type="match"), "events[0].players"),
    "a test without hypotheses": (
        event(type="test", players=["greedy:10", "pool-master:10"]),
        "events[0].shares",
    ),
    "hypotheses in a wrong order": (
        event(type="test", players=["greedy:10", "pool-master:10"], shares=[0.6, 0.5]),
        "events[0].shares",
    ),
    "two ways to write hypotheses": (
        event(type="test", players=["greedy:10", "pool-master:10"], shares=[0.5, 0.6], nelo=[0, 9]),
        "events[0].shares",
    ),
    "normalised Elo out of range": (
        event(type="test", players=["greedy:10", "pool-master:10"], nelo=[0, 5000]),
        "events[0].nelo",
    ),
    "no such break": (event(same_break="cut"), "events[0].preset"),
    "a break without a strike": (
        event(same_break={"cue_ball": [1, 1]}),
        "events[0].same_break.strike",
    ),
    "a break with a wrong place": (
        event(same_break={"strike": {"speed": 1, "azimuth": 0}, "cue_ball": [1]}),
        "events[0].same_break.cue_ball",
    ),
    "a number for a break": (event(same_break=3), "events[0].same_break"),
    "a player who is not there": (event(players=["greedy:10", "carom"]), "events[0].players[1]"),
}


@pytest.mark.parametrize("what", WRONG)
def test_rejects_an_invalid_tournament_at_its_place(what: str) -> None:
    wrong, place = WRONG[what]
    with pytest.raises(InputError) as refused:
        Tournament(wrong)
    assert refused.value.place == place, refused.value
    assert refused.value.remedy


def test_the_schema_accepts_what_is_played_and_refuses_wrong_types() -> None:
    schema = jsonschema.Draft202012Validator(carom.schema("tournament"))
    jsonschema.Draft202012Validator.check_schema(carom.schema("tournament"))
    schema.validate(FILE)
    for what in ("another format", "an unknown key", "one player", "an unknown type", "no pairs"):
        assert not schema.is_valid(WRONG[what][0]), what
    known = schema.schema["properties"]["events"]["items"]["properties"]
    for key in known:
        with pytest.raises(InputError) as refused:
            Tournament(event(**{key: {"wrong": []}}))
        assert refused.value.kind != "unknown-key" or refused.value.place.endswith("wrong"), key


def test_the_command_plays_a_file_and_continues_it(run: CommandLine, tmp_path: Path) -> None:
    toml = """
format = "carom-tournament/1"
players = ["greedy:10", { name = "other", player = "pool-master:10" }]

[[events]]
name = "two"
type = "match"
game = "nine-ball"
pairs = 2
"""
    (tmp_path / "spring.toml").write_text(toml)
    done = run("arena", "run", "spring.toml")
    assert done.returncode == 0, done.stderr
    assert "2 pairs of frames, 2 of them now; finished" in done.stdout
    again = run("arena", "run", "spring.toml", "--out", "spring", "--json")
    assert json.loads(again.stdout)["pairs_now"] == 0
    (tmp_path / "wrong.toml").write_text("format = 3")
    refused = run("arena", "run", "wrong.toml")
    assert (refused.returncode, refused.stdout) == (2, "")
    assert "wrong.toml: format: " in refused.stderr


def test_the_tables_of_a_tournament_have_the_shares_corrected_for_luck(tmp_path: Path) -> None:
    tournament = Tournament(event(luck=4, pairs=3, block=2))
    result = tournament.run(tmp_path, threads=2)
    (table,) = result.standings
    corrected = {row.player: row.adjusted for row in table.players}
    assert all(share is not None and share.pairs == 6 for share in corrected.values())
    assert "corrected for luck" in str(result)
    (rated,) = carom.arena.ratings(tmp_path)
    assert {row.player: row.adjusted for row in rated.players} == corrected
    assert "corrected for luck" in str(rated)
    plain = Tournament(FILE).run(tmp_path / "plain", threads=2)
    assert "luck" not in str(plain)
    assert all(row.adjusted is None for row in plain.standings[0].players)
