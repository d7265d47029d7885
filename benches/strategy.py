"""The tables of docs/strategy.md, from the stored results of ``scripts/strategy``."""

from __future__ import annotations

from typing import Any

from carom.plan.chance import Chance
from carom.player import Player

JSON = dict[str, Any]
#: The experiments of the file.
Experiments = dict[str, JSON]


def share(count: int, trials: int) -> str:
    """A share in per cent, with its Wilson interval at 95 %."""
    chance = Chance.of(count, trials, 0.95)
    return f"{100 * count / trials:.1f} ({100 * chance.low:.1f} to {100 * chance.high:.1f})"


def points(match: JSON, player: int = 0) -> str:
    """The share of the points of a player in per cent, with the interval from pairs."""
    low, high = match["share_interval"]
    own = match["share"]
    if player == 1:
        own, low, high = 1 - own, 1 - high, 1 - low
    return f"{100 * own:.1f} ({100 * low:.1f} to {100 * high:.1f})"


def levels(found: Experiments) -> list[list[str]]:
    """The levels of strength, and how often each beats the one below."""
    rows = [["Level", "σ of the direction, °", "simulations", "points against the level below, %"]]
    for number in range(1, 6):
        name = f"level-{number}"
        player = Player(name)
        match = found.get(f"{name}-{name[:-1]}{number - 1}")
        direction = f"{float(player.noise.azimuth) * 57.29577951308232:.3f}"
        cells = [f"`{name}`", direction, str(player._core.simulations)]
        rows.append([*cells, points(match) if match else ""])
    return rows


def runs(found: Experiments) -> list[list[str]]:
    """Break and run, with the share of breaks that keep the turn."""
    head = ["Game", "noise", "breaks", "break and run, %", "won by the break itself"]
    rows = [[*head, "break keeps the turn, %", "bar, %"]]
    bars = {
        "run-eight-ball-x0.5": 60,
        "run-eight-ball-x1": 35,
        "run-eight-ball-x2": 10,
        "run-nine-ball-x0.5": 40,
        "run-nine-ball-x1": 20,
        "run-nine-ball-x2": 4,
    }
    for name, bar in bars.items():
        if visits := found.get(name):
            game = name.removeprefix("run-").rpartition("-")[0]
            n = visits["visits"]
            cells = [game, f"× {visits['noise']:g}", str(n), share(visits["won"], n)]
            # Only in games whose last ball may fall on the break.
            golden = str(visits.get("golden_breaks", 0))
            rows.append([*cells, golden, share(visits["kept"], n), str(bar)])
    return rows


def run_outs(found: Experiments) -> list[list[str]]:
    """Run-outs from ball in hand by the number of balls."""
    rows = [["Own balls", "× 0.5, %", "× 1, %", "× 2, %"]]
    for balls in (1, 2, 3, 5, 7):
        visits = [found.get(f"run-out-{balls}-x{noise}") for noise in ("0.5", "1", "2")]
        if any(visits):
            rows.append([str(balls), *(share(v["won"], v["visits"]) if v else "" for v in visits)])
    return rows


def high_runs(found: Experiments) -> list[list[str]]:
    """Runs of straight pool."""
    rows = [["Noise", "visits", "mean run", "median", "highest run"]]
    for noise in ("0.5", "1", "2"):
        if visits := found.get(f"high-run-x{noise}"):
            run = visits["points"]
            cells = [f"{run['mean']:.1f}", f"{run['median']}", f"{run['most']}"]
            rows.append([f"× {noise}", str(visits["visits"]), *cells])
    return rows


def stated(found: Experiments) -> list[list[str]]:
    """Stated chances to keep the turn, and how often it was kept with other errors."""
    tenths = [f"{10 * k} to {10 * k + 10}" for k in range(10)]
    rows = [["Noise", "chance", "stated, %", "counted, %", *tenths]]
    for noise in ("0.5", "1", "2"):
        if decisions := found.get(f"stated-x{noise}"):
            for key, title in (("kept", "turn kept"), ("foul", "foul")):
                result = decisions[key]
                cells = [""] * 10
                for tenth in result["tenths"]:
                    off = 100 * (tenth["counted"] - tenth["stated"])
                    place = min(int(10 * tenth["stated"]), 9)
                    cells[place] = f"{off:+.1f} ({tenth['decisions']})"
                means = [f"{100 * result[mean]:.1f}" for mean in ("stated", "counted")]
                rows.append([f"× {noise}", title, *means, *cells])
    return rows


