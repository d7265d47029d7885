"""A player that is a client of FastFiz's tournament server, over XML-RPC on this computer.

The server of the Computational Olympiad had three methods, and its clients ask again and again for
a shot that they have to play. Their calls are those of FastFiz 0.2 (docs/classic-programs.md).
"""

from __future__ import annotations

import itertools
import threading
import time
from socketserver import ThreadingMixIn
from types import TracebackType
from typing import Any, Self, TypeAlias
from xmlrpc.client import Fault
from xmlrpc.server import SimpleXMLRPCRequestHandler, SimpleXMLRPCServer

from carom.arguments import whole
from carom.convert._fastfiz_game import GameShot, answer_of, game_state, noise_text
from carom.errors import InputError
from carom.player import Play, Situation
from carom.serve import HOST

#: The usual port; it has no other common use.
PORT = 8738

# Seconds for which `get_shot` waits for the player's turn before it answers that there is none. A
# client in the mode "loop" ends after such an answer, and one in the mode "wait" sleeps for 5 s.
_TURN = 20.0
# Seconds after which a wait looks for the end of the match and for Ctrl-C.
_LOOK = 0.2
# Seconds for which the end of the match waits until `get_shot` has answered that there is no shot.
_GOODBYE = 2.0
# The number of the agent: a bridge has one.
_AGENT = 1
# What a player of a match may return: an error is a refused answer.
_Answer: TypeAlias = Play | str | InputError
# Largest body of a call, bytes. A shot has 1500.
_LARGEST = 1 << 20


class Bridge:
    """A player of a match that is a FastFiz client, connected over XML-RPC.

    It is a player wherever a match takes an object, in eight-ball on the table ``poolfiz``::

        with carom.arena.Bridge() as bridge:
            bridge.wait_for_client()
            carom.play_match(bridge, "level-3", table="poolfiz", out="classic")

    It listens on 127.0.0.1 alone, and has one client, which names itself and its password with
    ``register_agent``. The match's clock runs while the client thinks.

    Args:
        port: The port; 0 chooses a free one.

    Attributes:
        name: The name under which the client has registered; ``fastfiz`` before.

    Raises:
        InputError: The port cannot be used.
    """

    def __init__(self, port: int = 0) -> None:
        self.name = "fastfiz"
        self._agent: tuple[str, str] | None = None
        self._changed = threading.Condition()
        self._asked: dict[int, _Asked] = {}
        self._games, self._states = itertools.count(1), itertools.count(1)
        self._closed = self._said_goodbye = False
        self._server = _server(whole("port", port, 1 << 16))
        methods: list[Any] = [self.register_agent, self.get_shot, self.submit_shot]
        for method in methods:
            self._server.register_function(method)
        self._thread = threading.Thread(target=self._server.serve_forever, args=(_LOOK,))
        self._thread.start()

    @property
    def url(self) -> str:
        """The endpoint for the client."""
        return f"http://{HOST}:{self._server.server_address[1]}/RPC2"

    def wait_for_client(self, seconds: float | None = None) -> str:
        """Wait until a client has registered, and return its name.

        Args:
            seconds: The longest wait, s; None is without end.

        Raises:
            InputError: No client has registered in this time.
        """
        end = None if seconds is None else time.monotonic() + seconds
        with self._changed:
            while self._agent is None:
                if end is not None and time.monotonic() >= end:
                    raise InputError(
                        "missing",
                        "client",
                        f"none has registered in {seconds:g} s",
                        f"start it with the endpoint {self.url}",
                    )
                self._changed.wait(_LOOK)
        return self.name

    def close(self) -> None:
        """Tell the client that there is no shot, and end the server."""
        end = time.monotonic() + _GOODBYE
        with self._changed:
            self._closed = True
            self._changed.notify_all()
            while self._agent and not self._said_goodbye and time.monotonic() < end:
                self._changed.wait(_LOOK)
        self._server.shutdown()
        self._thread.join()
        self._server.server_close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        where: TracebackType | None,
    ) -> None:
        self.close()

    def __deepcopy__(self, _: dict[int, Any]) -> _BridgeGame:
        """The player of one frame; FastFiz gives every game a number."""
        return _BridgeGame(self, next(self._games))

    def choose(self, situation: Situation) -> _Answer:
        """Ask the client, as a game of its own."""
        return self.__deepcopy__({}).choose(situation)

    # What the client calls. The names and the order of the arguments are FastFiz's.

    def register_agent(self, name: str, config: str, password: str, owner: str) -> int:
        """Register the client, and return the number of the agent."""
        del config, owner
        with self._changed:
            if self._agent is None:
                self._agent = (str(name), str(password))
                # The longest name that a record has.
                self.name = "".join(c for c in str(name) if c.isprintable())[:80] or self.name
                self._changed.notify_all()
            elif self._agent != (name, password):
                raise Fault(1, "another agent is registered; start a bridge for each client")
        return _AGENT

    def get_shot(self, agentid: int, password: str) -> dict[str, Any]:
        """The state for which the client has to find a shot, if it is its turn."""
        self._check(agentid, password)
        end = time.monotonic() + _TURN
        with self._changed:
            while not self._closed and time.monotonic() < end:
                if asked := self._next():
                    asked.is_sent = True
                    return {"shot_available": True, **asked.message()}
                self._changed.wait(_LOOK)
            self._said_goodbye = self._closed
            self._changed.notify_all()
        return {"shot_available": False}

    def submit_shot(
        self,
        gameid: int,
        agentid: int,
        password: str,
        stateid: int,
        *shot: Any,
    ) -> bool:
        """Play a shot. False if the rules or the table refuse it: the client finds another one."""
        self._check(agentid, password)
        if len(shot) != len(GameShot._fields) + 1:
            raise Fault(1, "submit_shot has 15 arguments: iisidddddddiiid")
        # The last argument is the time that the client has measured; the match's clock counts.
        a, b, theta, phi, v, x, y = map(float, shot[:7])
        given = GameShot(a, b, theta, phi, v, x, y, *map(int, shot[7:-1]))
        end = time.monotonic() + _TURN
        with self._changed:
            # The match requests a refused shot again after a moment.
            while not self._closed and time.monotonic() < end:
                asked = self._asked.get(stateid)
                if asked and asked.game == gameid and asked.shot is None:
                    asked.shot = given
                    self._changed.notify_all()
                    while asked.is_accepted is None and not self._closed:
                        self._changed.wait(_LOOK)
                    return bool(asked.is_accepted)
                if asked is None and stateid != self._refused:
                    break
                self._changed.wait(_LOOK)
        raise Fault(1, f"there is no request in state {stateid} of game {gameid}")

    _refused: int | None = None

    def _check(self, agentid: int, password: str) -> None:
        if self._agent is None or agentid != _AGENT or password != self._agent[1]:
            raise Fault(1, "unknown agent or bad password; call register_agent first")

    def _next(self) -> _Asked | None:
        """What no client has, or else what a client may have lost."""
        waiting = [asked for asked in self._asked.values() if asked.shot is None]
        return min(waiting, key=lambda asked: asked.is_sent, default=None)

    def _answer(self, game: int, situation: Situation, state: int | None) -> tuple[_Answer, int]:
        """Ask the client; its answer, and the number of the state."""
        state = next(self._states) if situation.refused is None or state is None else state
        written = game_state(situation.frame, situation.player, situation.clock)
        asked = _Asked(game, state, written, noise_text(situation.noise))
        with self._changed:
            self._asked[state] = asked
            self._changed.notify_all()
            try:
                while asked.shot is None:
                    self._changed.wait(_LOOK)
                answer, accepted = _checked(asked.shot, situation)
                self._refused = None if accepted else state
                asked.is_accepted = accepted
            finally:
                del self._asked[state]
                self._changed.notify_all()
        return answer, state


