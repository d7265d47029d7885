"""The seeds of an experiment's parts."""

from __future__ import annotations

import hashlib


def seed_of(name: str, number: int) -> int:
    """A seed below 2⁴⁸ for this part of the experiment with this name."""
    return int.from_bytes(hashlib.sha256(f"{name} {number}".encode()).digest()[:6])
