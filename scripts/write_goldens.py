"""Rewrite the goldens: shots, noisy variants, random games, decisions and environments.

    python scripts/write_goldens.py

It also redraws the README's pictures, because they show results.
"""

from __future__ import annotations

import hashlib
import json
import math
import random
from pathlib import Path
from typing import Any

import carom
import carom.env
import gymnasium
import numpy as np
from carom import picture
from carom.learn import Posterior
from carom.learn.table_model import TableModel
from carom.plan import ListedTables

ROOT = Path(__file__).parents[1]
# Shot, multiple of the Olympiad's noise, seed, first index. The last two of the second row need
# more than 32 bits.
NOISES = (("half_ball_cut", 1.0, 42, 0), ("nine_ball_break", 0.5, (1 << 53) - 1, 1 << 40))
VARIANTS = 8
# The version of the results that the goldens have.
VERSION = ROOT / "goldens" / "version.txt"
MOVES = 12
# The options of the decisions: enough simulated shots for a second round.
THINKING = {"noise": "club", "opponentNoise": "professional", "simulations": 4000}
# The README's pictures: a break in which the 6 and the 9 fall, and a shot file.
PICTURES = {
    "nine_ball_break": lambda: carom.break_shot("nine-ball", seed=20),
    "jump_shot": lambda: carom.Shot.load(ROOT / "shots" / "jump_shot.json"),
}


def main() -> None:
    """Simulate, write the goldens and draw the README's pictures."""
    goldens = {}
    for path in sorted((ROOT / "shots").glob("*.json")):
        trace = carom.Shot.load(path).simulate()
        goldens[path.stem] = {"events": len(trace), "hash": trace.hash}
    rows = ",\n".join(f"  {json.dumps(name)}: {json.dumps(row)}" for name, row in goldens.items())
    now = {"shots": f"{{\n{rows}\n}}\n", "noise": _noise(), "games": _games()}
    version = carom.build_info()["results"]
    if version == int(VERSION.read_text(encoding="utf-8")) and (others := changed(now)):
        raise SystemExit(
            f"other results ({', '.join(others)}): increase RESULTS_VERSION in "
            "crates/carom/src/version.rs, build, and run this again"
        )
    VERSION.write_text(f"{version}\n", encoding="utf-8")
    for name, text in now.items():
        (ROOT / "goldens" / f"{name}.json").write_text(text, encoding="utf-8")
    (ROOT / "goldens" / "decisions.json").write_text(_decisions(), encoding="utf-8")
    (ROOT / "goldens" / "learned.json").write_text(_learned(), encoding="utf-8")
    _write_environments()
    _write_presets()
    for name, shot in PICTURES.items():
        drawn = picture.png(shot().simulate(), title=name.replace("_", " "))
        (ROOT / "docs" / "images" / f"{name}.png").write_bytes(drawn)
    print(f"{len(goldens)} goldens written; explain a change in CHANGELOG.md")


def changed(now: dict[str, str]) -> list[str]:
    """The goldens that differ from the stored ones. One that is only added changes nothing.

    Args:
        now: The text of each file, by its name without its ending.
    """
    found = []
    for file, text in now.items():
        stored = _by_name(json.loads((ROOT / "goldens" / f"{file}.json").read_text("utf-8")))
        new = _by_name(json.loads(text))
        found += [f"{file}: {name}" for name in stored if new.get(name) != stored[name]]
    return found


def _by_name(goldens: dict[str, Any] | list[Any]) -> dict[str, Any]:
    """The goldens of a file by the name of their shot, or by their game."""
    if isinstance(goldens, dict):
        return goldens
    return {row.get("game") or row["shot"]: row for row in goldens}


def _write_environments() -> None:
    """Store the hash of every environment. That of a version never changes."""
    path = ROOT / "goldens" / "environments.json"
    stored = json.loads(path.read_text(encoding="utf-8"))
    now = {name: environment_hash(name) for name in sorted(carom.env.ENVIRONMENTS)}
    for name in now.keys() & stored.keys():
        if now[name] != stored[name]:
            raise SystemExit(f"{name} has other results: increase its version in env/registry.py")
    rows = ",\n".join(f"  {json.dumps(name)}: {json.dumps(row)}" for name, row in now.items())
    path.write_text(f"{{\n{rows}\n}}\n", encoding="utf-8")


