#!/bin/bash
# `make bench-peer` runs this with the PYTHON to use: carom and pooltool 0.6.0 side by side in an
# environment of their own under .cache, and `carom bench` in it.
set -euo pipefail
venv=$PWD/.cache/peer
# pooltool writes settings into the home directory: it gets one of its own.
home=$PWD/.cache/peer-home
mkdir -p "$home"
[ -x "$venv/bin/python" ] || "$1" -m venv "$venv"
pip=("$venv/bin/python" -m pip --disable-pip-version-check --quiet)
if ! HOME=$home "$venv/bin/python" -c 'import pooltool' 2>/dev/null; then
  echo "Installing pooltool 0.6.0 into .cache/peer (about 1 GB) ..." >&2
  "${pip[@]}" install --upgrade pip
  "${pip[@]}" install --no-deps --group peer
  # pip complains that pooltool pins other versions of panda3d and rich: that is why we are here.
  "${pip[@]}" install --group peer-needs
fi
"${pip[@]}" install ".[env]"
HOME=$home "$venv/bin/carom" bench --store benches/results
HOME=$home exec "$venv/bin/python" benches/environments.py