class _BridgeGame:
    """The player of one frame."""

    def __init__(self, bridge: Bridge, game: int) -> None:
        self.name = bridge.name
        self._bridge, self._game = bridge, game
        self._state: int | None = None

    def choose(self, situation: Situation) -> _Answer:
        """The client's answer."""
        answer, self._state = self._bridge._answer(self._game, situation, self._state)
        return answer


class _Asked:
    """A request that waits for a client."""

    def __init__(self, game: int, state: int, written: str, noise: str) -> None:
        self.game, self.state, self.written, self.noise = game, state, written, noise
        self.is_sent = False
        self.shot: GameShot | None = None
        self.is_accepted: bool | None = None

    def message(self) -> dict[str, Any]:
        return {
            "gameid": self.game,
            "stateid": self.state,
            "state_info": self.written,
            "noise_info": self.noise,
        }


def _checked(shot: GameShot, situation: Situation) -> tuple[_Answer, bool]:
    """The answer, and whether the match will accept it. The match counts what it refuses."""
    frame = situation.frame
    try:
        answer = answer_of(shot, frame.request)
        if isinstance(answer, Play):
            frame.shot(answer.strike, cue_ball=answer.cue_ball, call=answer.call)
    except InputError as error:
        return error, False
    return answer, True


class _Handler(SimpleXMLRPCRequestHandler):
    # FastFiz's clients call whatever path their configuration has.
    rpc_paths = ()
    # Seconds for which a connection may send nothing.
    timeout = 30

    def do_POST(self) -> None:
        length = self.headers.get("Content-Length", "")
        if not length.isdecimal() or int(length) > _LARGEST:
            self.send_error(413, f"a call has at most {_LARGEST} bytes")
            return
        super().do_POST()


class _Server(ThreadingMixIn, SimpleXMLRPCServer):
    daemon_threads = True
    # A client that was started again finds the same port.
    allow_reuse_address = True


def _server(port: int) -> _Server:
    try:
        return _Server((HOST, port), _Handler, logRequests=False)
    except OSError as error:
        raise InputError(
            "system",
            "port",
            f"{port} cannot be used ({error.strerror})",
            "choose another, or 0 for a free one",
        ) from None
