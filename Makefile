# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Commands for users and developers. Each does its own set-up: missing Debian packages
# are installed first, and only what has changed is built.
.DEFAULT_GOAL := help
.PHONY: help run show pictures test test-quick lint lint-all e2e drifts safety-series kills mutations extremes-asan flips cluster asan tsan bench bench-compare presets trade estimates everything fuzz clean packages

SAMPLE := drift-rebar-dbolt
SHOWN := build/release/$(SAMPLE)

help:
	@echo "make run    build Keyblock and open its window with a drift with rebars and D-bolts, ready for F5; without a display: make show"
	@echo "make show   run the drift on the command line, write figures and an animation, and compare bolts with the paper"
	@echo "make pictures  regenerate the images of the README"
	@echo "make test   build and run all tests"
	@echo "make test-quick  build and run, in less than a minute, the tests without the window and without long runs"
	@echo "make lint   check the format of changed lines, the words of texts, includes, and changed C++ files with clang-tidy, SINCE=commit"
	@echo "make lint-all  the same for all files, without the format"
	@echo "make e2e    test the window with real mouse and keyboard input on a virtual display: draw, bolt, run and export a drift"
	@echo "make drifts run random drifts and check the verdicts against the tables of results, SEED=7 or SEED=1-200"
	@echo "make safety-series  check factors of safety against closed forms: forty scenes, and thirty factors in each"
	@echo "make kills  kill a hundred runs at random moments and stop fifty, resume them and compare the bytes; kill the editor thirty times, and the window thirty times while it edits and runs, and recover the edits"
	@echo "make mutations  resume runs from two thousand checkpoints changed at random, with the address sanitizer"
	@echo "make extremes-asan  run the extremes and two hundred random combinations of them with the address sanitizer, COUNT=200 SEED=1"
	@echo "make flips  read a run store with two hundred single flipped bits, and with values that are not finite, by every command; none may show other numbers"
	@echo "make cluster  run a sweep on a Slurm cluster of two nodes on this machine, kill a case and a node, and compare the bytes; needs root"
	@echo "make asan   run the tests with the address and undefined-behaviour sanitizers"
	@echo "make tsan   run the tests that use several threads with the thread sanitizer"
	@echo "make bench  measure time and memory of typical work; BENCH_JSON=FILE keeps the times of steps, LARGE=1 adds 5,000 blocks and more"
	@echo "make bench-compare  compare two such files, OLD=FILE NEW=FILE WORSE=1.2; fails if a step has become slower"
	@echo "make presets  measure what the presets change and save, and write resources/help/presets.md"
	@echo "make trade  measure accuracy against time of eight samples and the stated errors of presets, and write resources/help/trade.md"
	@echo "make estimates  compare the estimated time of every sample with the measured one, and write the table in resources/help/speed.md"
	@echo "make everything  run six scenes with everything modelled and with what they need only, and write the table in resources/help/speed.md"
	@echo "make fuzz   fuzz the scene reader, or with TARGET=cut|drawing the cut or the import, MINUTES=60"
	@echo "make clean  remove everything that was built"

packages:
	@sh resources/install/debian.sh

# build(preset, options of CMake)
define build
	@cmake --preset $(1) $(2) --log-level=WARNING
	@cmake --build --preset $(1)
endef

run: packages
	$(call build,release)
	@if [ -n "$$DISPLAY$$WAYLAND_DISPLAY" ] && [ -x build/release/keyblock-studio ]; then \
	    echo build/release/keyblock-studio samples/$(SAMPLE).json; \
	    exec build/release/keyblock-studio samples/$(SAMPLE).json; \
	else $(MAKE) --no-print-directory show; fi

