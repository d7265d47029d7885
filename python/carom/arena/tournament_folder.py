"""The folder of a tournament: its matches in blocks of pairs, and what they have come to."""

from __future__ import annotations

import hashlib
import hmac
import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from carom import __version__
from carom.arena.fresh_errors import frame_luck
from carom.arena.tournament_file import BOUNDS, Condition, Event, TournamentFile
from carom.arena.tournament_schedule import (
    Encounter,
    Round,
    encounters,
    event_path,
    swiss_round,
)
from carom.errors import InputError
from carom.files import read_text, shown, write_whole

#: The file that describes the folder.
MANIFEST = "tournament.json"
FORMAT = "carom-tournament-folder/1"
#: The record of a finished match, and that of a match that goes on.
RECORD = "match.jsonl"
PLAYED = "played.jsonl"
#: The secret of a match that goes on.
SECRET = "secret"


@dataclass(frozen=True, slots=True)
class Block:
    """Pairs of frames that are played as one match, with a folder and a secret of their own.

    Attributes:
        encounter: Who plays, and under which condition.
        number: The number of the block, from 1.
        pairs: Its number of pairs; of a test the largest number.
        folder: Its folder.
    """

    encounter: Encounter
    number: int
    pairs: int
    folder: Path

    @property
    def finished(self) -> bool:
        """Whether its record is complete."""
        return (self.folder / RECORD).exists()

    def tidy(self) -> None:
        """Remove what a program that was ended at the last moment left beside a whole record."""
        if self.finished:
            for name in (PLAYED, SECRET):
                (self.folder / name).unlink(missing_ok=True)

    @property
    def record(self) -> Path:
        """The file with its frames so far."""
        return self.folder / (RECORD if self.finished else PLAYED)

    def header(self) -> dict[str, Any] | None:
        """The first line of its record; None if nothing is written."""
        return _header(self.folder)

    def frames(self) -> list[FrameResult]:
        """The frames of all complete pairs, in order.

        Raises:
            InputError: A line of the record is damaged.
        """
        found: dict[int, FrameResult] = {}
        for line in _lines(self.record)[1:]:
            try:
                node = json.loads(line)
                if "frame" in node:
                    frame = FrameResult.of(node)
                    found[frame.number] = frame
            except (ValueError, KeyError, TypeError):
                raise InputError(
                    "format",
                    shown(self.record),
                    "a line of it is damaged",
                    "delete the folder of this block, to play it again",
                ) from None
        return [found[k] for k in sorted(found) if k ^ 1 in found]


@dataclass(frozen=True, slots=True)
class FrameResult:
    """The result of a frame.

    Attributes:
        number: Its number in the block. Frames 2k and 2k + 1 are a pair.
        breaker: The player who began it: 0 or 1.
        points: The points of player 0: 1, ½ or 0; None if the frame does not count.
        reason: Why it ended.
        luck: The luck of player 0, in points; None if it was not measured.
    """

    number: int
    breaker: int
    points: float | None
    reason: str
    luck: float | None = None

    @classmethod
    def of(cls, line: Mapping[str, Any]) -> FrameResult:
        """The result on a line of a record."""
        points = line["end"]["points"]
        return cls(
            line["frame"],
            line["seats"][0],
            None if points is None else float(points[0]),
            line["end"]["reason"],
            frame_luck(line),
        )


#: The points of a player in a pair, 0 to 2, and its luck, in points; None if it was not measured.
PairResult = tuple[float, float | None]


def pair_results(frames: Sequence[FrameResult]) -> list[PairResult]:
    """The results of player 0 in the pairs that count."""
    found: list[PairResult] = []
    for first, second in zip(frames[::2], frames[1::2], strict=True):
        if first.points is not None and second.points is not None:
            measured = first.luck is not None and second.luck is not None
            luck = (first.luck or 0.0) + (second.luck or 0.0) if measured else None
            found.append((first.points + second.points, luck))
    return found


