# carom. `make` alone lists the targets. Every target installs what it needs: Python packages in .venv,
# Rust's output in target, JavaScript packages in web/node_modules. Outside the checkout only the caches of
# pip, cargo and npm change, and rustup adds the WebAssembly target, rustfmt and clippy if they are missing.

SHELL := /bin/bash
.SHELLFLAGS := -eu -o pipefail -c
.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
MAKEFLAGS += --no-print-directory

VENV := .venv
BIN := $(VENV)/bin
PY := $(BIN)/python
# Stamp files: a step runs again if one of its sources is newer.
TOOLS := $(VENV)/.tools
BUILT := $(VENV)/.built
RUST_SOURCES := $(shell find crates/carom crates/carom-roots crates/carom-rules crates/carom-plan crates/carom-mind \
                  crates/carom-arena crates/carom-cuda crates/carom-drill crates/carom-env crates/carom-py -type f \
                  \( -path '*/src/*' -o -path '*/schemas/*' -o -name Cargo.toml \)) \
                Cargo.toml Cargo.lock
# npm writes this file last.
MODULES := web/node_modules/.package-lock.json
PAGE := python/carom/web/index.html
PAGE_SOURCES := $(shell find crates/carom crates/carom-roots crates/carom-rules crates/carom-plan crates/carom-mind \
                  crates/carom-arena crates/carom-drill crates/carom-wasm web/src -type f \
                  \( -path '*/src/*' -o -path '*/schemas/*' -o -name Cargo.toml \) \
                  -not -path 'web/src/engine/pkg/*') \
                Cargo.toml Cargo.lock scripts/wasm.sh scripts/wasm_bindgen/Cargo.toml scripts/wasm_bindgen/src/main.rs web/index.html web/vite.config.ts LICENSE-THIRD-PARTY
# pip and npm do not pass make's job server on; cargo and rustc below them would warn of it.
ALONE := env -u MAKEFLAGS -u MFLAGS
PYTEST := $(PY) -m pytest
# The newest Rust whose lints were looked at. A newer clippy may have more: they are shown, but do not fail.
LINTED_RUST := 1.99
DENY := $(shell printf '%s\n' "$$($(ALONE) rustc --version 2>/dev/null | cut -d ' ' -f 2)" $(LINTED_RUST).999 | \
                sort -V -C && echo -D warnings)
# Clippy checks the examples and benchmarks; they are not built here.
# The bindings are tested from Python and JavaScript.
WITHOUT_BINDINGS := --workspace --exclude carom-py --exclude carom-wasm
DEBUG_TESTS := $(WITHOUT_BINDINGS) --lib --bins --tests
DOC_TESTS := $(WITHOUT_BINDINGS) --doc
RELEASE_TESTS := --profile release-tests -p carom -p carom-check -p carom-rules \
                 --test simulate --test whole_shots --test random_play
# maturin is found on the path.
export PATH := $(CURDIR)/$(BIN):$(PATH)

KERNEL := python/carom/kernel/carom.ptx.gz

.PHONY: help demo kernel test stress wheel release audit bench bench-peer c docs goldens reference experiments licenses fmt page \
        picture \
        lint lint-rust lint-page lint-python lint-text \
        rust-build rust-test web-test python-test setup clean

help: ## List the targets.
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "  make %-12s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

demo: ## A nine-ball break: the event table here, pictures and a page to replay it in out/.
	@bash scripts/demo.sh

# Everything that is missing is listed before anything is built.
test: ## Every test: Rust, the page, Python, README snippets, lints.
	@bash scripts/prerequisites.sh tests
	@$(MAKE) --jobs=2 setup rust-build
	@$(MAKE) lint rust-test web-test python-test

# The last step of each build uses one core; side by side they use two.
rust-build:
	@bash scripts/prerequisites.sh rust
	@echo "Building the Rust tests ..." >&2
	+@cargo test --quiet $(DEBUG_TESTS) --no-run
	+@cargo test --quiet $(RELEASE_TESTS) --no-run

# Most linters use one core.
lint: $(BUILT) $(MODULES) ## Formatting, lints, types and plain English.
	@bash scripts/prerequisites.sh lint
	+@$(MAKE) --jobs=2 lint-rust lint-page lint-python lint-text

