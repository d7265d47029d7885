"""Players of a match: names of built-in ones, and players of one's own."""

from __future__ import annotations

import copy
import signal
import sys
import threading
import traceback
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from types import FrameType
from typing import Any

from carom import _core
from carom.arguments import number, text, whole
from carom.errors import InputError
from carom.noise import Noise, Perception
from carom.player import Decision, Player, Situation
from carom.player.situation import answer_arguments, chosen
from carom.rules import Frame

# Begins the note of an exception that a player raised.
_RAISED = "A player raised it: "
# Longest name of a player, as the arena checks it.
_LONGEST_NAME = 80
# Longest message of an exception in a record, characters; the log has it all.
_LONGEST_MESSAGE = 300


@dataclass(frozen=True, slots=True)
class Contestant:
    """A player of a match.

    Attributes:
        name: Its name in tables and records; for a built-in player the name that makes it.
        noise: Its usual errors; None for the usual ones of a match.
        simulations: Simulated shots of a decision that the name of a built-in player gives.
        make: Makes a player of one's own, for every frame; None for a built-in player.
        kind: The class of a player of one's own, for the record.
        program: The name that starts an external program.
        folder: The folder to which the files of that program are relative.
    """

    name: str
    noise: Noise | None = None
    simulations: int | None = None
    make: Callable[[], Any] | None = None
    kind: str = ""
    program: str | None = None
    folder: Path = Path()

    @property
    def entry(self) -> dict[str, Any] | None:
        """The player as the header of a record has it; None for a player of one's own."""
        name = self.program or self.name
        return None if self.make else _core.player_entry(name, self.folder)

    def program_arguments(
        self, log: Callable[[str], object] | None, hidden: Sequence[Path], strict: bool
    ) -> tuple[Any, ...]:
        """An external program in the form that Rust reads.

        Args:
            log: Gets what it writes to stderr.
            hidden: Files that it must not read.
            strict: Whether everything must be enforced.
        """
        python, library = sys.executable, _core.__file__
        return self.program, self.folder, python, library, log, list(hidden), strict


def contestant(argument: str, value: Any) -> Contestant:
    """The player that was passed as an argument.

    Args:
        argument: The name of the argument, for the error message.
        value: A contestant; a name; an object with ``choose(situation)``, of which every frame
            gets a copy; or a class or function without arguments that makes one, and is called
            for every frame.

    Raises:
        InputError: It is none of these, or the object cannot be copied.
    """
    if isinstance(value, Contestant):
        return value
    if isinstance(value, str):
        return program(argument, value) if is_program(value) else _built_in(argument, value)
    if isinstance(value, type):
        _check_method(argument, value)
        return Contestant(_name(argument, value, value), make=value, kind=value.__name__)
    if callable(getattr(value, "choose", None)):
        _check_copy(argument, value)
        noise = value.noise if isinstance(value, Player) else None
        return Contestant(
            _name(argument, value, type(value)),
            noise=noise,
            make=partial(copy.deepcopy, value),
            kind=type(value).__name__,
        )
    if callable(value):
        made = value()
        _check_method(argument, made)
        return Contestant(_name(argument, made, type(made)), make=value, kind=type(made).__name__)
    raise InputError(
        "wrong-type",
        argument,
        f"found a {type(value).__name__}",
        'give the name of a player, such as "level-3", or an object with a method '
        "choose(situation)",
    )


def is_program(name: str) -> bool:
    """Whether a player's name is that of an external program."""
    return name.startswith(("exec:", "exec["))


def program(argument: str, value: str, folder: Path = Path()) -> Contestant:
    """An external program.

    Args:
        argument: The name of the argument, for the error message.
        value: The program, ``exec:COMMAND``.
        folder: The folder to which the files among its words are relative.

    Raises:
        InputError: It cannot be started.
    """
    folder = folder.absolute()
    try:
        name = _core.player_entry(value, folder)["name"]
        return Contestant(name, program=value, folder=folder)
    except InputError as error:
        raise error.at(argument + error.place.removeprefix("player")) from None


def _built_in(argument: str, value: str) -> Contestant:
    name = text(argument, value, '"carom:2000"')
    try:
        player = Player(name)
    except InputError as error:
        raise error.at(argument + error.place.removeprefix("player")) from None
    return Contestant(name, noise=player.noise, simulations=player._core.simulations)


def _check_method(argument: str, value: Any) -> None:
    if callable(getattr(value, "choose", None)):
        return
    found = f"the class {value.__name__}" if isinstance(value, type) else type(value).__name__
    raise InputError(
        "wrong-type",
        argument,
        f"{found} has no method choose",
        "write one: def choose(self, situation)",
    )


def _check_copy(argument: str, value: Any) -> None:
    try:
        copy.deepcopy(value)
    except Exception as error:
        raise InputError(
            "unsupported",
            argument,
            f"the player cannot be copied for a frame ({type(error).__name__}: {error})",
            "give its class, or a function that makes it; or write __deepcopy__, which may share "
            "what never changes",
        ) from error


def _name(argument: str, value: Any, kind: type) -> str:
    """The attribute ``name``, or else the name of the class."""
    name = getattr(value, "name", None)
    if not isinstance(name, str):
        return kind.__name__
    if not 0 < len(name) <= _LONGEST_NAME or not name.isprintable():
        raise InputError(
            "syntax",
            f"{argument}.name",
            f"{name!r} is not a name",
            f"write 1 to {_LONGEST_NAME} printable characters",
        )
    return name


