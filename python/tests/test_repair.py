"""Layouts that overlap by little: rounded by other programs, or measured by a camera."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import TYPE_CHECKING

import carom
import numpy as np
import pytest
from carom import Layout, convert

if TYPE_CHECKING:
    from conftest import CommandLine

RADIUS = 0.028575
DATA = Path(__file__).parent / "data"


def places(layout: Layout) -> np.ndarray:
    return np.array([ball["position"][:2] for ball in layout.balls])


def gaps(layout: Layout) -> np.ndarray:
    at = places(layout)
    between = np.linalg.norm(at[:, None] - at[None], axis=2) - 2 * RADIUS
    return between[np.triu_indices(len(at), 1)]


def playable(layout: Layout) -> bool:
    return bool(carom.Shot("wpa-9ft", layout, carom.Strike(1.0, 0.3)))


def test_two_measured_balls_that_overlap_part_by_half_each() -> None:
    measured = Layout.at({"cue": (0.6, 0.6), "1": (0.6 + 2 * RADIUS - 3e-4, 0.6)})
    with pytest.raises(carom.InputError, match="overlaps"):
        playable(measured)
    layout, moved = measured.repaired(1e-3)
    assert playable(layout)
    assert [ball.ball for ball in moved] == ["cue", "1"]
    assert moved[0].by == pytest.approx((-1.5e-4, 0.0), abs=1e-12)
    assert moved[1].by == pytest.approx((1.5e-4, 0.0), abs=1e-12)


def test_a_layout_without_overlaps_keeps_its_bits() -> None:
    rack = Layout.rack("nine-ball", seed=3)
    layout, moved = rack.repaired()
    assert moved == []
    assert (places(layout) == places(rack)).all()


def test_an_overlap_beyond_the_tolerance_names_the_pair() -> None:
    measured = Layout.at({"cue": (0.6, 0.6), "1": (0.9, 1.2), "2": (0.9, 1.2 + 2 * RADIUS - 2e-3)})
    with pytest.raises(
        carom.InputError,
        match=r'balls\[2\].position: ball "2" overlaps balls\[1\] \("1"\) by 2.000e-3 m, more than',
    ):
        measured.repaired(1e-3)


def test_a_ball_a_little_in_the_rail_moves_out_of_it() -> None:
    measured = Layout.at({"cue": (0.02, 0.6), "1": (0.6, 2.0)})
    layout, moved = measured.repaired(0.01)
    assert [ball.ball for ball in moved] == ["cue"]
    assert moved[0].by[0] > 0.005
    assert moved[0].by[1] == 0.0
    assert playable(layout)
    with pytest.raises(carom.InputError, match=r"cue.*overlaps the nose of the left-lower cushion"):
        measured.repaired(1e-3)


def test_a_measured_rack_parts_symmetrically_and_makes_no_new_overlap() -> None:
    rows = [(i, j) for i in range(5) for j in range(i + 1)]
    # Every distance a fiftieth of a millimetre too short.
    step = 2 * RADIUS - 2e-5
    at = {
        f"{n}": (0.635 + (j - i / 2) * step, 1.9 + i * step * math.sqrt(0.75))
        for n, (i, j) in enumerate(rows)
    }
    layout, moved = Layout.at({**at, "cue": (0.635, 0.6)}).repaired(1e-3)
    assert playable(layout)
    assert gaps(layout).min() > -1e-9
    found = places(layout)[:15]
    mirror = [rows.index((i, i - j)) for i, j in rows]
    assert np.abs(found[:, 0] - 0.635 + (found[mirror, 0] - 0.635)).max() < 1e-11
    assert np.abs(found[:, 1] - found[mirror, 1]).max() < 1e-11
    # It grows about its middle, so that the sum of the displacements is 0.
    assert np.abs(np.sum([ball.by for ball in moved], axis=0)).max() < 1e-11


def test_random_measurements_of_racks_are_repaired() -> None:
    random = np.random.default_rng(5)
    for seed in range(10):
        rack = Layout.rack("eight-ball", seed=seed, gap=0.0)
        noisy = places(rack) + random.normal(scale=2e-4, size=(16, 2))
        ids = [ball["id"] for ball in rack.balls]
        measured = Layout.at(dict(zip(ids, noisy.tolist(), strict=True)))
        layout, _ = measured.repaired(2e-3)
        assert playable(layout)
        assert gaps(layout).min() > -1e-9
        # The same again, in another order.
        order = random.permutation(16)
        again, _ = Layout([measured.balls[k] for k in order]).repaired(2e-3)
        assert np.abs(places(again) - places(layout)[order]).max() < 1e-9


def test_balls_that_have_no_room_are_named() -> None:
    # Two balls across a table that is narrower than both.
    table = carom.Table.rectangle(length=2.0, width=4 * RADIUS - 1e-3, cushion_height=RADIUS)
    balls = {"cue": (RADIUS, 1.0), "1": (3 * RADIUS - 1e-3, 1.0)}
    with pytest.raises(carom.InputError, match=r"overlaps .* and has no room to move away"):
        Layout.at(balls).repaired(5e-3, table=table)
    with pytest.raises(carom.InputError, match=r"tolerance: 0.5 is out of range"):
        Layout.at(balls).repaired(0.5, table=table)


def test_a_fastfiz_state_is_imported_although_balls_overlap_by_rounding() -> None:
    # Two balls of a state that FastFiz plays; they overlap by 2.2e-8 m.
    made = convert.fastfiz(
        "2 0.028575 1 0 0.60431381110930182388 0.59085294022396528391 "
        "0.028574999999999999706 1 1 0.55622573687054666092 0.55997160185468064508"
    )
    (sentence,) = [s for s in made.left_out if "moved apart" in s]
    assert "cue (" in sentence
    assert "1 (" in sentence
    ends = np.array([b["position"][:2] for b in made.shot.to_dict()["balls"][:2]])
    assert np.linalg.norm(ends[0] - ends[1]) >= 2 * RADIUS - 1e-9


def test_a_fastfiz_ball_two_nanometres_in_the_rail_is_imported() -> None:
    made = convert.fastfiz("2 0.028575 1 0 0.0285749975 0.60 0.028575 1 8 0.80 1.70")
    assert any("cue (+" in sentence for sentence in made.left_out)


@pytest.mark.parametrize("overlap", [1e-8, 1.4e-5])
def test_pooltool_balls_that_overlap_by_rounding_are_imported(overlap: float) -> None:
    system = json.loads((DATA / "pooltool" / "pot.json").read_text())
    balls = system["balls"]
    (cue, other) = list(balls)[:2]
    radius = balls[cue]["params"]["R"]
    at = balls[cue]["state"]["rvw"][0]
    balls[other]["state"]["rvw"][0] = [at[0] + 2 * radius - overlap, at[1], at[2]]
    made = convert.pooltool(system)
    assert any("moved apart" in sentence for sentence in made.left_out)
    with pytest.raises(carom.InputError, match=r"overlaps .* more than the tolerance"):
        convert.pooltool(system, tolerance=1e-9)


LOG = """GTYPE 1
COMMENT two shots
TSTATE 2 0.028575 1 0 0.40 0.60 0.028575 1 8 0.80 1.70
TSHOT 0 3.5 5 68.2 2.5
STATE 1 0 0 0 1 2 0.028575 1 0 0.50 0.60 0.028575 1 8 0.80 1.70 1 0
SHOT 0 0 10 70 3 0 0 10 70.1 3 8 3 0 0 0 0.5 4.2 0 "a" "b"
TSTATE 1 0.028575 1 0 0.40 0.60
"""


def test_a_log_of_fastfiz_is_a_list_of_states_with_their_shots() -> None:
    first, second, third = (convert.fastfiz(LOG, index=k) for k in range(3))
    assert (
        first.shot
        == convert.fastfiz(
            "2 0.028575 1 0 0.40 0.60 0.028575 1 8 0.80 1.70", (0, 3.5, 5, 68.2, 2.5)
        ).shot
    )
    assert second.shot.to_dict()["strike"]["azimuth_deg"] == pytest.approx(70)
    assert any("executed one" in sentence for sentence in second.left_out)
    assert "strike" not in third.shot.to_dict()
    assert any("3 states; this is number 0" in sentence for sentence in first.left_out)
    with pytest.raises(carom.InputError, match="index: 3 is out of range; the log has 3 states"):
        convert.fastfiz(LOG, index=3)
    with pytest.raises(carom.InputError, match=r"line 2: .*begins with one of .* 'NONSENSE'"):
        convert.fastfiz("TSTATE 1 0.028575 1 0 0.4 0.6\nNONSENSE 1")


def test_the_command_reads_a_log_and_never_names_the_wrong_program(
    run: CommandLine, tmp_path: Path
) -> None:
    log = tmp_path / "game.log"
    log.write_text(LOG)
    done = run("import", str(log), "--index", "1")
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["strike"]["speed"] == 3
    link = tmp_path / "link.txt"
    link.write_text("https://billiards.tailuge.workers.dev/?ruletype=threecushion")
    done = run("import", str(link))
    assert done.returncode == 2
    assert "not one that carom imports" in done.stderr
    assert "MessagePack" not in done.stderr
