"""The bridge for FastFiz's clients, with a client that makes their calls."""

from __future__ import annotations

import math
import socket
import threading
import xmlrpc.client
from pathlib import Path
from typing import Any

import carom
import pytest
from carom.arena import Bridge
from carom.convert._fastfiz_game import GameShot, answer_of, game_state, noise_text

# FastFiz's spots, from the test state of its server, m.
HEAD_SPOT, FOOT_SPOT = (0.558, 1.677), (0.558, 0.559)
NORMAL, IN_HAND, BEHIND_LINE, BREAK, FOUL_ON_BREAK, EIGHT_ON_BREAK = 0, 1, 2, 4, 6, 7
CONCEDE = 4


class State:
    """A state as ``GameState::Factory`` and ``TableState::fromString`` read it."""

    def __init__(self, text: str) -> None:
        words = text.split()
        self.game, self.turn = int(words[0]), int(words[1])
        self.left, self.other_left = float(words[2]), float(words[3])
        self.started, count = int(words[4]), int(words[5])
        self.balls: dict[int, tuple[float, float]] = {}
        for k in range(count):
            radius, state, ball, x, y = words[6 + 5 * k : 11 + 5 * k]
            assert radius == "0.028575"
            if int(state) == 1:
                self.balls[int(ball)] = (float(x), float(y))
        self.is_open, self.solids = (bool(int(word)) for word in words[6 + 5 * count :])


class Client(threading.Thread):
    """What FastFiz's client does in the mode "loop", with the simplest player."""

    def __init__(self, url: str, shots: int) -> None:
        super().__init__(daemon=True)
        self.server = xmlrpc.client.ServerProxy(url)
        self.states: list[State] = []
        self.noises: set[str] = set()
        self.refused = 0
        self.shots = shots
        self.failure: BaseException | None = None

    def run(self) -> None:
        try:
            self.play()
        except Exception as error:  # noqa: BLE001 -- the test shows it
            self.failure = error

    def play(self) -> None:
        agent = self.server.register_agent("Classic", "client.conf", "password", "0")
        while (found := self.server.get_shot(agent, "password"))["shot_available"]:
            state = State(found["state_info"])
            self.states.append(state)
            self.noises.add(found["noise_info"])
            where = (found["gameid"], agent, "password", found["stateid"])
            # The first shot is impossible: the tip beside the ball.
            if not self.refused:
                assert not self.server.submit_shot(*where, *self.shot(state, a=40.0))
                self.refused += 1
            assert self.server.submit_shot(*where, *self.shot(state))

    def shot(self, state: State, a: float = 0.0) -> tuple[Any, ...]:
        """The nearest ball of one's own, straight ahead, into the pocket behind it."""
        if len(self.states) > self.shots:
            return (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 16, 6, CONCEDE, 0.0)
        cue = state.balls.get(0, (0.3, 1.9))
        if state.turn == BREAK:
            cue = (0.48, 1.67705)
        elif state.turn in (IN_HAND, BEHIND_LINE):
            cue = next(place for place in places() if is_free(place, state))
        group = range(1, 8) if state.solids else range(9, 16)
        own = [ball for ball in state.balls if ball not in (0, 8) if state.is_open or ball in group]
        aimed = min(own or [8], key=lambda ball: math.dist(cue, state.balls.get(ball, (9, 9))))
        x, y = state.balls[aimed]
        phi = math.degrees(math.atan2(y - cue[1], x - cue[0])) % 360.0
        pocket = (5 if x > cue[0] else 0) if y < cue[1] else (3 if x > cue[0] else 2)
        decision = 1 if state.turn in (FOUL_ON_BREAK, EIGHT_ON_BREAK) else 0
        return (a, 3.0, 5.0, phi, 3.5, *cue, aimed, pocket, decision, 0.25)


def places() -> list[tuple[float, float]]:
    return [(0.1 + 0.08 * i, 2.1 - 0.08 * j) for j in range(20) for i in range(12)]


def is_free(place: tuple[float, float], state: State) -> bool:
    return all(math.dist(place, at) > 0.07 for ball, at in state.balls.items() if ball != 0)


@pytest.fixture
def frame() -> carom.Frame:
    return carom.Frame("eight-ball", table="poolfiz", seed=1)


def test_a_client_that_makes_fastfiz_s_calls_plays_a_whole_match(tmp_path: Path) -> None:
    with Bridge() as bridge:
        client = Client(bridge.url, shots=30)
        client.start()
        assert bridge.wait_for_client(20.0) == "Classic"
        result = carom.play_match(
            bridge,
            "level-1",
            table="poolfiz",
            pairs=1,
            noise=carom.Noise.olympiad(),
            secret="7" * 64,
            out=tmp_path,
        )
    client.join(20.0)
    assert client.failure is None
    assert not client.is_alive()
    assert sum(result.score.reasons.values()) == 2
    assert set(result.score.reasons) <= {"won", "conceded"}
    record = result.record.read_text()
    assert record.count('"refused"') == client.refused == 1
    assert '"name": "Classic"' in record
    assert carom.replay_match(record).difference is None
    # In one of the two frames the client breaks, and its time of 600 s runs.
    turns = [state.turn for state in client.states]
    assert turns[0] == BREAK
    assert NORMAL in turns
    assert all(0.0 < state.left <= 600.0 and state.game == 1 for state in client.states)
    assert {state.started for state in client.states} == {0, 1}
    assert client.noises == {noise_text(carom.Noise.olympiad())}


def test_the_rack_stands_at_fastfiz_s_foot_spot(frame: carom.Frame) -> None:
    state = State(game_state(frame, 0, 600.0))
    assert (state.turn, state.left, state.other_left, state.started) == (BREAK, 600.0, 0.0, 1)
    assert len(state.balls) >= 15
    apex = max((at for ball, at in state.balls.items() if ball != 0), key=lambda at: at[1])
    assert math.dist(apex, FOOT_SPOT) < 0.002
    assert state.is_open
    assert min(y for _, y in state.balls.values()) > 0.35


