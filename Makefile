# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# A thin face on the CMake presets and scripts/.

.DEFAULT_GOAL := help
.NOTPARALLEL:
.PHONY: help build demo test app wheel windows examples bench reference docs lint format sanitize fuzz hostile nightly clean
.SILENT: help

configure := cmake --log-level=WARNING
programs := taut_programs
link_programs := for name in taut taut-mpi; do \
	! test -e build/release/apps/$$name/$$name || ln -sfn release/apps/$$name/$$name build/$$name; done

help: ## list the targets
	awk -F ':.*## ' '/^[a-z]+:.*## / {printf "make %-10s %s\n", $$1, $$2}' $(MAKEFILE_LIST)

# An existing configuration is kept, so that `make build` does not undo what `make test` set up.
build: ## install what is missing, build the release; leaves the programs at build/taut and, with MPI, build/taut-mpi
	scripts/install_dependencies.sh build
	test -f build/release/build.ninja || $(configure) --preset release -DTAUT_BUILD_TESTS=OFF
	cmake --build --preset release --target $(programs)
	$(link_programs)

demo: programs := taut_app
demo: build ## run the paper's experiment and plan a job on the built-in net, reports in build/demo
	scripts/demo.sh

test: ## install what is missing, build, run every test
	scripts/install_dependencies.sh test python
	$(configure) --preset release -DTAUT_BUILD_TESTS=ON
	cmake --build --preset release
	$(link_programs)
	ctest --preset release
	scripts/python.sh test

app: ## build the program as one page for browsers, build/app/taut.html
	scripts/install_dependencies.sh build python
	scripts/app.sh

wheel: app ## build wheels of the Python package for other machines, with all libraries in them, in build/python/wheels
	scripts/install_dependencies.sh build python
	scripts/wheels.sh

windows: build ## build the program and Python wheels for Windows, in build/windows, and try them with Wine
	scripts/install_dependencies.sh python windows
	scripts/windows.sh
	scripts/check_windows.sh

examples: ## build and run the examples
	scripts/install_dependencies.sh build examples
	test -f build/release/build.ninja || $(configure) --preset release -DTAUT_BUILD_TESTS=OFF
	$(configure) --preset release -DTAUT_BUILD_EXAMPLES=ON
	cmake --build --preset release --target taut_examples
	ctest --preset examples

bench: ## run the benchmarks
	scripts/install_dependencies.sh bench
	scripts/bench.sh

reference: ## build the API reference in build/reference
	scripts/install_dependencies.sh reference
	scripts/reference.sh

docs: build reference ## build the site of docs/ in build/site
	scripts/install_dependencies.sh build python reference
	scripts/docs.sh

lint: ## check format, rooms, licence lines, and names and bugs in what has changed
	scripts/install_dependencies.sh lint
	scripts/lint.sh

format: ## format all C++ sources in place
	scripts/install_dependencies.sh lint
	scripts/format.sh

sanitize: ## run the tests with the address and undefined behaviour sanitizers
	scripts/install_dependencies.sh test fuzz
	scripts/sanitize.sh

fuzz: build ## feed the readers damaged files, SECONDS=600 each
	scripts/install_dependencies.sh fuzz
	scripts/fuzz.sh $(or $(SECONDS),600)

hostile: build ## hostile inputs, surroundings and faults, SECONDS=3600 of them, counts into docs/reliability.md
	scripts/install_dependencies.sh hostile
	/usr/bin/python3 tests/hostile/run.py --program build/taut --every-fault --keep --write --seconds $(or $(SECONDS),3600)

nightly: ## what .ci/run leaves out for time; a release needs it
	scripts/nightly.sh $(SECONDS)

clean: ## remove the build folder
	rm -rf build