def environment_hash(name: str) -> str:
    """The first 16 digits of the SHA-256 of five steps of sixteen environments."""
    envs = gymnasium.make_vec(name, num_envs=16, noise=carom.Noise.olympiad(1.0))
    chance = np.random.default_rng(5)
    parts = [envs.reset(seed=3)[0]]
    for _ in range(5):
        actions = chance.uniform(-1, 1, envs.action_space.shape).astype(np.float32)
        parts += envs.step(actions)[:4]
    return hashlib.sha256(b"".join(part.tobytes() for part in parts)).hexdigest()[:16]


def _write_presets() -> None:
    """Store the values of every dated preset. Values that are stored already never change."""
    dated = {preset["name"]: preset["dated_name"] for preset in carom.physics()}
    now = {f"physics-{preset['dated_name']}": preset["physics"] for preset in carom.physics()}
    for table in carom.tables():
        now[f"table-{table['dated_name']}"] = {
            **{d["key"]: d["value"] for d in table["dimensions"]},
            "pockets": table["pockets"],
            "physics": dated.get(table["physics"], table["physics"]),
            "spots": table["markings"]["spots"],
        }
    folder = ROOT / "goldens" / "presets"
    folder.mkdir(exist_ok=True)
    for name, values in now.items():
        path = folder / f"{name}.json"
        stored = json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
        text = json.dumps(_with_new_keys(stored, values), indent=1, ensure_ascii=False)
        path.write_text(f"{text}\n", encoding="utf-8")


def _with_new_keys(stored: dict[str, Any], now: dict[str, Any]) -> dict[str, Any]:
    merged = dict(stored)
    for key, value in now.items():
        old = stored.get(key)
        if key not in stored:
            merged[key] = value
        elif isinstance(old, dict) and isinstance(value, dict):
            merged[key] = _with_new_keys(old, value)
    return merged


def _noise() -> str:
    goldens = []
    for name, multiplier, seed, first in NOISES:
        shot = carom.Shot.load(ROOT / "shots" / f"{name}.json")
        noise = carom.Noise.olympiad(multiplier)
        result = shot.vary(noise, VARIANTS, seed=seed, first=first)
        strikes = zip(
            result.speed, result.azimuth, result.elevation, result.side, result.height, strict=True
        )
        rows = zip(strikes, result.events, result.final_position[:, 0], strict=True)
        variants = [
            {"strike": list(strike), "events": int(events), "final": final.tolist()}
            for strike, events, final in rows
        ]
        head = {"shot": name, "olympiad": multiplier, "seed": seed, "first": first}
        lines = ",\n".join(f"    {json.dumps(variant)}" for variant in variants)
        goldens.append(f'  {json.dumps(head)[:-1]}, "variants": [\n{lines}\n  ]}}')
    return "[\n" + ",\n".join(goldens) + "\n]\n"


def _games() -> str:
    games = []
    for seed, game in enumerate(carom.rule_sets()):
        frame = carom.Frame(game, seed=seed)
        moves = _moves(frame, random.Random(seed))
        head = {"game": game, "seed": seed}
        lines = ",\n".join(f"    {json.dumps(move)}" for move in moves)
        end = json.dumps(frame.to_dict())
        games.append(f'  {json.dumps(head)[:-1]}, "moves": [\n{lines}\n  ], "end": {end}}}')
    return "[\n" + ",\n".join(games) + "\n]\n"


def _decisions() -> str:
    """What players decide after some random moves, and which plays they recommend."""
    rows = []
    for seed, game in enumerate(carom.rule_sets()):
        frame = _middle(game, seed, "shot")
        rows += [decided(frame, {**THINKING, "seed": seed})]
        rows += [decided(frame, {**THINKING, "rounds": 1}, count=4)]
    push_out = _middle("nine-ball", 0, "choice")
    pool, caroms = _middle("eight-ball", 1, "shot"), _middle("three-cushion", 0, "shot")
    sighted = {**THINKING, "perception": {"position": 0.002}}
    rows += [decided(push_out, THINKING), decided(pool, sighted, count=1)]
    for name in carom.players()[1:]:
        for frame in (pool, push_out, caroms):
            rows += [decided(frame, {"name": f"{name}:300", "noise": "club"})]
    return "[\n" + ",\n".join(f"  {json.dumps(row)}" for row in rows) + "\n]\n"


