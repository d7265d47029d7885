#!/bin/bash
# Usage: bench_peer.sh PYTHON (`make bench-peer` runs it).
# Installs carom and pooltool 0.6.0 into an environment of their own under .cache, and runs
# `carom bench` and benches/environments.py there. The results, with the medians of repeated shots
# and the means of shots in turn, go to benches/results with the commit.
set -euo pipefail
venv=$PWD/.cache/peer
# pooltool writes settings into the home directory, so it gets a separate one. Rust stays where it is.
export RUSTUP_HOME=${RUSTUP_HOME:-$HOME/.rustup} CARGO_HOME=${CARGO_HOME:-$HOME/.cargo}
home=$PWD/.cache/peer-home
mkdir -p "$home"
[ -x "$venv/bin/python" ] || "$1" -m venv "$venv"
pip=("$venv/bin/python" -m pip --disable-pip-version-check --quiet)
if ! HOME=$home "$venv/bin/python" -c 'import pooltool' 2>/dev/null; then
  echo "Installing pooltool 0.6.0 into .cache/peer (about 1 GB) ..." >&2
  "${pip[@]}" install --upgrade pip
  "${pip[@]}" install --no-deps --group peer
  # pip reports that pooltool pins other versions of panda3d and rich. One of them does not exist
  # on PyPI, which is why the dependencies are installed separately.
  "${pip[@]}" install --group peer-needs
fi
"${pip[@]}" install ".[env]"
HOME=$home "$venv/bin/carom" bench --store benches/results
HOME=$home exec "$venv/bin/python" benches/environments.py
