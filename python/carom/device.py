"""Where batches are played: on this machine's cores, or on a CUDA device with the same bits.

``device="cuda"`` is the first card, ``"cuda:1"`` the second. The card needs NVIDIA's driver and the
compute capability 7.0 (2017) or newer. The program of the card is part of the package; in a
checkout ``make kernel`` builds it. When a device is first used, some shots are played on it and on
this machine, and their bits must be the same. Shots of more than 24 balls are played on the cores.
"""

from __future__ import annotations

import functools
import gzip
import re
from pathlib import Path

from carom import _core
from carom.errors import InputError

# Built by scripts/cuda_kernel.sh.
KERNEL = Path(__file__).with_name("kernel") / "carom.ptx.gz"


def opened(device: str) -> _core.CudaDevice | None:
    """The device with this name; None for ``"cpu"``.

    Raises:
        InputError: There is no such name, driver, device or kernel, or the device computes other
            bits.
    """
    if device == "cpu":
        return None
    match = re.fullmatch(r"cuda(?::(\d{1,4}))?", device) if isinstance(device, str) else None
    if match is None:
        remedy = 'write "cpu", "cuda" or "cuda:1"'
        raise InputError("unknown-name", "device", f"{device!r} is no device", remedy)
    return _cuda(int(match[1] or 0))


@functools.cache
def _cuda(ordinal: int) -> _core.CudaDevice:
    try:
        kernel = gzip.decompress(KERNEL.read_bytes())
    except OSError as error:
        raise InputError(
            "unsupported",
            "device",
            f"this installation has no kernel for CUDA ({error.strerror}: {KERNEL})",
            'install a wheel, build the kernel in a checkout (make kernel), or use device="cpu"',
        ) from None
    return _core.CudaDevice(ordinal, kernel)