#: What is known about two tables: the free numbers, and their standard deviations in steps. On the
#: second one balls lie at the rails, and have no room on some drawn tables.
KNOWN = {
    "wpa-9ft": (("rolling.a", "cushion.restitution.a"), 8.0),
    "carom-10ft": (("rolling.a", "table.width"), 5.0),
}
#: The game, the balls and the strike on each, and what the evaluations ask beyond the defaults.
LEARNED = (
    (
        "wpa-9ft",
        "nine-ball",
        {"cue": (0.5, 1.2), "1": (0.9, 1.9), "9": (0.3, 0.6)},
        {"speed": 1.2, "azimuth": 1.05},
        ({}, {"draws": 5, "perception": {"position": 0.001}}, {"watch": "1", "precision": 0.04}),
    ),
    (
        "carom-10ft",
        "three-cushion",
        {"cue": (0.864, 0.801), "yellow": (0.0312, 0.143), "red": (1.076, 2.473)},
        {"speed": 3.0, "azimuth": 1.8, "side": 0.3, "elevation": 0.06},
        ({}, {"seed": 3, "level": 0.8}),
    ),
)
#: Drawn tables of a golden; questions take 4 of them unless they say otherwise.
DRAWN, DRAWS = 12, 4


def _learned() -> str:
    """Chances on learned tables, and the plays that are recommended there."""
    rows = []
    for table, game, balls, strike, questions in LEARNED:
        names, steps = KNOWN[table]
        model = TableModel(table, None, names)
        covariance = np.diag((steps * model.steps) ** 2)
        file = Posterior(model, model.start, covariance, 30).to_dict(draws=DRAWN)
        learned = {key: file[key] for key in ("table", "physics", "draws")}
        shot = carom.Shot(table, balls, {"ball": next(iter(balls)), **strike})
        known = ListedTables.from_dict(learned)
        on_it = carom.Shot(known.table, shot.balls, physics=known.physics)
        frame = carom.Frame.of_shot(game, on_it)
        thinking = {"noise": "club", "simulations": 1000, "seed": 1}
        rows.append(
            {
                "learned": learned,
                "shot": shot.to_dict(),
                "evaluations": [evaluated(shot, learned, asked) for asked in questions],
                "decisions": [decided(frame, thinking, count, known) for count in (None, 3)],
            }
        )
    return "[\n" + ",\n".join(f"  {json.dumps(row)}" for row in rows) + "\n]\n"


def evaluated(shot: carom.Shot, learned: dict[str, Any], options: dict[str, Any]) -> dict[str, Any]:
    """The options of an evaluation on a learned table, named as in JavaScript, and its result."""
    given: dict[str, Any] = {"draws": DRAWS, **options}
    if "perception" in given:
        given["perception"] = carom.Perception.from_dict(given["perception"])
    noise, known = carom.Noise.preset("club"), ListedTables.from_dict(learned)
    found = shot.evaluate(noise, 2000, **given, posterior=known).to_dict()
    # These are what was asked.
    for key in ("noise", "perception"):
        del found[key]
    return {"options": {"draws": DRAWS, **options}, "result": found}