def line_of(error: BaseException) -> str:
    """An exception in one line."""
    line = " ".join(f"{type(error).__name__}: {error}".split())
    return line.encode(errors="replace").decode()[:_LONGEST_MESSAGE]


def is_of_player(error: BaseException) -> bool:
    """Whether a player of a match raised this exception, which stopped the match."""
    return any(note.startswith(_RAISED) for note in getattr(error, "__notes__", ()))


@dataclass(slots=True)
class Asking:
    """Where the players of one's own in a match are asked.

    Attributes:
        log: Gets the text of an exception of a player.
        strict: Whether an exception of a player stops the match.
        busy: The threads on which a player is choosing.
        interrupted: Whether Ctrl-C has come. A player may catch its exception, and the search of a
            ``carom.Player`` ends with a decision.
        lock: Held while the log is written.
    """

    log: Callable[[str], object]
    strict: bool
    busy: set[int] = field(default_factory=set)
    interrupted: bool = False
    lock: threading.Lock = field(default_factory=threading.Lock)

    def program(self, of: Contestant, hidden: Sequence[Path]) -> tuple[Any, ...]:
        """An external program in the form that Rust reads.

        Args:
            of: The player.
            hidden: Files that it must not read.
        """
        return of.program_arguments(self._locked_log, hidden, self.strict)

    def _locked_log(self, text: str) -> None:
        with self.lock:
            self.log(text)

    def beginning(
        self,
        of: Contestant,
        noises: tuple[Noise, Noise],
        perception: Perception,
    ) -> Callable[[int, int], Callable[..., Any]]:
        """What Rust calls at the first request of a frame, with its number and the player's seat.

        It returns the function that answers the requests of the frame.

        Args:
            of: The player.
            noises: The errors that it knows of its own strikes and of the other player's.
            perception: The errors of perception that it knows.
        """

        def begin(frame: int, seat: int) -> Callable[..., Any]:
            where = f"frame {frame}, player {of.name} at seat {seat}"
            player: Any = None

            def ask(
                core: _core.Frame,
                seat: int,
                left: float,
                budget: float,
                in_seconds: bool,
                seed: int,
                refused: InputError | None,
            ) -> Any:
                nonlocal player
                thread = threading.get_ident()
                self.busy.add(thread)
                try:
                    if player is None:
                        assert of.make is not None
                        player = of.make()
                    situation = Situation(
                        Frame._seen(core),
                        *noises,
                        seat,
                        clock=left if in_seconds else None,
                        simulations=None if in_seconds else int(left),
                        budget=budget,
                        perception=perception,
                        seed=seed,
                        refused=refused,
                    )
                    answer = chosen(player, situation)
                    if self.interrupted:
                        raise KeyboardInterrupt
                    return _said(answer)
                except BaseException as error:
                    if self.strict or self.interrupted or isinstance(error, KeyboardInterrupt):
                        error.add_note(f"{_RAISED}{where}.")
                        raise
                    return self._logged(where, error)
                finally:
                    self.busy.discard(thread)

            return ask

        return begin

    def _logged(self, where: str, error: BaseException) -> str:
        """The exception in one line; its traceback is written to the log."""
        with self.lock:
            self.log(f"{where}:\n{''.join(traceback.format_exception(error))}\n")
        return line_of(error)

    @contextmanager
    def watching(self) -> Iterator[None]:
        """Meanwhile ``interrupted`` notices Ctrl-C, if this is the main thread."""
        usual = signal.getsignal(signal.SIGINT)
        if threading.current_thread() is not threading.main_thread() or not callable(usual):
            yield
            return

        def handle(number: int, where: FrameType | None) -> Any:
            try:
                return usual(number, where)
            except KeyboardInterrupt:
                self.interrupted = True
                raise

        signal.signal(signal.SIGINT, handle)
        try:
            yield
        finally:
            signal.signal(signal.SIGINT, usual)

    def interrupt(self) -> None:
        """Raise KeyboardInterrupt in the players that are choosing on other threads."""
        import ctypes

        raise_in = ctypes.pythonapi.PyThreadState_SetAsyncExc
        # A set of whole numbers is copied in one step, so no other thread changes it meanwhile.
        for thread in list(self.busy):
            raise_in(ctypes.c_ulong(thread), ctypes.py_object(KeyboardInterrupt))


def _said(answer: Any) -> tuple[Any, ...]:
    """The answer, the chance to win and the cost; or the parts of an error, which is a refusal."""
    try:
        arguments = answer_arguments(answer)
        if not isinstance(answer, Decision):
            return arguments, None, 0, 0
        chance = answer.win_chance
        return (
            arguments,
            None if chance is None else number("win_chance", chance),
            whole("simulations", answer.simulations, 1 << 63),
            whole("rounds", answer.rounds, 1 << 32),
        )
    except InputError as error:
        return error.kind, error.place or "answer", error.fault, error.remedy
    except (TypeError, UnicodeError) as error:
        # A key that no play has, or one that is not valid Unicode.
        return "wrong-type", "answer", str(error), "follow frame.answer_schema()"
