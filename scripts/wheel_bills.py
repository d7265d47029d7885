"""Remove the checkout's path from the bills of materials of wheels.

    python scripts/wheel_bills.py WHEEL ...

maturin names the crates of the checkout by their folders. Without the path the same commit gives
the same bytes in every folder.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def main(wheels: list[Path]) -> None:
    """Write each wheel again, with ``file:///carom`` in place of the checkout's address."""
    for wheel in wheels:
        with tempfile.TemporaryDirectory() as folder:
            _wheel("unpack", str(wheel), "--dest", folder)
            (unpacked,) = Path(folder).iterdir()
            for bill in unpacked.glob("*.dist-info/sboms/*.json"):
                text = bill.read_text(encoding="utf-8").replace(ROOT.as_uri(), "file:///carom")
                bill.write_text(text, encoding="utf-8")
            _wheel("pack", str(unpacked), "--dest-dir", str(wheel.parent))


def _wheel(*arguments: str) -> None:
    subprocess.run(["wheel", *arguments], check=True, stdout=subprocess.DEVNULL)


if __name__ == "__main__":
    main([Path(name) for name in sys.argv[1:]])
