"""pyarrow, which is an extra: ``pip install 'carom[sweep]'``."""

try:
    import pyarrow as pa
    import pyarrow.parquet as pq
except ImportError as error:
    raise ImportError("carom.sweep needs pyarrow: pip install 'carom[sweep]'") from error

__all__ = ["pa", "pq"]