def _middle(game: str, seed: int, kind: str) -> carom.Frame:
    """A frame after some random moves that requests a shot or a choice, from ``seed`` on."""
    while True:
        frame, chance = carom.Frame(game, seed=seed), random.Random(seed)
        for _ in range(MOVES // 2):
            _moves(frame, chance, 1)
            if kind == "choice" and frame.request["kind"] == kind:
                break
        if frame.request["kind"] == kind:
            return frame
        seed += 1


def decided(
    frame: carom.Frame,
    options: dict[str, Any],
    count: int | None = None,
    known: ListedTables | None = None,
) -> dict[str, Any]:
    """A decision or, with ``count``, an analysis. The options are named as in JavaScript."""
    given = dict(options)
    noise = carom.Noise.preset(given.pop("noise"))
    opponent = given.pop("opponentNoise", None)
    told: dict[str, Any] = {
        "noise": noise,
        "opponent_noise": opponent and carom.Noise.preset(opponent),
        "posterior": known,
        "draws": DRAWS,
    }
    if "perception" in given:
        given["perception"] = carom.Perception(**given["perception"])
    player = carom.Player(given.pop("name", None), **given)
    # Without the engine's version, which does not change a decision.
    record = {key: value for key, value in frame.record.items() if key != "engine"}
    row: dict[str, Any] = {"options": options, "record": record}
    if count is None:
        made = player.choose(frame, **told)
        spent: Any = made
        row["decision"] = {
            "play": made.play and _plain_play(made.play.to_dict()),
            "choice": made.choice,
            "win_chance": made.win_chance,
        }
    else:
        analysis = player.explain(frame, count, **told)
        spent, plays = analysis, analysis.to_dict()["plays"]
        for play in plays:
            # The aim is the other values in words.
            del play["aim"]
            play["play"] = _plain_play(play["play"])
        row |= {"count": count, "analysis": {"plays": plays}}
    row["decision" if count is None else "analysis"] |= {
        "simulations": spent.simulations,
        "rounds": spent.rounds,
    }
    return row


def _plain_play(play: dict[str, Any]) -> dict[str, Any]:
    """A play without the parts of the call that it does not have."""
    if "call" not in play:
        return play
    return {**play, "call": {key: value for key, value in play["call"].items() if value}}


def _moves(frame: carom.Frame, chance: random.Random, most: int = MOVES) -> list[dict[str, Any]]:
    """Play random moves: each move with its ruling, and the hashes of its shot and of the frame."""
    moves: list[dict[str, Any]] = []
    while len(moves) < most and not frame.over:
        request = frame.request
        if request["kind"] == "choice":
            choice = chance.choice(request["choices"])
            ruling = _plain(frame.choose(choice))
            moves.append({"choice": choice, "ruling": ruling, "frame": frame.hash})
            continue
        numbers: dict[str, Any] = {
            "speed": chance.uniform(1.0, 8.0),
            "azimuth": chance.uniform(-math.pi, math.pi),
            "elevation": 0.0,
            "side": chance.uniform(-0.3, 0.3),
            "height": chance.uniform(-0.3, 0.3),
        }
        strike, call = carom.Strike(**numbers), _call(frame, chance)
        place = _place(frame, chance, strike, call) if request["in_hand"] else None
        ruling = frame.play(strike, cue_ball=place, call=call)
        assert ruling.trace is not None
        play: dict[str, Any] = {"strike": numbers}
        if place is not None:
            play["cue_ball"] = place
        if call is not None:
            said = {"kind": call.kind, "ball": call.ball, "into": call.into}
            play["call"] = {key: value for key, value in said.items() if value is not None}
        moves.append(
            {
                "play": play,
                "hash": ruling.trace.hash,
                "ruling": _plain(ruling),
                "frame": frame.hash,
            }
        )
    return moves


def _call(frame: carom.Frame, chance: random.Random) -> carom.Call | None:
    request = frame.request
    kind = chance.choice(request["calls"])
    if kind == "nothing":
        return None
    if kind == "on":
        return carom.Call.on(chance.choice(request["on"]))
    if kind == "pocket":
        balls = [ball for ball in frame.balls if ball != request["cue_ball"]]
        return carom.Call.pocket(chance.choice(request["on"] or balls), "top-left")
    return carom.Call.safety() if kind == "safety" else carom.Call.push_out()


def _place(
    frame: carom.Frame, chance: random.Random, strike: carom.Strike, call: carom.Call | None
) -> list[float]:
    """A free place for the cue ball in its region, in the middle of the table's width."""
    bounds = frame.hand_bounds
    assert bounds is not None
    while True:
        x, y = chance.uniform(0.61, 0.66), chance.uniform(0.5, 0.6)
        if frame.request["in_hand"] == "the-d":
            x, y = x + 0.25, y + 0.13
        if y > bounds[1][1]:
            y -= 0.2
        try:
            frame.shot(strike, cue_ball=(x, y), call=call)
        except carom.InputError:
            continue
        return [x, y]


def _plain(ruling: carom.Ruling) -> dict[str, Any]:
    return {
        "legal": ruling.legal,
        "fouls": [dict(foul) for foul in ruling.fouls],
        "points": list(ruling.points),
        "spotted": list(ruling.spotted),
        "racked": ruling.racked,
        **({} if ruling.carom is None else {"carom": dict(ruling.carom)}),
    }


if __name__ == "__main__":
    main()
