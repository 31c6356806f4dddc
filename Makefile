# Short names for what CMake does. `make`, `make demo` and `make test` install what is missing first (Debian 12, as root).

JOBS ?= $(shell nproc)
PREFIX ?= /usr/local
FUZZ_SECONDS ?= 3600
SEEDS ?= 1000
FOLDERS ?= canvoy/devices/cia419
COUNT ?= 20
CASES ?= 20000
SETS ?= 1000
SEED ?= 1

.PHONY: build coverage dist release-check demo docs playground test check test-all tidy bench bench-page fuzz api fit properties response-times sabotage mutate mutate-all format install clean

# The command, at build/canvoy.
build:
	@scripts/install-packages build
	@cmake --preset release --log-level=WARNING
	@cmake --build --preset release -j $(JOBS) --target canvoy

# A night in which a battery is charged: a live table on a terminal, its summary into a pipe.
demo: build
	@if [ -t 1 ]; then build/canvoy run charger --speed 600; else build/canvoy run charger; fi

# The documentation as a site, at build/docs/site: all links are checked.
docs: build build/docs/venv/installed
	@scripts/api-docs
	@CANVOY=build/canvoy NO_MKDOCS_2_WARNING=1 build/docs/venv/bin/mkdocs build --strict
	@echo "build/docs/site/index.html"

build/docs/venv/installed: docs/requirements.txt
	@scripts/install-packages docs
	@python3 -m venv build/docs/venv
	@build/docs/venv/bin/pip install --quiet --requirement docs/requirements.txt
	@touch $@

# The simulated networks in a browser, at build/playground/site: `make docs` takes them into the site. Tried in chromium.
playground: build
	@scripts/install-packages playground
	@JOBS=$(JOBS) scripts/playground --test

# Each test once: the command, strangers and embedding by the release, unit tests with sanitizers, fuzzing, style.
test:
	@scripts/install-packages check
	@JOBS=$(JOBS) scripts/run-tests test

# Before each commit: the command, unit tests of the lower libraries, a run of each world.
check:
	@scripts/install-packages check
	@JOBS=$(JOBS) scripts/run-tests check

# Before each release: all tests in both builds, long runs, campaigns of faults, long fuzzing, clang-tidy on all sources.
test-all:
	@scripts/install-packages check
	@JOBS=$(JOBS) scripts/run-tests all

# clang-tidy on all that has changed since it last was clean, or what SECONDS allow; notes what is, which `make test` leaves out.
tidy:
	@scripts/install-packages test
	@cmake --preset release --log-level=WARNING
	@tests/style/clang_tidy build/compile_commands.json --record $(SECONDS)

# What the unit tests reach: lines, branches and MC/DC of each room, as docs/evidence.md has it.
coverage:
	@scripts/install-packages coverage
	@scripts/coverage --jobs $(JOBS)
	@scripts/evidence --take

bench:
	@scripts/install-packages bench
	@cmake --preset bench --log-level=WARNING
	@cmake --build --preset bench -j $(JOBS) --target canvoy_bench
	@bench/run build/bench
	@bench/size/report

bench-page:
	@scripts/install-packages build
	@cmake --preset release --log-level=WARNING
	@cmake --build --preset release -j $(JOBS) --target canvoy
	@cd canvoy/web/page && npm ci --silent
	@bench/page build/canvoy

# A long campaign; what is found stays in fuzz/found, which `make clean` leaves alone.
fuzz:
	@scripts/install-packages test
	@cmake --preset fuzz --log-level=WARNING -DCANVOY_FUZZ_SECONDS=$(FUZZ_SECONDS) -DCANVOY_FUZZ_SEED=0
	@cmake --build --preset fuzz -j $(JOBS)
	@ctest --test-dir build/fuzz -j $(JOBS) --verbose

# The page's API against its description, in so many cases of each operation.
api: CASES = 1000
api: build
	@scripts/install-packages test
	@CANVOY=build/canvoy tests/web/api_test.py $(CASES) $(SEED)

# MDF files in both directions against python-can and asammdf, of SEEDS random buses.
mdf: build
	@scripts/install-packages mdf
	@CANVOY=build/canvoy build/mdf/venv/bin/python tests/strangers/traces/mdf/mdf_test.py

# All views of all worlds at all sizes, in light and dark: nothing beyond an edge, nothing too small, and axe finds nothing.
fit: build
	@scripts/install-packages test
	@CANVOY=build/canvoy CANVOY_WHOLE=1 node --test --test-concurrency=1 tests/web/fit_test.mjs tests/web/firefox_test.mjs

# Properties in CASES cases by chance; the tests have the same hundred of them each time.
properties:
	@scripts/install-packages test
	@cmake --preset release-tests --log-level=WARNING
	@cmake --build --preset release-tests -j $(JOBS)
	@for test in $$(find build/folders -name 'canvoy_*_test'); do \
	  echo "== $$test"; RC_PARAMS=max_success=$(CASES) $$test --gtest_brief=1 --gtest_filter='*RapidCheck*' || exit 1; done

# Response times of SETS random message sets: the analysis against the simulated bus, at critical instants and by chance.
response-times:
	@scripts/install-packages test
	@cmake --preset release-tests --log-level=WARNING
	@cmake --build --preset release-tests -j $(JOBS) --target canvoy_timing_test
	@CANVOY_SETS=$(SETS) build/folders/timing/canvoy_timing_test --gtest_brief=1 --gtest_filter='Bounds.*'

# Hours of a world with faults, one for each seed: what must hold is checked at each event. soak-gaps has gaps of 1 ms to
# 3 s in the communication of each world; soak-bus-places each fault of a bus at a terminal, between stops and at one;
# soak-all plays all of these one after the other.
soak-%:
	@scripts/install-packages build
	@cmake --preset release -DCANVOY_SOAK=ON --log-level=WARNING
	@cmake --build --preset release -j $(JOBS) --target canvoy_soak
	@build/canvoy_soak $* $(SEEDS)

# Each sabotage of each world, alone and beside each harmless fault elsewhere: all of them must be found.
sabotage:
	@scripts/install-packages test
	@cmake --preset release-tests --log-level=WARNING
	@cmake --build --preset release-tests -j $(JOBS) --target canvoy_worlds_test
	@CANVOY_TESTS=all build/folders/worlds/canvoy_worlds_test --gtest_brief=1 --gtest_filter='*Sabotage*'

# Breaks the code of FOLDERS in small ways, and says which of them no test notices.
mutate:
	@scripts/install-packages build
	@scripts/mutate $(FOLDERS) --count $(COUNT) --seed $(SEED)

# The same by the hundred, in one build and judged by all unit tests.
mutate-all: FOLDERS = canvoy/canopen canvoy/devices canvoy/formats canvoy/sim canvoy/worlds
mutate-all: COUNT = 200
mutate-all:
	@scripts/install-packages test
	@scripts/mutate $(FOLDERS) --at-once --count $(COUNT) --seed $(SEED)

format:
	@git ls-files '*.cpp' '*.hpp' | xargs clang-format-16 -i

# The source archive of what is committed, at build/dist.
dist:
	@scripts/make-dist

# Whether what is committed can be released: a table of PASS and FAIL.
release-check:
	@scripts/install-packages release
	@scripts/release-check

install: build
	@cmake --install build --prefix $(PREFIX)

clean:
	@rm -rf build
