"""The experiments: what is played, by name."""

from __future__ import annotations

from endings import Ending
from identical import Identical
from matches import Match
from stated import Stated
from tutorial import AgainstPlanner
from visits import Visits

#: Multiples of the Olympiad's noise.
NOISES = (0.5, 1.0, 2.0)
#: Simulated shots that take about one second of one core.
SECOND = 50_000
#: The players of the win matrix, weakest first, and the simulated shots of each decision.
MATRIX = (
    "greedy",
    "deep-green-0",
    "deep-green-1",
    "deep-green-2",
    "pool-master",
    "pick-pocket",
    "cue-card",
    "carom",
)
MATRIX_SIMULATIONS = 3000

EXPERIMENTS: dict[str, Match | Visits | Ending | Stated | AgainstPlanner | Identical] = {}

# How often does the player who breaks run out?
for game in ("eight-ball", "nine-ball"):
    for noise in NOISES:
        EXPERIMENTS[f"run-{game}-x{noise:g}"] = Visits(
            f"carom:{SECOND}", count=60, game=game, noise=noise
        )

# Run-outs of eight-ball from ball in hand.
for balls in (1, 2, 3, 5, 7):
    for noise in NOISES:
        EXPERIMENTS[f"run-out-{balls}-x{noise:g}"] = Visits(
            "carom:5000", count=200, balls=balls, noise=noise
        )

# Endings beside a search of nearly all plays.
for ending in ("lone-nine", "last-ball-and-eight", "three-balls"):
    EXPERIMENTS[f"ending-{ending}"] = Ending(ending, count=40, simulations=20_000)

# Stated chances beside what happens with other errors.
for noise in NOISES:
    EXPERIMENTS[f"stated-x{noise:g}"] = Stated("carom:5000", decisions=2000, noise=noise)

# High runs of straight pool.
for noise in NOISES:
    EXPERIMENTS[f"high-run-x{noise:g}"] = Visits(
        "carom:5000", count=60, game="straight-pool", noise=noise, points=150
    )

# Wins off the break, between equal players.
for game in ("eight-ball", "nine-ball"):
    for noise in NOISES:
        EXPERIMENTS[f"breaker-{game}-x{noise:g}"] = Match(
            "carom:3000", "carom:3000", pairs=150, game=game, noise=noise, breaker=0
        )

# What the own break is worth: equal players, one of which breaks full from the middle at 8 m/s.
for game in ("eight-ball", "nine-ball"):
    EXPERIMENTS[f"own-break-{game}-10000"] = Match(
        "carom:10000", "carom[break=center]:10000", pairs=300, game=game
    )

# Everybody against everybody.
for k, other in enumerate(MATRIX):
    for one in MATRIX[:k]:
        EXPERIMENTS[f"matrix-{one}-{other}"] = Match(
            f"{one}:{MATRIX_SIMULATIONS}", f"{other}:{MATRIX_SIMULATIONS}", pairs=60
        )

# Strength against simulated shots, each number against a tenth of it.
for power in (3, 4, 5, 6):
    EXPERIMENTS[f"strength-1e{power}"] = Match(
        f"carom:{10**power}", f"carom:{10 ** (power - 1)}", pairs=(120, 100, 60, 12)[power - 3]
    )

# What each part of the search is worth: the player without it against the player with it.
PARTS = {
    "replies": "replying=0.3",
    "shift": "shift=false",
    "refining": "refining=0",
    "safeties": "safeties=0",
    "common-errors": "common-errors=false",
    "logistic-value": "value=markov",
}
for part, setting in PARTS.items():
    EXPERIMENTS[f"part-{part}"] = Match(f"carom[{setting}]:10000", "carom:10000", pairs=120)

# The search with replies against the default one, at about 0.1 s and 1 s of one core a decision.
for simulations, pairs in ((5000, 120), (SECOND, 60)):
    EXPERIMENTS[f"search-replies-{simulations}"] = Match(
        f"carom[replying=0.3]:{simulations}",
        f"carom:{simulations}",
        pairs=pairs,
        test=(0.45, 0.55),
    )

# The levels of strength, each against the one below.
for number in (2, 3, 4, 5):
    EXPERIMENTS[f"level-{number}-level-{number - 1}"] = Match(
        f"level-{number}", f"level-{number - 1}", pairs=300, noise=None
    )

