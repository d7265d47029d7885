"""Frames that several threads use."""

from __future__ import annotations

import gc
import sys
import threading
from typing import Any

import carom


class Noisy:
    """An object in a cycle: the garbage collector runs its code in the middle of any call."""

    def __init__(self) -> None:
        self.own = self

    def __del__(self) -> None:
        sum(range(50))


def test_a_frame_that_threads_share_is_never_borrowed_twice() -> None:
    """It raised "Already borrowed" when the thread changed in the middle of a call."""
    frame = carom.Frame("nine-ball", seed=1)
    raised: list[Any] = []

    def play() -> None:
        for _ in range(100):
            Noisy()
            try:
                request = frame.request
                if request.kind == "choice":
                    frame.choose(request.choices[0])
                else:
                    place = (0.6, 0.5) if request.in_hand else None
                    frame.play(carom.Strike(2.0, 1.57), cue_ball=place)
            except carom.CaromError:
                pass  # Another thread has answered this request.
            except RuntimeError as error:
                raised.append(error)

    interval, threshold = sys.getswitchinterval(), gc.get_threshold()
    sys.setswitchinterval(1e-6)
    gc.set_threshold(5)
    try:
        threads = [threading.Thread(target=play) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    finally:
        sys.setswitchinterval(interval)
        gc.set_threshold(*threshold)
    assert raised == []
