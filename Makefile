# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause

# The commands of the README. Each installs what it lacks, if it may.
BUILD := build
JOBS := $(shell nproc)
CMAKE_ARGUMENTS :=
FUZZ_SECONDS := 600
TORTURE_PAIRS := 3000
SANITIZERS := address,undefined

PREFIX := /usr/local

.PHONY: build test demo bench memory fuzz sanitize torture gui install package screenshots format clean dependencies

build: dependencies
	@cmake -G Ninja -S . -B $(BUILD) -DCMAKE_BUILD_TYPE=Release $(CMAKE_ARGUMENTS) > $(BUILD)-configure.log 2>&1 \
	  || { cat $(BUILD)-configure.log; exit 1; }
	@mv $(BUILD)-configure.log $(BUILD)/configure.log
	@cmake --build $(BUILD) -j $(JOBS)
	@echo "Built. To use it: . $(BUILD)/env.sh && pvpython script.py, or: make gui"

test: build
	@ctest --test-dir $(BUILD) -j $(JOBS) --output-on-failure \
	  && echo "PASSED: all tests." || { echo "FAILED: see the tests listed above."; exit 1; }

demo: build
	@. $(BUILD)/env.sh && xvfb-run -a -s "-noreset" pvpython Python/demo.py "$(BUILD)/demo"
	@. $(BUILD)/env.sh && xvfb-run -a -s "-noreset" pvpython Python/demo_scan.py "$(BUILD)/demo"

bench: build
	@. $(BUILD)/env.sh && Testing/Benchmarks/run.sh

memory: build
	@. $(BUILD)/env.sh && /usr/bin/python3 Testing/Benchmarks/memory.py

fuzz:
	@BUILD=$(BUILD) Testing/Fuzz/run.sh $(FUZZ_SECONDS)

sanitize:
	@BUILD=$(BUILD) Testing/Sanitizers/run.sh $(SANITIZERS)

torture: build
	@. $(BUILD)/env.sh && Testing/Filters/torture.sh "$(BUILD)/torture-venv" --pairs $(TORTURE_PAIRS)

gui: build
	@. $(BUILD)/env.sh && paraview --plugin-search-paths="$$PV_PLUGIN_PATH" --plugins=SurfaceBooleans

screenshots: demo
	@. $(BUILD)/env.sh && BUILD=$(BUILD) Screenshots/gallery.sh

install: build
	@cmake --install $(BUILD) --prefix "$(PREFIX)" > $(BUILD)/install.log
	@echo "Installed. To use it: . $(PREFIX)/share/surfacebooleans/env.sh"

package: build
	@cpack --config $(BUILD)/CPackConfig.cmake > $(BUILD)/package.log 2>&1 || { cat $(BUILD)/package.log; exit 1; }
	@echo "To install it: apt-get install ./$$(ls -t $(BUILD)/package/*.deb | head -n 1)"

format:
	@find Filters Testing Plugin \( -name '*.h' -o -name '*.cxx' \) -exec clang-format -i {} +

clean:
	@rm -rf $(BUILD)

dependencies:
	@Testing/install-dependencies.sh
