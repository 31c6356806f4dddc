# Short names for what CMake does. `make`, `make demo` and `make test` install what is missing first (Debian 12, as root).

JOBS ?= $(shell nproc)
PREFIX ?= /usr/local
FUZZ_SECONDS ?= 3600
SEEDS ?= 1000
FOLDERS ?= canvoy/devices/cia419
COUNT ?= 20
CASES ?= 20000
SEED ?= 1

.PHONY: build demo docs test check test-all tidy bench bench-page fuzz properties soak-lift soak-charger soak-taxi soak-police soak-bus soak-excavator soak-gaps mutate mutate-all format install clean

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
	@CANVOY=build/canvoy NO_MKDOCS_2_WARNING=1 build/docs/venv/bin/mkdocs build --strict
	@echo "build/docs/site/index.html"

build/docs/venv/installed: docs/requirements.txt
	@scripts/install-packages docs
	@python3 -m venv build/docs/venv
	@build/docs/venv/bin/pip install --quiet --requirement docs/requirements.txt
	@touch $@

# Each test once: the command, strangers and embedding by the release, unit tests with sanitizers, fuzzing, style.
test:
	@scripts/install-packages test
	@JOBS=$(JOBS) scripts/run-tests test

# Before each commit: the command, unit tests of the lower libraries, a run of each world.
check:
	@scripts/install-packages check
	@JOBS=$(JOBS) scripts/run-tests check

# Before each release: all tests in both builds, long runs, long fuzzing, clang-tidy on all sources.
test-all:
	@scripts/install-packages test
	@JOBS=$(JOBS) scripts/run-tests all

# clang-tidy on all sources; notes the commit from which on `make test` looks at what has changed.
tidy:
	@scripts/install-packages test
	@cmake --preset release --log-level=WARNING
	@tests/style/clang_tidy build/compile_commands.json --record

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

# Properties in CASES cases by chance; the tests have the same hundred of them each time.
properties:
	@scripts/install-packages test
	@cmake --preset release-tests --log-level=WARNING
	@cmake --build --preset release-tests -j $(JOBS)
	@for test in $$(find build/folders -name 'canvoy_*_test'); do \
	  echo "== $$test"; RC_PARAMS=max_success=$(CASES) $$test --gtest_brief=1 --gtest_filter='*RapidCheck*' || exit 1; done

# Hours of lifts with faults, one for each seed: what must hold is checked at each event.
soak-lift:
	@scripts/install-packages bench
	@cmake --preset bench --log-level=WARNING
	@cmake --build --preset bench -j $(JOBS) --target canvoy_soak_lift
	@build/bench/canvoy_soak_lift $(SEEDS)

# The same for a charger and its battery.
soak-charger:
	@scripts/install-packages bench
	@cmake --preset bench --log-level=WARNING
	@cmake --build --preset bench -j $(JOBS) --target canvoy_soak_charger
	@build/bench/canvoy_soak_charger $(SEEDS)

# The same for shifts of a taxi.
soak-taxi:
	@scripts/install-packages bench
	@cmake --preset bench --log-level=WARNING
	@cmake --build --preset bench -j $(JOBS) --target canvoy_soak_taxi
	@build/bench/canvoy_soak_taxi $(SEEDS)

# The same for patrols of a police car.
soak-police:
	@scripts/install-packages bench
	@cmake --preset bench --log-level=WARNING
	@cmake --build --preset bench -j $(JOBS) --target canvoy_soak_police
	@build/bench/canvoy_soak_police $(SEEDS)

# The same for days of a bus.
soak-bus:
	@scripts/install-packages bench
	@cmake --preset bench --log-level=WARNING
	@cmake --build --preset bench -j $(JOBS) --target canvoy_soak_bus
	@build/bench/canvoy_soak_bus $(SEEDS)

# The same of shifts of an excavator.
soak-excavator:
	@scripts/install-packages bench
	@cmake --preset bench --log-level=WARNING
	@cmake --build --preset bench -j $(JOBS) --target canvoy_soak_excavator
	@build/bench/canvoy_soak_excavator $(SEEDS)

# Gaps of 1 ms to 3 s in the communication of each world.
soak-gaps:
	@scripts/install-packages bench
	@cmake --preset bench --log-level=WARNING
	@cmake --build --preset bench -j $(JOBS) --target canvoy_soak_gaps
	@build/bench/canvoy_soak_gaps $(SEEDS)

# Breaks the code of FOLDERS in small ways, and says which of them no test notices.
mutate:
	@scripts/install-packages build
	@scripts/mutate $(FOLDERS) --count $(COUNT) --seed $(SEED)

# The same by the hundred, in one build and judged by all unit tests.
mutate-all: FOLDERS = canvoy/canopen canvoy/devices canvoy/formats canvoy/sim
mutate-all: COUNT = 200
mutate-all:
	@scripts/install-packages test
	@scripts/mutate $(FOLDERS) --at-once --count $(COUNT) --seed $(SEED)

format:
	@git ls-files '*.cpp' '*.hpp' | xargs clang-format-16 -i

install: build
	@cmake --install build --prefix $(PREFIX)

clean:
	@rm -rf build
