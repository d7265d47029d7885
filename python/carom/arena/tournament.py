"""Tournaments: many matches, in a folder that is continued and extended."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self

from carom.arena import tournament_file
from carom.arena.contestants import Contestant, contestant
from carom.arena.named_players import named_player
from carom.arena.tournament_folder import Block, TournamentFolder
from carom.arena.tournament_on_ray import play_on_ray
from carom.arena.tournament_result import TournamentResult
from carom.arena.tournament_run import Worker, play_here, play_in_others, process_count
from carom.arguments import cores
from carom.errors import InputError
from carom.files import checked_path, shown
from carom.lock import locked
from carom.progress import progress_bar

if TYPE_CHECKING:
    import os

#: The file of the standing table of the built-in players.
LADDER = Path(__file__).parents[1] / "data" / "ladder.toml"


class Tournament:
    """A tournament between programs, as a file of the format ``carom-tournament/1`` describes it.

    Args:
        file: The content of the file (docs/tournaments.md). A player may also be an object or a
            class of one's own, as for ``carom.play_match``.
        folder: The folder to which the names of files of players are relative.

    Raises:
        InputError: A value is missing, unknown or invalid, or there is no such player; the message
            names its place.
    """

    def __init__(self, file: Mapping[str, Any], *, folder: str | os.PathLike[str] = ".") -> None:
        self._file = tournament_file.read(file)
        self._folder = checked_path("folder", folder, ".")
        self._contestants: dict[str, Contestant] = {}
        for i, player in enumerate(self._file.players):
            place = f"players[{i}]"
            made = player.player
            if isinstance(made, str):
                made = named_player(place, made, self._folder)
            self._contestants[player.name] = contestant(place, made)

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Self:
        """The tournament of a file, TOML (``.toml``) or JSON.

        Raises:
            InputError: As for the class.
            OSError: The file cannot be read.
        """
        place = checked_path("path", path, "tournament.toml")
        found = tournament_file.load(place)
        try:
            return cls(found, folder=place.parent)
        except InputError as error:
            raise error.inside(shown(place), ": ") from None

    @property
    def players(self) -> tuple[str, ...]:
        """The names of the players."""
        return tuple(self._contestants)

    def run(
        self,
        out: str | os.PathLike[str],
        *,
        threads: int | None = None,
        processes: int | None = None,
        ray: bool | str = False,
        progress: bool = False,
    ) -> TournamentResult:
        """Play what is missing in the folder of the tournament.

        After a stop, or a kill, the same call continues. After a change of the file, such as a
        further player, it plays what the folder does not have yet. If all clocks count simulated
        shots and a secret is given, the records are the same for any number of threads.

        Args:
            out: The folder.
            threads: Number of matches that are played at once; None is one per core.
            processes: Number of processes that play pairs, in place of threads, so that players in
                Python compute on all cores; None is this process alone. The players must be
                picklable: see ``carom.play_match``. The records are the same to the bit.
            ray: True plays on Ray, started on this machine with ``threads`` cores; a text is the
                address of a Ray cluster, such as ``"auto"`` (``pip install 'carom[ray]'``).
            progress: Show a progress bar on stderr.

        Raises:
            InputError: Another program plays in the folder, it belongs to another version of carom,
                a built-in player decides otherwise than in its records, a player cannot be
                pickled for ``processes``, or a process has ended.
            OSError: A file cannot be read or written.
        """
        root, workers = checked_path("out", out, "tournament").absolute(), cores(threads)
        given = {"threads": threads is not None, "ray": ray is not False}
        if processes is not None and any(given.values()):
            other = next(name for name in given if given[name])
            raise InputError("conflict", other, "processes is given too", "give one of them")
        worker = Worker(root, self._contestants, self._file.secret)
        count = None if processes is None else process_count(worker, processes)
        root.mkdir(parents=True, exist_ok=True)
        with locked(root, "tournament"):
            folder = TournamentFolder.write(root, self._file)
            for block in _blocks(folder):
                block.tidy()
            worker.check_players(_blocks(folder))
            before = _finished_pairs(_blocks(folder))
            while True:
                folder.draw_rounds()
                missing = [block for block in _blocks(folder) if not block.finished]
                if not missing:
                    break
                total = sum(block.pairs for block in missing)
                with progress_bar(total, show=progress, what="pairs") as advance:
                    if count is not None:
                        play_in_others(worker, _in_turn(missing), count, advance)
                    elif ray is False:
                        play_here(worker, _in_turn(missing), workers, advance)
                    else:
                        play_on_ray(worker, _in_turn(missing), ray, workers, advance)
            result = TournamentResult.read(folder)
        return result.played_now(before)


def _blocks(folder: TournamentFolder) -> list[Block]:
    return [block for each in folder.encounters() for block in folder.blocks(each)]


def _in_turn(blocks: Sequence[Block]) -> list[Block]:
    """The first blocks of all encounters first, so that a table of ratings soon has everybody."""
    return sorted(blocks, key=lambda block: block.number)


def _finished_pairs(blocks: Sequence[Block]) -> int:
    return sum(len(block.frames()) // 2 for block in blocks)