lint-rust:
	+cargo fmt --all --check
	+cargo clippy --workspace --all-targets --quiet -- $(DENY)
	+@bash scripts/crate_builds.sh
	+@RUSTDOCFLAGS="$(DENY)" cargo doc --no-deps --quiet

lint-page: $(MODULES)
	cd web && $(ALONE) npm run --silent check

lint-python: $(BUILT)
	$(BIN)/ruff check --quiet .
	$(BIN)/ruff format --check --quiet .
	$(BIN)/mypy
	MYPYPATH=python $(PY) -m mypy.stubtest carom._core --concise

lint-text: $(BUILT)
	$(PY) scripts/write_licenses.py --check
	$(PY) scripts/prose.py

rust-test: ## The Rust tests in debug; whole shots, 100 000 of them random, in release too.
	@bash scripts/prerequisites.sh rust
	cargo test --quiet $(DEBUG_TESTS)
	cargo test --quiet $(DOC_TESTS)
	cargo test --quiet $(RELEASE_TESTS)
	@bash scripts/everywhere.sh goldens aarch64

web-test: $(BUILT) $(PAGE) ## The page's tests, in Node and in Chromium.
	@bash scripts/prerequisites.sh tests
	cd web && $(ALONE) npm run --silent test
	cd web && $(ALONE) npm run --silent e2e

python-test: $(BUILT) $(PAGE) ## The Python tests, the validation and the README's snippets.
	$(PYTEST) --quiet --durations=10 --numprocesses=2 --dist=worksteal

stress: $(BUILT) $(MODULES) ## The long randomised suites: 10 million shots and more (hours).
	bash scripts/vector_builds.sh
	bash scripts/everywhere.sh all
	cargo test --release --workspace --exclude carom-py -- --ignored
	CAROM_CASES=1000000 cargo test --release -p carom-roots --test hard_families
	CAROM_PATHS=1000000 cargo test --release -p carom --test table
	PROPTEST_CASES=100000 cargo test --release -p carom-check --test whole_shots -- laws symmetries
	CAROM_FRAMES=100000 cargo test --release -p carom-rules --test random_play
	CAROM_SANITIZE=1 cargo test --release -p carom-c --test programs
	cargo test --manifest-path examples/godot/Cargo.toml --target-dir target/godot
	bash scripts/fuzz.sh 600
	@$(PY) -m pip install --quiet --disable-pip-version-check --group gpu
	$(PYTEST) -m stress
	$(PY) benches/table_coverage.py --again
	cargo run --release -p carom-check --example stress
	cargo run --release -p carom-springs --example networks -- --count 60000

bench: $(BUILT) $(PAGE) ## The benchmarks; results under benches/results/.
	$(BIN)/carom bench
	$(PY) benches/instructions.py
	$(PY) benches/environments.py
	$(PY) benches/sweep.py
	$(PY) benches/questions.py
	$(PY) benches/amplification.py
	$(PY) benches/many_balls.py
	$(PY) benches/pushes.py
	$(PY) benches/c_interface.py
	cd web && $(ALONE) npm run --silent bench

bench-peer: $(TOOLS) ## The same beside pooltool 0.6.0, in an environment of its own (1 GB).
	@bash scripts/bench_peer.sh $(PY)

c: ## The C library, its header and the files of pkg-config and CMake, into dist/c.
	@bash scripts/prerequisites.sh rust
	+cargo build --quiet --release -p carom-c
	@cp -f target/release/libcarom_c.a target/release/libcarom.a
	@for kind in so dylib; do \
	  if [ -f target/release/libcarom_c.$$kind ]; then \
	    cp -f target/release/libcarom_c.$$kind target/release/libcarom.$$kind; fi; done
	@bash scripts/c_library.sh target/release dist/c
	@echo "The C library is in dist/c; docs/game.md shows how a program uses it."

docs: $(BUILT) $(PAGE) ## The documentation, into docs/_build.
	RUSTDOCFLAGS="-D warnings" cargo doc --no-deps --quiet --target-dir docs/_build/rust
	@$(PY) -m pip install --quiet --disable-pip-version-check --group docs
	$(PY) scripts/build_docs.py docs/_build