def of_other(pair: PairResult) -> PairResult:
    """The same pair for player 1."""
    points, luck = pair
    return 2 - points, None if luck is None else -luck


def _lines(path: Path) -> list[bytes]:
    """The complete lines of a file; none if there is no file."""
    try:
        data = path.read_bytes()
    except FileNotFoundError:
        return []
    return data[: data.rfind(b"\n") + 1].splitlines()


def _header(folder: Path) -> dict[str, Any] | None:
    for name in (RECORD, PLAYED):
        path = folder / name
        if not path.exists():
            continue
        with path.open("rb") as file:
            line = file.readline()
        if line.endswith(b"\n"):
            try:
                found: dict[str, Any] = json.loads(line)
            except ValueError:
                raise InputError(
                    "format", shown(path), "its first line is damaged", "delete the folder"
                ) from None
            return found
    return None


@dataclass(frozen=True, slots=True)
class TournamentFolder:
    """The folder of a tournament.

    Attributes:
        root: The folder.
        players: The players: their names in the tournament, and how they are written.
        events: The events.
    """

    root: Path
    players: dict[str, str]
    events: tuple[Event, ...]

    @classmethod
    def read(cls, root: Path) -> TournamentFolder:
        """The tournament in a folder.

        Raises:
            InputError: The folder has no tournament.
        """
        path = root / MANIFEST
        try:
            text = read_text(path)
        except FileNotFoundError:
            raise InputError(
                "missing",
                shown(root),
                f"the folder has no tournament ({MANIFEST} is missing)",
                "give the folder of `carom arena run`",
            ) from None
        try:
            found = json.loads(text)
            events = tuple(_event(event) for event in found["events"])
            return cls(root, dict(found["players"]), events)
        except (ValueError, KeyError, TypeError):
            raise InputError(
                "format", shown(path), "it does not describe a tournament", "restore the file"
            ) from None

    @classmethod
    def write(cls, root: Path, file: TournamentFile) -> TournamentFolder:
        """Begin the folder of a tournament, or continue it with what its file has now.

        Raises:
            InputError: Another version of carom began the folder, or a name stands for another
                player than before.
        """
        players = {
            player.name: player.player if isinstance(player.player, str) else "(an object)"
            for player in file.players
        }
        events = [asdict(event) for event in file.events]
        manifest = root / MANIFEST
        if manifest.exists():
            _check_manifest(manifest, players)
        description = {
            "format": FORMAT,
            "carom": __version__,
            "players": players,
            "events": events,
        }
        write_whole(manifest, json.dumps(description, ensure_ascii=False, indent=1) + "\n")
        return cls(root, players, file.events)

    def encounters(self) -> Iterator[Encounter]:
        """All encounters that are known now; a Swiss tournament has those of its first rounds."""
        for event in self.events:
            for condition in event.conditions:
                if event.kind != "swiss":
                    yield from encounters(event, condition)
                    continue
                for number, each in enumerate(self.rounds(event, condition), 1):
                    for pair in each.pairs:
                        yield Encounter(event, condition, pair, number)

    def rounds(self, event: Event, condition: Condition) -> list[Round]:
        """The rounds of a Swiss tournament that were drawn."""
        found = []
        for number in range(1, event.rounds + 1):
            path = self._round(event, condition, number)
            if not path.exists():
                break
            written = json.loads(read_text(path))
            pairs = tuple((one, other) for one, other in written["pairs"])
            found.append(Round(pairs, written["bye"]))
        return found

    def draw_rounds(self) -> bool:
        """Draw the next round of each Swiss tournament whose last round is finished.

        Returns:
            Whether a round was drawn.
        """
        drawn = False
        for event in self.events:
            for condition in event.conditions:
                if event.kind == "swiss":
                    drawn |= self._draw_round(event, condition)
        return drawn

    def _draw_round(self, event: Event, condition: Condition) -> bool:
        rounds = self.rounds(event, condition)
        if len(rounds) == event.rounds:
            return False
        points = dict.fromkeys(event.players, (0.0, 0.0))

        def add(name: str, of_match: float, of_frames: float) -> None:
            # A player who left the file has no more rounds.
            if name in points:
                before = points[name]
                points[name] = (before[0] + of_match, before[1] + of_frames)

        for number, each in enumerate(rounds, 1):
            if each.bye is not None:
                add(each.bye, 1.0, 0.5)
            for pair in each.pairs:
                blocks = self.blocks(Encounter(event, condition, pair, number))
                if not all(block.finished for block in blocks):
                    return False
                share = share_of([frame for block in blocks for frame in block.frames()])
                won = 0.5 * (1 + (share > 0.5) - (share < 0.5))
                add(pair[0], won, share)
                add(pair[1], 1 - won, 1 - share)
        drawn = swiss_round(event.players, points, rounds)
        path = self._round(event, condition, len(rounds) + 1)
        path.parent.mkdir(parents=True, exist_ok=True)
        write_whole(path, json.dumps(asdict(drawn), ensure_ascii=False) + "\n")
        return True

    def _round(self, event: Event, condition: Condition, number: int) -> Path:
        return self.root / event_path(event, condition) / f"round-{number:02}.json"

    def blocks(self, encounter: Encounter) -> list[Block]:
        """The blocks of an encounter, in order: those that were begun, and those that are missing.

        A block that was begun keeps its number of pairs. A finished record has revealed its secret,
        so more pairs are further blocks.
        """
        folder, event = self.root / encounter.path, encounter.event
        if event.test is not None:
            return [Block(encounter, 1, event.pairs, folder / "0001")]
        blocks: list[Block] = []
        planned = 0
        while True:
            number = len(blocks) + 1
            place = folder / f"{number:04}"
            header = _header(place)
            if header is None and planned >= event.pairs:
                return blocks
            pairs = min(event.block, event.pairs - planned) if header is None else header["pairs"]
            blocks.append(Block(encounter, number, pairs, place))
            planned += pairs


