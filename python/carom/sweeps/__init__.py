"""Tables of shots: any grid or sample of parameters × layouts × physics, written to Parquet.

sweep = carom.Sweep.load("sweep.json")       # or Sweep.from_dict({...})
sweep.run("out")                             # Parquet; after a kill the same call continues
sweep.table()                                # in memory, for small tables

Needs pyarrow: ``pip install 'carom[sweep]'``; with Ray ``pip install 'carom[ray]'``.
"""

from carom.sweeps.table import Sweep, sweep

__all__ = ["Sweep", "sweep"]
