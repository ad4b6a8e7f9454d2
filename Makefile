# The project's commands. Everything is built in build/ by CMake and Ninja; `make` alone explains.
# SPDX-License-Identifier: Apache-2.0
.DEFAULT_GOAL := help
.NOTPARALLEL:
.PHONY: help sim web hwffd glapi plates mass-spring soc synth synth-check synth-baseline structure boards pnr docs test test-all test-synth fuzz random lint clean

# A build with waveforms is one of its own, so that the ordinary one stays as it is.
tracing =
sim: tracing = $(filter-out 0,$(call given,TRACE))
BUILD  = build
sim: BUILD = $(if $(tracing),build-trace,build)
SOURCE = .
TIER  ?= test
include tools/options.mk

SIM_OPTIONS   := model:MODEL deform:DEFORM lattice:LATTICE org:ORG format:FORMAT \
                 schedule:SCHEDULE stream:STREAM seed:SEED
SYNTH_OPTIONS := target:TARGET org:ORG n:N format:FORMAT set:SET
$(call exported,prefix:PREFIX board:BOARD $(sort $(SIM_OPTIONS) $(SYNTH_OPTIONS)))
SIM_ARGUMENTS   = $(call arguments,$(SIM_OPTIONS)) $(if $(tracing),--trace)
SYNTH_ARGUMENTS = $(call arguments,$(SYNTH_OPTIONS))

# What measures and proves is lab/, with a Makefile of its own. What the paper's users call is called here too.
FORWARDED = organizations words streams formal compare
MOVED     = bfp tangents embed energy coverage engines mutants upsets theorems bounds testfloat soak workflow figures results
.PHONY: $(FORWARDED) $(MOVED)
ifeq ($(wildcard lab/Makefile),)
$(FORWARDED) $(MOVED):
	@echo 'make: $@: a command of the laboratory, and lab/ is not here' >&2; exit 2
else
$(FORWARDED):
	@$(MAKE) --no-print-directory -f lab/Makefile $@
$(MOVED):
	@echo 'make: $@ has moved: make -C lab $@' >&2; exit 2
endif

help:
	@echo 'Use it'
	@echo '  make sim            deform a mesh on the simulated hardware and compare every bit with the model'
	@echo '  make web            a page for the browser: a mesh deformed live by simulated cores, and a look inside'
	@echo '  make hwffd          the command hwffd, the library, the Python module; PREFIX= installs them'
	@echo '  make plates         the ten plates of the paper, drawn from the simulated hardware'
	@echo '  make mass-spring    an example: a mesh in a lattice of masses and springs'
	@echo '  make soc            a processor deforms a mesh through the core: LiteX, simulated; BOARD=ulx3s routes it'
	@echo '  make glapi          the OpenGL calls and their errors, beside those of Mesa'
	@echo '  make clean          remove build/ and build-trace/'
	@echo 'Check it'
	@echo '  make test           build the tests and run them'
	@echo '  make test-all       every configuration, and the long tests'
	@echo '  make test-synth     what yosys makes of the RTL: the scripts of synthesis, a netlist in simulation'
	@echo '  make fuzz           readers of files on broken input, under sanitizers'
	@echo '  make lint           Verilator, Icarus, yosys, clang, ruff and text rules, and the tests of these checks'
	@echo '  make random         N= cores of random parameters on random packets, from SEED= on'
	@echo 'Build hardware'
	@echo '  make synth          size on FPGAs and in standard cells, by yosys (half an hour)'
	@echo '  make synth-check    whether size or depth has grown over synth/baseline.csv'
	@echo '  make synth-baseline write that file anew'
	@echo '  make structure      the tops as trees of modules, with the size of each'
	@echo '  make pnr            clocks after place and route with nextpnr (an hour)'
	@echo '  make boards         bitstreams for ULX3S and iCEBreaker'
	@echo 'Measure and prove it (make -C lab has the others)'
	@echo '  make organizations  what organizations of the arithmetic cost in clock cycles and operators'
	@echo '  make words          how many bits fixed point needs: errors measured and proved'
	@echo '  make streams        how many words must be moved for each vertex'
	@echo '  make compare        vertices a second beside other programs, on one core and in hardware'
	@echo '  make formal         unbounded proofs of control and transport, each with a planted bug'
	@echo 'Read it'
	@echo '  make docs           the texts as a site with search and the reference of the libraries'
	@echo
	@echo 'JOBS=$(JOBS) processes side by side. docs/commands.md has all variables.'

# The rows that it runs: those of the smallest tier that has what it is asked for.
sim: TIER = $(or $(call given,TIER),$$(python3 -B -m tools.tables.configurations tier --top $(SIM_TOP) $(SIM_ROWS)))
SIM_TOP  = $(if $(filter dma,$(call given,STREAM)),axi,stream)
SIM_ROWS = $(call arguments,org:ORG format:FORMAT schedule:SCHEDULE)
sim:
	$(INSTALL) build
	$(call numbers,SEED)
	@case "$$HWFFD_GIVEN_STREAM" in ''|interleaved|resident|dma) ;; *) \
	  echo "make: STREAM=$$HWFFD_GIVEN_STREAM: one of interleaved, resident, dma" >&2; exit 2 ;; esac
	@python3 -B -m tools.tables.configurations list --tier $(TIER) --top $(SIM_TOP) $(SIM_ROWS) >/dev/null
	$(CONFIGURE)
	$(COMPILE) --target hwffd-sim
	@$(BUILD)/tb/hwffd-sim $(SIM_ARGUMENTS)

