#!/usr/bin/env bash
# A nine-ball break: the event table on the screen, pictures and a page to replay it in out/.
# The page needs Node and Rust's WebAssembly target; without them everything else is still done.
set -euo pipefail
cd "$(dirname "$0")/.."

carom=.venv/bin/carom
bash scripts/prerequisites.sh engine
page=yes
lacking=$(bash scripts/prerequisites.sh page 2>&1 >/dev/null) || page=no
if [ $page = no ]; then
  echo "The page will be left out. The reason:" >&2
fi
[ -z "$lacking" ] || echo "$lacking" >&2

make .venv/.built
mkdir -p out
"$carom" break --seed 20 --svg out/nine_ball_break.svg --png out/nine_ball_break.png
echo "Pictures: out/nine_ball_break.svg, out/nine_ball_break.png"

if [ $page = yes ]; then
  make python/carom/web/index.html
  "$carom" break --seed 20 --html out/nine_ball_break.html >/dev/null
  echo "The page: open out/nine_ball_break.html, or run .venv/bin/carom play"
else
  printf '%s\n' "Left out: the page (out/nine_ball_break.html, carom play)." "$lacking" \
    "Then run make demo again." >&2
fi