def test_a_break_of_fastfiz_s_example_drives_at_the_rack(frame: carom.Frame) -> None:
    # Theta 25, phi 270 and v 5; FastFiz's rules allow a cue ball on the head string.
    shot = GameShot(0.0, 0.0, 25.0, 270.0, 5.0, *HEAD_SPOT, 16, 6, 0)
    play = answer_of(shot, frame.request)
    assert isinstance(play, carom.Play)
    assert play.cue_ball == pytest.approx((0.558, 0.559), abs=2e-6)
    assert play.cue_ball[1] < 0.559
    assert play.call is None
    assert math.degrees(play.strike.azimuth) == pytest.approx(90.0)
    apex = min((ball for ball in frame.balls if ball != "cue"), key=lambda b: frame.balls[b][1])
    first = frame.play(play.strike, cue_ball=play.cue_ball).trace.outcome["first_contact"]
    assert first == apex


def test_right_english_stays_right_english_after_the_half_turn(frame: carom.Frame) -> None:
    play = answer_of(GameShot(10.0, 0.0, 0.0, 270.0, 5.0, *HEAD_SPOT, 16, 6, 0), frame.request)
    assert isinstance(play, carom.Play)
    assert play.strike.side == pytest.approx(10.0 / 28.575)


@pytest.mark.parametrize(
    ("number", "pocket"),
    [(0, "top-right"), (1, "right"), (2, "bottom-right"), (3, "bottom-left"), (5, "top-left")],
)
def test_called_pockets_are_turned(frame: carom.Frame, number: int, pocket: str) -> None:
    at = carom.Shot("poolfiz", {"cue": (0.5, 1.0), "3": (0.7, 1.4), "8": (0.2, 0.3)})
    request = carom.Frame.of_shot("eight-ball", at).request
    play = answer_of(GameShot(0, 0, 0, 0, 2, 0, 0, 3, number, 0), request)
    assert isinstance(play, carom.Play)
    assert play.call == carom.Call.pocket("3", pocket)
    safety = answer_of(GameShot(0, 0, 0, 0, 2, 0, 0, 16, 6, 0), request)
    assert isinstance(safety, carom.Play)
    assert safety.call == carom.Call.safety()
    with pytest.raises(carom.InputError, match="is not a call"):
        answer_of(GameShot(0, 0, 0, 0, 2, 0, 0, 3, 6, 0), request)


def test_a_state_names_the_group_and_the_balls_that_are_down() -> None:
    balls = {"cue": (0.5, 1.0), "3": (0.7, 1.4), "8": (0.2, 0.3)}
    frame = carom.Frame.of_shot("eight-ball", carom.Shot("poolfiz", balls))
    state = State(game_state(frame, 1, None))
    assert state.turn == NORMAL
    assert state.balls == {
        0: pytest.approx((0.616, 1.236)),
        3: pytest.approx((0.416, 0.836)),
        8: pytest.approx((0.916, 1.936)),
    }
    assert (state.left, state.started) == (0.0, 0)


def test_choices_have_fastfiz_s_decisions() -> None:
    choices = ["play-on", "rebreak", "rebreak-by-other"]
    request = carom.request.ChoiceRequest(
        {"kind": "choice", "player": 1, "choices": choices, "why": "a soft break"}
    )
    answers = [answer_of(GameShot(0, 0, 0, 0, 0, 0, 0, 16, 6, k), request) for k in (1, 2, 3, 4)]
    assert answers == [*choices, "concede"]
    with pytest.raises(carom.InputError, match="none of the choices"):
        answer_of(GameShot(0, 0, 0, 0, 0, 0, 0, 16, 6, 0), request)


def test_noises_have_fastfiz_s_units() -> None:
    kind, *values = noise_text(carom.Noise.olympiad()).split()
    assert kind == "2"
    assert [float(v) for v in values] == pytest.approx([0.5, 0.5, 0.1, 0.125, 0.075])
    assert noise_text(carom.Noise()) == "1"


def test_strangers_get_no_shot_and_no_agent() -> None:
    with Bridge() as bridge:
        server = xmlrpc.client.ServerProxy(bridge.url)
        with pytest.raises(xmlrpc.client.Fault, match="call register_agent first"):
            server.get_shot(1, "")
        assert server.register_agent("one", "", "secret", "") == 1
        with pytest.raises(xmlrpc.client.Fault, match="another agent"):
            server.register_agent("two", "", "other", "")
        with pytest.raises(xmlrpc.client.Fault, match="bad password"):
            server.get_shot(1, "guess")
        with pytest.raises(xmlrpc.client.Fault, match="15 arguments"):
            server.submit_shot(1, 1, "secret", 1)
        with pytest.raises(xmlrpc.client.Fault, match="there is no request"):
            server.submit_shot(1, 1, "secret", 1, *(7 * [0.0]), 16, 6, 0, 0.0)
        bridge._said_goodbye = True


def test_a_bridge_listens_on_this_computer_alone() -> None:
    with Bridge() as bridge:
        host, port = bridge._server.server_address[:2]
        assert host == "127.0.0.1"
        with pytest.raises(carom.InputError, match="none has registered"):
            bridge.wait_for_client(0.01)
        with pytest.raises(carom.InputError, match="cannot be used"), socket.socket():
            Bridge(port)


def test_another_game_is_refused() -> None:
    with pytest.raises(carom.InputError, match="FastFiz does not have nine-ball"):
        game_state(carom.Frame("nine-ball", table="poolfiz"), 0, None)