# One file, build/web/index.html, and its test in a browser, which measures it.
web:
	$(INSTALL) build web
	$(CONFIGURE)
	$(COMPILE) --target hwffd-web-engine hwffd-web-plates
	@$(BUILD)/apps/hwffd-web-plates $(BUILD)/web/plates.json
	@$(BUILD)/venv/bin/python -B -m apps.web.bundle --engine $(BUILD)/web/engine \
	  --plates $(BUILD)/web/plates.json --output $(BUILD)/web/index.html
	@$(BUILD)/venv/bin/python -B -m pytest --quiet tests/web/test_page.py \
	  --argument=$(BUILD)/web/index.html
	@python3 -B -m tools.reports.show web

# The simulated hardware in it is that of tier sim, unless TIER= says more. That PREFIX can be written is known first.
hwffd plates mass-spring: TIER = sim
hwffd:
	$(INSTALL) build module
	@$(if $(call given,PREFIX),mkdir -p "$$HWFFD_GIVEN_PREFIX" 2>/dev/null && test -w "$$HWFFD_GIVEN_PREFIX" || \
	  { echo "make: PREFIX=$$HWFFD_GIVEN_PREFIX: cannot be written: take a folder of your own" >&2; exit 2; })
	$(CONFIGURE)
	$(COMPILE) --target hwffd_installed
	@$(if $(call given,PREFIX),cmake --install $(BUILD) --prefix "$$(cd "$$HWFFD_GIVEN_PREFIX" && pwd)", \
	  echo 'built build/apps/hwffd; to install it: make hwffd PREFIX=/usr/local')

plates:
	$(INSTALL) build
	$(CONFIGURE)
	$(COMPILE) --target hwffd-plates
	@$(BUILD)/apps/hwffd-plates

mass-spring:
	$(INSTALL) build
	$(CONFIGURE)
	$(COMPILE) --target hwffd-example-mass-spring
	@$(BUILD)/examples/hwffd-example-mass-spring

# On a board it is placed and routed, else simulated.
soc: TIER = sim
ROUTE = $(if $(call given,BOARD),route)
soc:
	$(INSTALL) soc $(ROUTE)
	$(CONFIGURE)
	$(COMPILE) --target hwffd-soc-scene
	@$(BUILD)/venv/bin/python -B -m soc$(if $(call given,BOARD),.route,.simulate) -j $(JOBS) \
	  --maker $(BUILD)/soc/hwffd-soc-scene $(call arguments,board:BOARD model:MODEL deform:DEFORM lattice:LATTICE)

glapi:
	$(INSTALL) build module
	$(CONFIGURE)
	$(COMPILE) --target hwffd_rtl hwffd_gl_shared hwffd_python
	@env PYTHONPATH=$(BUILD)/api/python $(BUILD)/venv/bin/python -B tests/gl/glapi.py --output $(BUILD)
	@python3 -B -m tools.reports.show glapi

# Standard cells are one of the targets.
CELLS = $(if $(filter-out osu018,$(call given,TARGET)),,cells)
synth:
	$(INSTALL) engine $(CELLS)
	@python3 -B -m tools.synth -j $(JOBS) $(SYNTH_ARGUMENTS)

synth-check:
	$(INSTALL) engine $(CELLS)
	@python3 -B -m tools.synth.synth_baseline check -j $(JOBS) $(call arguments,target:TARGET org:ORG n:N format:FORMAT)

synth-baseline:
	$(INSTALL) engine cells
	@python3 -B -m tools.synth.synth_baseline write -j $(JOBS)

structure:
	$(INSTALL) engine
	@python3 -B -m tools.synth.structure -j $(JOBS)

# The texts as a site, with what `make web` has made.
docs:
	$(INSTALL) docs
	@$(BUILD)/venv/bin/python -B -m apps.docs

pnr:
	$(INSTALL) route
	@python3 -B -m tools.synth.pnr -j $(JOBS) $(call arguments,target:TARGET org:ORG n:N format:FORMAT)

boards:
	$(INSTALL) route
	@python3 -B -m tools.synth.bitstreams -j $(JOBS) $(call arguments,board:BOARD)

test: override TIER = test
test:
	$(INSTALL) test
	$(CONFIGURE)
	$(COMPILE)
	@$(call run_tests,tests) -L '^test$$'

test-all: override TIER = all
test-all:
	$(INSTALL) test-all
	$(CONFIGURE)
	$(COMPILE)
	@$(call run_tests,tests) -L '^(test|all|synth|fuzz|lint)$$'

test-synth:
	$(INSTALL) test-synth
	$(CONFIGURE)
	$(COMPILE) --target hwffd_test_synth
	@$(call run_tests,test-synth) -L '^synth$$'

# Not beside the tests: readers are compiled a second time, for the sanitizers.
fuzz:
	$(INSTALL) build
	$(CONFIGURE)
	$(COMPILE) --target hwffd_fuzz
	@$(call run_tests,fuzz) -L '^fuzz$$'

random:
	$(INSTALL) build engines
	$(call numbers,N SEED)
	$(CONFIGURE)
	$(COMPILE) --target hwffd-random-words
	@python3 -B -m tests.random --words $(BUILD)/tests/random/hwffd-random-words --folder $(BUILD)/random \
	  --count $(or $(call given,N),20) $(addprefix --seed ,$(call given,SEED))

lint:
	$(INSTALL) build lint
	$(CONFIGURE)
	@python3 -B -m tools.checks.lint -j $(JOBS)
	@$(call run_tests,lint) -L '^lint$$'

clean:
	@rm -rf build build-trace
