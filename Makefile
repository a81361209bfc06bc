# Needs Python >= 3.11 with venv, and make. Everything is installed into .venv from the hashed lock files.
PYTHON ?= python3
VENV   ?= .venv
RUN    ?= runs/demo
BIN    := $(VENV)/$(if $(filter Windows_NT,$(OS)),Scripts,bin)
PIP    := $(BIN)/python -m pip --disable-pip-version-check -q

FLEET  := .venv-workflow

# Children that start in the hundreds would compile every module anew
unexport PYTHONDONTWRITEBYTECODE

.PHONY: demo test quick test-long coverage fuzz faults audit check bench bench-all docs dist workflow test-workflow lock clean

demo: $(VENV)/.run-ready
	$(BIN)/debist warmup
	$(BIN)/debist demo -o $(RUN)

# The tests of a file share its fixtures, so they stay in one process
test: $(VENV)/.dev-ready
	$(BIN)/debist warmup
	$(BIN)/python -m pytest -n auto --maxprocesses 8 --dist loadfile --no-loadscope-reorder

# What may differ between versions of Python and of libraries, in a minute or two
quick: $(VENV)/.dev-ready
	$(BIN)/python -m pytest tests/numerics tests/codegen tests/models/analytical tests/models/hybrid/test_condensed.py \
	    tests/store tests/workflow/test_engine.py tests/rig_logs/test_readers.py \
	    tests/faults/test_isolation.py tests/api/test_debist.py tests/commands/test_cli.py

test-long: $(VENV)/.dev-ready
	$(BIN)/python -m pytest -n auto --maxprocesses 8 --dist loadfile -m "long or not long"

# 10,000 damaged logs of every format and 500 changed files of every model; faults at many calls of a run that change a
# file (Linux)
fuzz: $(VENV)/.dev-ready
	$(BIN)/python -m tests.fuzz
	$(BIN)/python -m pytest -m long tests/fuzz/test_model_files.py

faults: $(VENV)/.dev-ready
	$(BIN)/python -m pytest -m "long or not long" tests/faults tests/store tests/workflow/test_hostile_places.py \
	    tests/rig_logs/test_hostile.py tests/units

# Statements and branches that the default tests reach, by room; children and copies of processes count
coverage: $(VENV)/.dev-ready
	$(BIN)/python -m coverage run -m pytest
	$(BIN)/python -m coverage combine -q
	$(BIN)/python -m coverage report --skip-covered

# Asks the advisory databases about every pinned version; needs the network
audit: $(VENV)/.dev-ready
	$(BIN)/pip-audit --disable-pip --require-hashes -r requirements.lock

check: $(VENV)/.dev-ready
	$(BIN)/ruff format --check
	$(BIN)/ruff check
	$(BIN)/mypy
	$(BIN)/lint-imports

# The table of docs/reference/speed.md, measured anew: 4 minutes. `make bench-all`: every benchmark, half an hour, 4 GB
bench: $(VENV)/.dev-ready
	$(BIN)/python benchmarks/bench_speed.py --page docs/reference/speed.md

bench-all: $(VENV)/.dev-ready
	for script in benchmarks/bench_*.py; do $(BIN)/python $$script || exit 1; done

docs: $(VENV)/.dev-ready
	NO_MKDOCS_2_WARNING=1 $(BIN)/mkdocs build --strict -q

dist: $(VENV)/.dev-ready
	SOURCE_DATE_EPOCH=$${SOURCE_DATE_EPOCH:-$$(git log -1 --format=%ct)} $(BIN)/python -m build --no-isolation -q -o dist

lock: $(VENV)/.dev-ready
	$(PIP) install uv
	$(BIN)/uv pip compile -q --universal --python-version 3.11 --generate-hashes --no-emit-index-url \
	    --no-header --upgrade pyproject.toml --group pyproject.toml:build -o requirements.lock
	$(BIN)/uv pip compile -q --universal --python-version 3.11 --generate-hashes --no-emit-index-url \
	    --no-header --upgrade pyproject.toml --group pyproject.toml:build --group pyproject.toml:dev \
	    -c requirements.lock -o requirements-dev.lock
	$(BIN)/uv pip compile -q --universal --python-version 3.11 --generate-hashes --no-emit-index-url \
	    --no-header --upgrade pyproject.toml --extra workflow --group pyproject.toml:build \
	    -c requirements-dev.lock -o requirements-workflow.lock

# Snakemake with debist, in an environment of its own: one of its packages (connection-pool) comes as source only.
workflow: $(FLEET)/.ready

test-workflow: $(FLEET)/.ready $(VENV)/.dev-ready
	PATH="$(CURDIR)/$(FLEET)/bin:$$PATH" $(BIN)/python -m pytest tests/workflows/test_snakemake.py

clean:
	rm -rf $(VENV) $(FLEET) build dist

$(VENV)/.made:
	$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11) and "debist needs Python 3.11 or newer; set PYTHON=/path/to/python3.11")'
	$(PYTHON) -m venv $(VENV)
	touch $@

# What users install: the package itself, anew when a source has changed. Developers have the checkout in its place.
$(VENV)/.run-ready: requirements.lock pyproject.toml $(shell find pipeline -name '*.py' -o -name '*.j2') | $(VENV)/.made
	$(PIP) install --only-binary :all: --require-hashes -r requirements.lock
	$(PIP) install --no-deps --no-build-isolation $(if $(wildcard $(VENV)/.dev-ready),-e) .
	touch $@

$(VENV)/.dev-ready: requirements-dev.lock pyproject.toml | $(VENV)/.made
	$(PIP) install --only-binary :all: --require-hashes -r requirements-dev.lock
	$(PIP) install --no-deps --no-build-isolation -e .
	touch $@ $(VENV)/.run-ready

$(FLEET)/.ready: requirements-workflow.lock pyproject.toml
	$(PYTHON) -m venv $(FLEET)
	$(FLEET)/bin/python -m pip --disable-pip-version-check -q install --only-binary :all: --no-binary connection-pool \
	    --require-hashes -r requirements-workflow.lock
	$(FLEET)/bin/python -m pip --disable-pip-version-check -q install --no-deps --no-build-isolation .
	touch $@
