"""Threads that the operating system may refuse to start, as under the limits of a container."""

from __future__ import annotations

from threading import Event, Thread


def startable(count: int) -> int:
    """The number of threads that the system starts now, at most ``count``."""
    end = Event()
    started: list[Thread] = []
    try:
        for _ in range(count):
            thread = Thread(target=end.wait, daemon=True)
            thread.start()
            started.append(thread)
    except RuntimeError:
        # The system has no more threads.
        pass
    finally:
        end.set()
        for thread in started:
            thread.join()
    return len(started)