# `make run` without a display.
show: packages
	$(call build,release)
	build/release/keyblock run samples/$(SAMPLE).json --overwrite --out $(SHOWN).kbrun
	build/release/keyblock info $(SHOWN).kbrun
	build/release/keyblock export $(SHOWN).kbrun --figure section --overwrite --out $(SHOWN).pdf
	build/release/keyblock export $(SHOWN).kbrun --figure section --overwrite --out $(SHOWN).png
	build/release/keyblock export $(SHOWN).kbrun --figure bolt --bolt R1 --at pressure:0.1 --overwrite --out $(SHOWN)-bolt.pdf
	build/release/keyblock export $(SHOWN).kbrun --figure curves --overwrite --out $(SHOWN)-curves.pdf
	@if command -v ffmpeg >/dev/null; then \
	    echo build/release/keyblock export $(SHOWN).kbrun --animation $(SHOWN).mp4; \
	    build/release/keyblock export $(SHOWN).kbrun --animation $(SHOWN).mp4; \
	else echo "ffmpeg is not installed; skipping the animation of the drift"; fi
	build/release/keyblock verify --paper
	@echo "Figures of the drift, and an animation if ffmpeg is installed:"
	@ls $(SHOWN)*.pdf $(SHOWN)*.png $(SHOWN)*.mp4 2>/dev/null || true

pictures: packages
	@sh resources/install/debian.sh readers desktop ffmpeg
	$(call build,release)
	@sh resources/pictures/make.sh build/release/keyblock
	@sh resources/pictures/studio.sh build/release/keyblock-studio

# With CI set in the environment a skipped test fails, and the files of the programs are compiled together as in the
# release build, so that names that clash only there are found.
test:
	@sh resources/install/debian.sh readers
	$(call build,dev,$(if $(CI),-D KEYBLOCK_BATCH=24))
	@ctest --preset dev --output-junit tests.xml
	@skipped=$$(sed -n 's/.*<testcase name="\([^"]*\)".* status="notrun".*/\1/p' build/dev/tests.xml); \
	if [ -n "$$CI" ] && [ -n "$$skipped" ]; then echo "These tests were skipped:"; echo "$$skipped"; exit 1; fi

test-quick: packages
	@cmake --preset dev --log-level=WARNING
	@cmake --build --preset quick
	@ctest --preset quick

lint lint-all:
	@sh resources/install/debian.sh lint
	@cmake --preset dev --log-level=WARNING
	@cmake --build --preset lint
	@cmake --preset dev -B build/lint -DKEYBLOCK_UNITY=OFF --log-level=WARNING  # a compile command for each file
	@sh tests/lint/lint.sh build/dev build/lint $(if $(filter lint-all,$@),all,"$(SINCE)")

e2e: packages
	@sh resources/install/debian.sh readers desktop
	$(call build,release)
	/usr/bin/python3 tests/e2e/drift.py build/release/keyblock-studio build/release/e2e

drifts: packages
	$(call build,release)
	/usr/bin/python3 tests/drifts/drifts.py $(or $(SEED),1-20) --out build/release/drifts
	/usr/bin/python3 tests/drifts/prove.py build/release/keyblock build/release/drifts $(or $(SEED),1-20)

safety-series: packages
	$(call build,release)
	/usr/bin/python3 tests/safety/series.py build/release/keyblock --out build/release/safety-series
	/usr/bin/python3 tests/safety/series.py build/release/keyblock --out build/release/safety-series --monotone

kills: packages
	$(call build,dev)
	KEYBLOCK_KILLS=100 KEYBLOCK_STOPS=50 build/dev/tests/cli_tests --gtest_filter='Kills.*'
	@if [ -x build/dev/tests/ui_document_tests ]; then \
	    KEYBLOCK_KILLS=30 build/dev/tests/ui_document_tests --gtest_filter='JournalKills.*'; fi
	@if [ -x build/dev/keyblock-studio ]; then \
	    sh resources/install/debian.sh readers desktop; \
	    /usr/bin/python3 tests/e2e/kills.py build/dev/keyblock-studio build/dev/keyblock samples 30; fi

