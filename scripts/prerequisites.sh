#!/usr/bin/env bash
# Names what is missing on this machine, in one sentence with the remedy.
#   prerequisites.sh               cargo, a C compiler, Python
#   prerequisites.sh rust          cargo and a C compiler only
#   prerequisites.sh page          what the page is built with: cargo, its WebAssembly target, Node
#   prerequisites.sh tests         all of these, and Chromium
#   prerequisites.sh print-python  the Python that the virtual environment is made with
set -euo pipefail

missing() { echo "carom: $1" >&2; exit 1; }

find_python() {
  local candidate
  for candidate in "${PYTHON:-}" python3 python3.14 python3.13 python3.12 python3.11; do
    [ -n "$candidate" ] && command -v "$candidate" >/dev/null 2>&1 || continue
    if "$candidate" -c 'import sys, venv, ensurepip; sys.exit(sys.version_info < (3, 11))' 2>/dev/null
    then
      command -v "$candidate"
      return
    fi
  done
  missing "Python 3.11 or newer with its venv module is missing; install it (Debian, Ubuntu: apt install python3-venv; macOS: brew install python) or name one: make PYTHON=/path/to/python3."
}

check_rust() {
  command -v cargo >/dev/null 2>&1 ||
    missing "cargo is missing; install Rust from https://rustup.rs and open a new shell."
  command -v cc >/dev/null 2>&1 || command -v gcc >/dev/null 2>&1 || command -v clang >/dev/null 2>&1 ||
    missing "a C compiler (Rust links with it) is missing; install one (Debian, Ubuntu: apt install build-essential; macOS: xcode-select --install)."
}

check_page() {
  check_rust
  [ -d "$(rustc --print target-libdir --target wasm32-unknown-unknown)" ] ||
    missing "Rust's standard library for WebAssembly is missing; rustup target add wasm32-unknown-unknown."
  # As package.json says it: the page's build needs 20.19.
  node -e 'const [a, b] = process.versions.node.split("."); process.exit(+a > 20 || (+a === 20 && +b >= 19) ? 0 : 1)' 2>/dev/null ||
    missing "Node 20.19 or newer, which builds the page, is missing; install it from https://nodejs.org (macOS: brew install node)."
  command -v npm >/dev/null 2>&1 ||
    missing "npm, which comes with Node and builds the page, is missing; install it (Debian, Ubuntu: apt install npm)."
}

check_chromium() {
  [ -x "${CHROMIUM:-/usr/bin/chromium}" ] ||
    missing "Chromium, in which the page is tested, is missing; install it (Debian: apt install chromium) or name one: CHROMIUM=/path/to/chrome make test."
}

case "${1:-all}" in
  print-python) find_python ;;
  rust) check_rust ;;
  page) check_page ;;
  tests) check_page; find_python >/dev/null; check_chromium ;;
  all) check_rust; find_python >/dev/null ;;
esac
