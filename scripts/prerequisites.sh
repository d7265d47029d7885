#!/usr/bin/env bash
# Checks what this machine must have before anything is built. What can be added without root is
# added: parts of the Rust toolchain in use. Everything else that is missing is listed at once,
# each with its remedy.
#   prerequisites.sh rust          cargo and a C compiler
#   prerequisites.sh engine        the same, and Python: the module and the command carom
#   prerequisites.sh page          cargo with its WebAssembly target, and Node: the page
#   prerequisites.sh target T      cargo with the target T, such as aarch64-unknown-linux-gnu
#   prerequisites.sh lint          engine and page, with rustfmt and clippy
#   prerequisites.sh tests         the same, and Chromium
#   prerequisites.sh print-python  the Python that the virtual environment is made with
#   prerequisites.sh has-chromium  exit status 0 if Chromium is found
set -euo pipefail
cd "$(dirname "$0")/.."
# make passes a job server that these checks do not use; rustc would warn of it.
unset MAKEFLAGS MFLAGS

wasm=wasm32-unknown-unknown
missing=()

lacks() { missing+=("$1"); }

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
  return 1
}

check_python() {
  find_python >/dev/null ||
    lacks "Python 3.11 or newer with its venv module. Install it (Debian, Ubuntu: apt install python3-venv; macOS: brew install python), or name one: make PYTHON=/path/to/python3."
}

# The oldest Rust that builds carom, as Cargo.toml says.
oldest_rust() { awk -F '"' '/^rust-version/ { print $2 }' Cargo.toml; }

has_rust() { cargo --version >/dev/null 2>&1 && rustc --version >/dev/null 2>&1; }

check_rust() {
  local oldest
  oldest=$(oldest_rust)
  if ! command -v cargo >/dev/null 2>&1; then
    lacks "cargo (Rust $oldest or newer), which compiles the engine. Install Rust from https://rustup.rs and open a new shell."
  elif ! has_rust; then
    lacks "a Rust toolchain: cargo is here, but it does not run. Install one: rustup toolchain install stable."
  elif ! printf '%s\n' "$oldest" "$(rustc --version | awk '{ print $2 }')" | sort -V -C; then
    lacks "Rust $oldest or newer; this is $(rustc --version). Update it: rustup update stable (without rustup: install Rust from https://rustup.rs)."
  fi
  command -v cc >/dev/null 2>&1 || command -v gcc >/dev/null 2>&1 || command -v clang >/dev/null 2>&1 ||
    lacks "a C compiler, with which Rust links. Install one (Debian, Ubuntu: apt install build-essential; macOS: xcode-select --install)."
}

# Adds a part of the Rust toolchain in use; this is the only change outside the checkout but for caches.
add_to_rust() {
  command -v rustup >/dev/null 2>&1 || return 1
  echo "Adding $2 to the Rust toolchain (rustup $1 add $2) ..." >&2
  rustup "$1" add "$2" >/dev/null 2>&1
}

has_wasm() { [ -d "$(rustc --print target-libdir --target "$wasm")" ]; }

check_wasm() {
  has_rust || return 0 # check_rust says it.
  has_wasm || { add_to_rust target "$wasm" && has_wasm; } ||
    lacks "Rust's standard library for WebAssembly, with which the page is built. Add it: rustup target add $wasm (Rust of the distribution, Debian: apt install libstd-rust-dev-wasm32)."
}

check_target() {
  has_rust || return 0 # check_rust says it.
  [ -d "$(rustc --print target-libdir --target "$1")" ] || add_to_rust target "$1" ||
    lacks "Rust's standard library for $1. Add it: rustup target add $1."
}

check_rust_tools() {
  has_rust || return 0
  cargo fmt --version >/dev/null 2>&1 || add_to_rust component rustfmt ||
    lacks "rustfmt, which checks the formatting. Add it: rustup component add rustfmt (Debian: apt install rustfmt)."
  cargo clippy --version >/dev/null 2>&1 || add_to_rust component clippy ||
    lacks "clippy, which checks the Rust code. Add it: rustup component add clippy (Debian: apt install rust-clippy)."
}

check_node() {
  # The same bound as "engines" in web/package.json.
  node -e 'const [a, b] = process.versions.node.split("."); process.exit(+a > 20 || (+a === 20 && +b >= 19) ? 0 : 1)' 2>/dev/null ||
    lacks "Node 20.19 or newer, which builds the page. Install it from https://nodejs.org (macOS: brew install node)."
  command -v npm >/dev/null 2>&1 ||
    lacks "npm, which comes with Node. Install it (Debian, Ubuntu: apt install npm)."
}

has_chromium() {
  if [ -n "${CHROMIUM:-}" ]; then
    [ -x "$CHROMIUM" ]
  else
    command -v chromium >/dev/null 2>&1 || node web/scripts/find_chromium.js >/dev/null 2>&1
  fi
}

check_chromium() {
  has_chromium ||
    lacks "Chromium, in which the page is tested. Install it (Debian: apt install chromium; elsewhere: npx playwright-core install chromium), or name one: CHROMIUM=/path/to/chrome make test."
}

case "${1:-engine}" in
  print-python)
    find_python || { echo "carom: Python 3.11 or newer is missing." >&2; exit 1; }
    exit ;;
  has-chromium)
    has_chromium
    exit ;;
  rust) check_rust ;;
  engine) check_rust; check_python ;;
  page) check_rust; check_wasm; check_node ;;
  target) check_rust; check_target "$2" ;;
  lint) check_rust; check_python; check_wasm; check_rust_tools; check_node ;;
  tests) check_rust; check_python; check_wasm; check_rust_tools; check_node; check_chromium ;;
  *) echo "usage: prerequisites.sh rust|engine|page|target T|lint|tests|print-python|has-chromium" >&2; exit 2 ;;
esac

if [ ${#missing[@]} -gt 0 ]; then
  echo "carom: this machine lacks" >&2
  printf '  - %s\n' "${missing[@]}" >&2
  exit 1
fi
