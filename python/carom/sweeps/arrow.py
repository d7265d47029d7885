"""pyarrow, which is an extra: ``pip install 'carom[sweep]'``."""

from carom.errors import InputError

try:
    import pyarrow as pa
    import pyarrow.parquet as pq
except ImportError:
    raise InputError("a sweep needs pyarrow: pip install 'carom[sweep]'") from None

__all__ = ["pa", "pq"]