def breaker(found: Experiments) -> list[list[str]]:
    """How often the player who breaks wins, among equals."""
    rows = [["Game", "noise", "frames", "the breaker wins, %", "break and run, %"]]
    for name, match in found.items():
        if name.startswith("breaker-"):
            game, _, noise = name.removeprefix("breaker-").rpartition("-")
            count = match["counts"][0]
            n = count["breaks"]
            wins, ran = share(count["break_wins"], n), share(count["runs"], n)
            rows.append([game, noise.replace("x", "× "), str(n), wins, ran])
    return rows


def own_break(found: Experiments) -> list[list[str]]:
    """The own break against a full one from the middle, among equals."""
    keeps = ["own break keeps the turn, %", "centre break keeps the turn, %"]
    rows = [["Game", "simulations", "frames", "points, %", *keeps, "bar, %"]]
    for name, match in found.items():
        if name.startswith("own-break-"):
            kept = [share(count["kept"], count["breaks"]) for count in match["counts"]]
            game, _, simulations = name.removeprefix("own-break-").rpartition("-")
            cells = [game, simulations, str(2 * match["pairs"]), points(match)]
            rows.append([*cells, *kept, "57"])
    return rows


def matrix(found: Experiments) -> list[list[str]]:
    """Points of the player of the row against that of the column."""
    matches = [match for name, match in found.items() if name.startswith("matrix-")]
    names: set[str] = set().union(*(names_of(match) for match in matches))
    order = sorted(names, key=lambda name: -total(name, matches))
    rows = [["Points, %", *(f"`{name}`" for name in order)]]
    for one in order:
        cells = [f"`{one}`"]
        for other in order:
            met = [match for match in matches if names_of(match) == {one, other}]
            cells.append(points_of(one, met[0]) if met and one != other else "")
        rows.append(cells)
    return rows


def names_of(match: JSON) -> set[str]:
    """The names of the players, without their simulated shots."""
    return {player.partition(":")[0] for player in match["players"]}


def total(name: str, matches: list[JSON]) -> float:
    """The mean share of a player over its matches."""
    shares = [
        match["share"] if k == 0 else 1 - match["share"]
        for match in matches
        for k, player in enumerate(match["players"])
        if player.partition(":")[0] == name
    ]
    return sum(shares) / len(shares)


def points_of(name: str, match: JSON) -> str:
    """The share of the points of the player of this name, with half the width of its interval."""
    own = match["share"]
    if match["players"][0].partition(":")[0] != name:
        own = 1 - own
    low, high = match["share_interval"]
    return f"{100 * own:.0f} ± {50 * (high - low):.0f}"


def strength(found: Experiments) -> list[list[str]]:
    """Ten times the simulated shots."""
    rows = [["Simulations of a decision", "against", "frames", "points, %"]]
    for name, match in found.items():
        if name.startswith("strength-"):
            one, other = (player.partition(":")[2] for player in match["players"])
            frames = 2 * match["pairs"]
            rows.append([f"{int(one):,}", f"{int(other):,}", str(frames), points(match)])
    return rows


#: The changed players of the matches `part-`.
PARTS = {
    "refining": "without refining",
    "logistic-value": "with the Markov chain as the value",
    "safeties": "without safeties",
    "common-errors": "without common errors",
    "shift": "without the shift",
    "replies": "with replies",
}


def parts(found: Experiments) -> list[list[str]]:
    """What each part of the search is worth."""
    rows = [["Player", "frames", "points against the usual player, %"]]
    for name, title in PARTS.items():
        if match := found.get(f"part-{name}"):
            rows.append([title, str(2 * match["pairs"]), points(match)])
    return rows


#: The searches that were measured against the default one. Only the last of them is left.
SEARCHES = {
    "ocba": "race with optimal computing budget allocation",
    "kr-uct": "KR-UCT",
    "replies": "race with replies",
}


def search(found: Experiments) -> list[list[str]]:
    """Other searches against the default one, with what the sequential test accepts."""
    rows = [["Search", "simulations", "frames", "points against the default, %", "test"]]
    for key, title in SEARCHES.items():
        for effort in ("5000", "50000", "5000-fixed"):
            if match := found.get(f"search-{key}-{effort}"):
                cells = [f"{int(effort.removesuffix('-fixed')):,}", str(2 * match["pairs"])]
                rows.append([title, *cells, points(match), verdict(match["test"])])
    return rows


def verdict(test: JSON | None) -> str:
    """What a sequential test accepts; nothing for a match of fixed length."""
    if test is None:
        return ""
    return f"{100 * test[test['accepted']]:g} %" if test["accepted"] else "open"