def share_of(frames: list[FrameResult]) -> float:
    """The share of the points that player 0 has; ½ without a frame that counts."""
    points = [frame.points for frame in frames if frame.points is not None]
    return sum(points) / len(points) if points else 0.5


def secret_of(secret: str, root: Path, block: Block) -> str:
    """The secret of a block, from that of the tournament: HMAC-SHA-256 of its path.

    The secret of a finished block is in its record. It reveals neither that of the tournament nor
    that of another block.
    """
    path = block.folder.relative_to(root).as_posix()
    return hmac.new(bytes.fromhex(secret), path.encode(), hashlib.sha256).hexdigest()


def _event(written: Mapping[str, Any]) -> Event:
    bounds = {key: None if written.get(key) is None else tuple(written[key]) for key in BOUNDS}
    return Event(
        **{
            **written,
            "players": tuple(written["players"]),
            "against": tuple(written["against"]),
            "conditions": tuple(Condition(**condition) for condition in written["conditions"]),
            **bounds,
        }
    )


def _check_manifest(manifest: Path, players: Mapping[str, str]) -> None:
    try:
        found = json.loads(read_text(manifest))
        version, before = found["carom"], dict(found["players"])
    except (ValueError, KeyError, TypeError):
        raise InputError(
            "format", shown(manifest), "it does not describe a tournament", "choose another folder"
        ) from None
    if version != __version__:
        what = f"the folder was begun by carom {version}, and this is {__version__}"
        raise InputError(
            "mismatch",
            shown(manifest),
            f"{what}, whose results may differ",
            "choose another folder",
        )
    for name, player in players.items():
        if name in before and before[name] != player:
            raise InputError(
                "mismatch",
                f"players.{name}",
                f"the name stood for {before[name]} before, and now for {player}",
                "give the other player another name",
            )
