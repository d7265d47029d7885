"""MessagePack with NumPy arrays, as msgpack-numpy writes them.

An array is a map with the keys ``nd``, ``type``, ``kind``, ``shape`` and ``data``, in bytes. Arrays
of objects, which msgpack-numpy would unpickle, are rejected: a file from elsewhere must not run
code.
"""

from __future__ import annotations

from typing import Any

from carom.errors import InputError
from carom.lazy import np


def unpack(data: bytes) -> Any:
    """The tree in ``data``, with arrays as nested lists.

    Raises:
        InputError: msgpack is not installed, or ``data`` is not MessagePack.
    """
    try:
        # Installed only with the extra "import".
        import msgpack
    except ImportError:
        raise InputError(
            "unsupported",
            "",
            "the file is MessagePack, and msgpack is not installed",
            "pip install 'carom[import]', or save the system as JSON",
        ) from None
    try:
        return msgpack.unpackb(data, object_hook=_array)
    except InputError:
        raise
    except Exception as error:  # noqa: BLE001 -- its hook and parser raise many kinds
        # The error of a tree that is nested too deeply has no text.
        why = str(error) or "nested too deeply"
        raise InputError(
            "syntax",
            "",
            f"the file is neither JSON nor MessagePack ({why})",
            "give a system that pooltool saved",
        ) from None


def _array(map_: dict[Any, Any]) -> Any:
    if b"nd" not in map_:
        return map_
    kind = map_[b"type"]
    if map_.get(b"kind") or not isinstance(kind, str):
        raise InputError(
            "wrong-type",
            "",
            "the file holds an array that is not of numbers",
            "give a system that pooltool saved",
        )
    dtype = np.dtype(kind)
    if dtype.hasobject:
        raise InputError(
            "wrong-type",
            "",
            "the file holds an array of objects",
            "give a system that pooltool saved",
        )
    values = np.frombuffer(map_[b"data"], dtype=dtype)
    return values.reshape(map_[b"shape"]).tolist() if map_[b"nd"] else values[0].item()
