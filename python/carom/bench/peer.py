"""pooltool 0.6.0 on the same states, if it is installed.

pooltool runs with its own default models, ball, cue and table, which is the table of the states.
Only its `simulate` is timed, without the building of a system and without the compilation during
the first shots.
"""

from __future__ import annotations

import os
import tempfile
import time
from contextlib import contextmanager
from importlib.metadata import PackageNotFoundError, version
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Iterator

    from carom.bench.states import State

#: The version that the published figures compare with.
VERSION = "0.6.0"

HOW_TO_INSTALL = (
    f"pooltool {VERSION} is not installed, so only carom is measured; `make bench-peer` in a "
    "checkout installs it into a separate environment and compares."
)


@contextmanager
def _temporary_home() -> Iterator[None]:
    """Sets HOME to a temporary folder, because pooltool writes settings into it on import."""
    home = os.environ.get("HOME")
    with tempfile.TemporaryDirectory(prefix="carom-bench-") as folder:
        os.environ["HOME"] = folder
        try:
            yield
        finally:
            if home is None:
                del os.environ["HOME"]
            else:
                os.environ["HOME"] = home


class Pooltool:
    """pooltool with its default physics.

    Raises:
        ImportError: It is not installed, or its version is not `VERSION`.
    """

    def __init__(self) -> None:
        try:
            found = version("pooltool-billiards")
        except PackageNotFoundError as error:
            raise ImportError(HOW_TO_INSTALL) from error
        if found != VERSION:
            raise ImportError(
                f"pooltool {found} is installed, but the comparison needs {VERSION}; "
                "`make bench-peer` in a checkout installs it into a separate environment."
            )
        with _temporary_home():
            import pooltool
            from pooltool.physics.engine import PhysicsEngine
            from pooltool.physics.resolve.resolver import default_resolver
        self.version = found
        self._pt = pooltool
        # Given explicitly, so that settings in a home directory cannot change the models.
        self._engine = PhysicsEngine(resolver=default_resolver())

    def system(self, state: State) -> Any:
        """A pooltool system that is ready to be simulated."""
        pt = self._pt
        cue = pt.Cue(
            cue_ball_id="cue",
            V0=state.speed,
            phi=state.azimuth_deg,
            theta=state.elevation_deg,
            a=-state.side,  # to the left in pooltool
            b=state.height,
        )
        balls = {name: pt.Ball.create(name, xy=xy) for name, xy in state.balls.items()}
        return pt.System(cue=cue, table=pt.Table.default(), balls=balls)

    def simulate(self, state: State) -> tuple[float, Any]:
        """Simulates a state: returns the seconds of processor time, and the simulated system."""
        system = self.system(state)
        start = time.process_time()
        self._pt.simulate(system, engine=self._engine, inplace=True)
        return time.process_time() - start, system

    @staticmethod
    def events(system: Any) -> int:
        """Number of events without the markers of beginning and end."""
        return sum(str(event.event_type) != "none" for event in system.events)

    @staticmethod
    def pocketed(system: Any) -> list[str]:
        """Ids of the pocketed balls, in order."""
        return [event.ids[0] for event in system.events if event.event_type == "ball_pocket"]