#: The matches with a bar: what is played, and the least points of the first player, %.
BARS = {
    "cue-card-same-break": ("20 000 a frame against CueCard with 200 000, same break", 50),
    "cue-card-6-s-same-break": ("300 000 a frame against CueCard with 200 000, same break", 52),
    "cue-card-6-s-own-breaks": ("300 000 a frame against CueCard with 200 000, own breaks", 57),
    "bar-carom-pick-pocket": ("3000 a decision against PickPocket with 3000, same break", 70),
    "pick-pocket-6-s-same-break": (
        "300 000 a frame against PickPocket with 200 000, same break",
        70,
    ),
    "bar-carom-greedy": ("3000 a decision against greedy, same break", 80),
    "bar-tutorial-x1": ("3000 a decision against the tutorial's planner, same break", 90),
    "bar-tutorial-x0.5": ("the same at noise × 0.5", 90),
    "bar-5-ms-greedy": ("340 a decision against greedy with simulated aim, same break", 90),
    "bound-carom-pick-pocket": (
        "without errors, 3000 a decision against PickPocket, same break",
        None,
    ),
}


def bars(found: Experiments) -> list[list[str]]:
    """The searching player against others, beside the bars."""
    rows = [["Simulations", "frames", "points, %", "bar, %"]]
    for name, (title, bar) in BARS.items():
        if match := found.get(name):
            shown = "" if bar is None else str(bar)
            rows.append([title, str(2 * match["pairs"]), points(match), shown])
    return rows


#: Published matches (Archibald, Altman & Shoham, IJCAI 2009): the points of the first player.
PUBLISHED = {
    "cue-card-pick-pocket-own-breaks": ("CueCard against PickPocket, own breaks", "77.4"),
    "cue-card-pick-pocket-same-break": ("CueCard against PickPocket, CueCard's break", "69.3"),
    "cue-card-pick-pocket-tenth": ("the same, PickPocket with a tenth of the simulations", ""),
    "level-two-off": ("CueCard without level two against CueCard", "45.2"),
    "level-two-given-to-level-one": ("its simulations given to level one", "51.6"),
    "samples-10": ("10 samples of a shot against 30", "loses"),
    "samples-20": ("20 samples against 30", "loses"),
    "samples-60": ("60 samples against 30", "equal"),
    "samples-120": ("120 samples against 30", "equal"),
    "samples-300": ("300 samples against 30", "loses"),
}


def published(found: Experiments) -> list[list[str]]:
    """The matches of the literature's players beside the published results."""
    rows = [["Match", "frames", "points of the first, %", "published, %"]]
    for name, (title, theirs) in PUBLISHED.items():
        if match := found.get(f"literature-{name}") or pooled(f"literature-{name}-", found):
            rows.append([title, str(2 * match["pairs"]), points(match), theirs])
    return rows


def pooled(prefix: str, found: Experiments) -> JSON | None:
    """The sum of the matches whose names begin so, with the normal interval of pairs at 95 %."""
    matches = [match for name, match in found.items() if name.startswith(prefix)]
    if not matches:
        return None
    counts = [sum(column) for column in zip(*(m["pair_counts"] for m in matches), strict=True)]
    pairs = sum(counts)
    mean = sum(k / 4 * count for k, count in enumerate(counts)) / pairs
    variance = sum((k / 4 - mean) ** 2 * count for k, count in enumerate(counts)) / pairs
    half = 1.96 * (variance / pairs) ** 0.5
    return {"pairs": pairs, "share": mean, "share_interval": [mean - half, mean + half]}


#: Shares of points of greedy and of Deep Green at depths 1 and 2 in percent, by the noise at which
#: about as many shots sink (Greenspan et al., IEEE Computer 2008).
DEEP_GREEN = {0.0: (9.9, 61.1, 79.9), 0.5: None, 1.0: (19.9, 62.7, 67.4), 2.0: (36.5, 54.8, 58.7)}


def deep_green(found: Experiments) -> list[list[str]]:
    """Deep Green and the greedy player, everybody against everybody."""
    rows = [
        ["Noise", "shots that sink, %", "greedy, %", "depth 1, %", "depth 2, %", "published, %"]
    ]
    names = ("greedy", "deep-green-1", "deep-green-2")
    for noise, theirs in DEEP_GREEN.items():
        pairs = [(0, 1), (0, 2), (1, 2)]
        keys = [f"literature-{names[a]}-{names[b]}-x{noise:g}" for a, b in pairs]
        if not all(key in found for key in keys):
            continue
        won: list[list[float]] = [[], [], []]
        for (a, b), key in zip(pairs, keys, strict=True):
            won[a].append(found[key]["share"])
            won[b].append(1 - found[key]["share"])
        counts = found[keys[2]]["counts"]
        sink = share(sum(c["made"] for c in counts), sum(c["pots"] for c in counts))
        cells = [f"{50 * sum(shares):.1f}" for shares in won]
        rows.append([f"× {noise:g}", sink, *cells, " / ".join(map(str, theirs or ("",)))])
    return rows