mutations:
	@sh resources/install/debian.sh readers
	@cmake --preset asan --log-level=WARNING
	@cmake --build --preset asan --target checkpoint_mutations
	KEYBLOCK_MUTATIONS=$(or $(COUNT),2000) build/asan/tests/checkpoint_mutations --gtest_filter='CheckpointCheck.*AtRandom'

extremes-asan: packages
	@cmake --preset asan --log-level=WARNING
	@cmake --build --preset asan --target keyblock
	ASAN_OPTIONS=detect_leaks=0 build/asan/keyblock verify --extremes --random $(or $(COUNT),200) --seed $(or $(SEED),1)

flips:
	@sh resources/install/debian.sh python3-xxhash
	$(call build,release)
	build/release/keyblock run samples/drop-d-bolt.json --overwrite --out build/release/flips.kbrun
	/usr/bin/python3 tests/flips/flips.py build/release/keyblock build/release/flips.kbrun --flips $(or $(COUNT),200)
	/usr/bin/python3 tests/flips/not_finite.py build/release/keyblock build/release/flips.kbrun

# Slurm starts jobs as root; without root nothing is installed or built.
cluster:
	@if [ "$$(id -u)" -ne 0 ]; then echo "the cluster needs root: slurmd starts jobs for their users" >&2; exit 2; fi
	@sh resources/install/debian.sh slurm
	$(call build,release)
	/usr/bin/python3 tests/cluster/cluster.py build/release/keyblock --cases $(or $(CASES),100)

asan tsan:
	@sh resources/install/debian.sh readers
	$(call build,$@)
	@ctest --preset $@

bench:
	@sh resources/install/debian.sh python3
	$(call build,headless)
	build/headless/tests/bench/keyblock_bench
	build/headless/tests/bench/keyblock_increments_bench
	/usr/bin/python3 tests/bench/speed/speed.py measure build/headless/tests/bench/keyblock_speed_bench \
	    $(if $(BENCH_JSON),--json $(BENCH_JSON)) $(if $(LARGE),--large)

bench-compare:
	@/usr/bin/python3 tests/bench/speed/speed.py compare $(OLD) $(NEW) --worse $(or $(WORSE),1.2)

presets:
	@sh resources/install/debian.sh python3
	$(call build,release)
	/usr/bin/python3 tests/presets/presets.py measure build/release/keyblock --json build/release/presets.json
	/usr/bin/python3 tests/presets/presets.py stiffness build/release/keyblock --json build/release/stiffness.json
	/usr/bin/python3 tests/presets/presets.py page build/release/presets.json build/release/stiffness.json resources/help/presets.md

trade:
	@sh resources/install/debian.sh python3
	$(call build,release)
	/usr/bin/python3 tests/trade/trade.py measure build/release/keyblock --out build/release/trades
	/usr/bin/python3 tests/presets/truth.py measure build/release/keyblock --json build/release/truth.json
	/usr/bin/python3 tests/trade/trade.py page build/release/trades resources/help/trade.md --truth build/release/truth.json

estimates:
	@sh resources/install/debian.sh python3
	$(call build,release)
	/usr/bin/python3 tests/estimates/estimates.py measure build/release/keyblock --json build/release/estimates.json
	/usr/bin/python3 tests/estimates/estimates.py page build/release/estimates.json resources/help/speed.md

everything:
	@sh resources/install/debian.sh python3
	$(call build,release)
	/usr/bin/python3 tests/everything/everything.py measure build/release/keyblock --json build/release/everything.json
	/usr/bin/python3 tests/everything/everything.py page build/release/everything.json resources/help/speed.md

MINUTES ?= 60
TARGET ?= scene
fuzz:
	@sh resources/install/debian.sh clang
	$(call build,fuzz)
	@sh tests/fuzz/fuzz.sh $(TARGET) $(MINUTES)

clean:
	rm -rf build