goldens: $(BUILT) ## Write the goldens again, after an intended change of results.
	$(PY) scripts/write_goldens.py

reference: ## Write the JSON Schema, the table of docs/formats.md and the interfaces for C and C# again.
	CAROM_WRITE=1 cargo test --quiet -p carom --test shot reference
	CAROM_WRITE=1 cargo test --quiet -p carom-c --test header
	CAROM_WRITE=1 cargo test --quiet -p carom-c --test csharp

wheel: $(TOOLS) $(PAGE) ## The wheel for this machine, with the page, into dist/.
	@bash scripts/prerequisites.sh engine
	@bash scripts/wheel.sh dist
	@ls dist/*.whl

# PYTHONPATH: the package `release` in scripts/.
release: $(BUILT) $(MODULES) ## Build every file of a release twice, check it, into dist/. Publishes nothing.
	@bash scripts/prerequisites.sh page
	@for target in x86_64 aarch64; do bash scripts/prerequisites.sh target $$target-unknown-linux-gnu; done
	@$(ALONE) $(PY) -m pip install --quiet --disable-pip-version-check --group release
	@PYTHONPATH=scripts $(ALONE) $(PY) -m release

audit: $(BUILT) $(MODULES) ## Licences, sources and known vulnerabilities of the dependencies.
	@$(ALONE) $(PY) -m pip install --quiet --disable-pip-version-check --group release
	@PYTHONPATH=scripts $(ALONE) $(PY) -m release.audit

experiments: $(BUILT) ## Make the stored results again that are older than the physics; resumable.
	$(PY) scripts/experiments.py

licenses: $(BUILT) $(MODULES) ## Write the licence notices of the dependencies, after a change of dependencies.
	$(PY) scripts/write_licenses.py

picture: $(BUILT) $(PAGE) ## The README's picture of the page, by Chromium.
	@mkdir -p out
	@$(BIN)/carom break --seed 20 --html out/nine_ball_break.html > /dev/null
	node web/scripts/picture.js out/nine_ball_break.html 1.3 docs/images/page.png

fmt: $(TOOLS) $(MODULES) ## Format everything.
	cargo fmt --all
	$(BIN)/ruff format --quiet .
	$(BIN)/ruff check --quiet --fix .
	cd web && npm run --silent format

page: $(PAGE) ## The page that `carom play` opens, into python/carom/web.

kernel: ## The CUDA kernel for device="cuda", by a nightly Rust; no card is needed.
	@mkdir -p $(dir $(KERNEL))
	bash scripts/cuda_kernel.sh $(KERNEL)

setup: $(BUILT) $(PAGE) ## The virtual environment in .venv with carom and every tool in it, and the page.

clean: ## Remove everything that was built.
	rm -rf $(VENV) python/carom/kernel target out dist docs/_build docs/gallery python/carom/*.so \
	  web/node_modules web/dist web/src/engine/pkg python/carom/web

$(TOOLS): pyproject.toml scripts/prerequisites.sh
	@bash scripts/prerequisites.sh engine
	@echo "Setting up $(VENV) ..." >&2
	@test -x $(PY) || "$$(bash scripts/prerequisites.sh print-python)" -m venv $(VENV)
	@$(PY) -m pip install --quiet --disable-pip-version-check --upgrade pip
	@$(PY) -m pip install --quiet --group dev
	@touch $@

$(BUILT): $(TOOLS) $(RUST_SOURCES) pyproject.toml
	@bash scripts/prerequisites.sh engine
	@echo "Building carom (the first time takes a minute or two) ..." >&2
	@$(ALONE) $(PY) -m pip install --quiet --no-build-isolation --editable .
	@touch $@

$(MODULES): web/package.json web/package-lock.json
	@bash scripts/prerequisites.sh page
	@cd web && npm ci --no-audit --no-fund --no-update-notifier --loglevel=error >/dev/null
	@touch $@

$(PAGE): $(MODULES) $(PAGE_SOURCES)
	@bash scripts/prerequisites.sh page
	@echo "Building the page (the first time takes some minutes) ..." >&2
	@cd web && $(ALONE) npm run --silent build -- --logLevel warn
	@mkdir -p $(@D)
	@cp web/dist/* $(@D)/