def endings(found: Experiments) -> list[list[str]]:
    """What the chosen plays of endings lose beside a search of nearly all plays."""
    rows = [["Ending", "positions", "mean loss, points", "≤ 1.5, %", "≤ 10, %", "largest, points"]]
    for name, result in found.items():
        if name.startswith("ending-"):
            losses = result["losses"]
            n = len(losses)
            cells = [f"{100 * sum(losses) / n:.2f}"]
            cells += [share(sum(x <= limit for x in losses), n) for limit in (0.015, 0.1)]
            title = name.removeprefix("ending-").replace("-", " ")
            rows.append([title, str(n), *cells, f"{100 * max(losses):.1f}"])
    return rows


def luck_saved(found: Experiments) -> list[list[str]]:
    """Matches whose points are corrected for luck."""
    head = ["Match", "game", "pairs", "points, %", "corrected, %", "weight"]
    rows = [[*head, "variance saved"]]
    for name, match in found.items():
        if name.startswith("luck-") and "adjusted" in match:
            adjusted = match["adjusted"]
            one, other = match["players"]
            cells = [f"{one} against {other}", match["game"], str(adjusted["pairs"])]
            cells += [points(match), points(adjusted), f"{adjusted['weight']:.2f}"]
            rows.append([*cells, f"× {adjusted['saved']:.1f}"])
    return rows


def luck_identical(found: Experiments) -> list[list[str]]:
    """Frames of identical players, raw and corrected for luck by two values of positions."""

    def cell(mean: float, error: float) -> list[str]:
        off = f"{(mean - 0.5) / error:+.1f}"
        return [f"{100 * mean:.2f} ± {100 * error:.2f}", off.replace("-", "−")]

    rows = [["Share of the points", "%, with its standard error", "σ from 50 %"]]
    if frames := found.get("luck-identical"):
        rows.append(["raw", *cell(**frames["raw"])])
        for value, title in (("logistic", "the built-in value"), ("noise", "a meaningless value")):
            adjusted = frames[value]
            weighted = cell(adjusted["share"], adjusted["error"])
            rows.append([f"corrected by {title}, weight {adjusted['weight']:.2f}", *weighted])
            rows.append([f"corrected by {title}, weight 1", *cell(**adjusted["plain"])])
    return rows


def made(found: Experiments) -> list[list[str]]:
    """Which commit made which result."""
    rows = [["Experiment", "commit"]]
    rows += [[f"`{name}`", result["commit"]] for name, result in found.items()]
    return rows


def values(games: Experiments) -> list[list[str]]:
    """Log loss of the values of positions, on racks that were not fitted."""
    rows = [["Game", "racks", "positions", "logistic", "Markov chain", "a constant"]]
    for name, game in games.items():
        loss = game["log_loss"]
        losses = [f"{loss[kind]:.3f}" for kind in ("logistic", "markov", "constant")]
        rows.append([name, f"{game['pairs']:,}", f"{game['positions']:,}", *losses])
    return rows


def calibration(games: Experiments) -> list[list[str]]:
    """Stated chances of winning beside what was won, for each tenth of the stated ones."""
    rows = [["Game", "value", *(f"{k / 10:.1f} to {(k + 1) / 10:.1f}" for k in range(10))]]
    for name, game in games.items():
        for kind, key in (("logistic", "calibration"), ("Markov", "calibration_of_markov")):
            cells = [""] * 10
            for tenth in game[key]:
                place = min(int(10 * tenth["stated"]), 9)
                cells[place] = f"{tenth['won']:.2f} ({tenth['positions']:.0f})"
            rows.append([name, kind, *cells])
    return rows


#: The tables of benches/results/values.json.
VALUE_TABLES = {"values": values, "calibration": calibration}
#: The tables of benches/results/strategy.json.
TABLES = {
    "levels": levels,
    "runs": runs,
    "run-outs": run_outs,
    "high-runs": high_runs,
    "breaker": breaker,
    "own-break": own_break,
    "stated": stated,
    "matrix": matrix,
    "strength": strength,
    "parts": parts,
    "search": search,
    "bars": bars,
    "published": published,
    "deep-green": deep_green,
    "endings": endings,
    "luck-saved": luck_saved,
    "luck-identical": luck_identical,
    "strategy-commits": made,
}