# The bars against the re-creations, on the table of the Olympiad.
CUE_CARD = 200_000
EXPERIMENTS["cue-card-same-break"] = Match(
    "carom",
    "cue-card",
    pairs=200,
    table="poolfiz",
    frame_simulations=(CUE_CARD // 10, CUE_CARD),
    same_break="head",
)
# Six seconds of one core: 300 000 simulated shots of 20 µs.
for other, pairs in (("cue-card", 200), ("pick-pocket", 100)):
    EXPERIMENTS[f"{other}-6-s-same-break"] = Match(
        "carom",
        other,
        pairs=pairs,
        table="poolfiz",
        frame_simulations=(300_000, CUE_CARD),
        same_break="head",
    )
EXPERIMENTS["cue-card-6-s-own-breaks"] = Match(
    "carom", "cue-card", pairs=200, table="poolfiz", frame_simulations=(300_000, CUE_CARD)
)

# CueCard against PickPocket, as published.
EXPERIMENTS["literature-cue-card-pick-pocket-own-breaks"] = Match(
    "cue-card", "pick-pocket", pairs=150, table="poolfiz", frame_simulations=(CUE_CARD, CUE_CARD)
)
EXPERIMENTS["literature-cue-card-pick-pocket-same-break"] = Match(
    "cue-card",
    "pick-pocket",
    pairs=150,
    table="poolfiz",
    frame_simulations=(CUE_CARD, CUE_CARD),
    same_break="head",
)
# CueCard without level two, and with its simulations moved to level one. 5000 frames take hours:
# they are stored in tenths, whose sum is the result.
for change in ("off", "given-to-level-one"):
    for tenth in range(1, 11):
        EXPERIMENTS[f"literature-level-two-{change}-{tenth:02}"] = Match(
            f"cue-card[level-two={change}]:10000", "cue-card:10000", pairs=250, table="poolfiz"
        )
# Samples of a shot at level one.
for samples in (10, 20, 60, 120, 300):
    EXPERIMENTS[f"literature-samples-{samples}"] = Match(
        f"cue-card[samples={samples},level-two=off]:10000",
        "cue-card[samples=30,level-two=off]:10000",
        pairs=300,
        table="poolfiz",
    )
# The same with a tenth of the simulations for PickPocket, whose effort the papers do not tell.
EXPERIMENTS["literature-cue-card-pick-pocket-tenth"] = Match(
    "cue-card",
    "pick-pocket",
    pairs=150,
    table="poolfiz",
    frame_simulations=(CUE_CARD, CUE_CARD // 10),
    same_break="head",
)
# Deep Green: every player against every other, at four noises.
DEEP_GREEN = ("greedy", "deep-green-1", "deep-green-2")
for noise in (0.0, 0.5, 1.0, 2.0):
    for one, other in ((0, 1), (1, 2), (0, 2)):
        first, second = DEEP_GREEN[one], DEEP_GREEN[other]
        EXPERIMENTS[f"literature-{first}-{second}-x{noise:g}"] = Match(
            f"{first}:3000", f"{second}:3000", pairs=500, noise=noise, table="poolfiz"
        )
# The searching player against others, with the same break.
for other in ("pick-pocket", "greedy"):
    EXPERIMENTS[f"bar-carom-{other}"] = Match(
        "carom:3000", f"{other}:3000", pairs=500, table="poolfiz", same_break="head"
    )
# How much PickPocket leaves to a player who makes no errors, with the same break.
EXPERIMENTS["bound-carom-pick-pocket"] = Match(
    "carom:3000",
    "pick-pocket:3000",
    pairs=500,
    noise=(0.0, 1.0),
    table="poolfiz",
    same_break="head",
)
# Five milliseconds of one core a decision: with a budget of 340 it simulates 300 shots of 16 µs.
EXPERIMENTS["bar-5-ms-greedy"] = Match(
    "carom:340", "greedy[aim=simulated]:3000", pairs=300, same_break="head"
)
# The planner of the tutorial "Two robots at eight-ball", with its break.
for noise in (0.5, 1.0):
    EXPERIMENTS[f"bar-tutorial-x{noise:g}"] = AgainstPlanner("carom:3000", pairs=100, noise=noise)

# The correction for luck: identical players are even, whatever the value of positions.
EXPERIMENTS["luck-identical"] = Identical("greedy", frames=20_000, game="nine-ball", draws=4)
# How much it saves, by game.
for game in ("eight-ball", "nine-ball"):
    EXPERIMENTS[f"luck-{game}"] = Match("carom:300", "carom:100", pairs=60, game=game, luck=True)
