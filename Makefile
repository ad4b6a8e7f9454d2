# The project's commands. Everything is built in build/ by CMake and Ninja; `make` alone explains.
# SPDX-License-Identifier: Apache-2.0
.DEFAULT_GOAL := help
.NOTPARALLEL:
.PHONY: help sim organizations bfp streams words tangents embed hwffd glapi plates mass-spring synth synth-check synth-baseline docs boards pnr formal test test-all soak lint clean install

# A build with waveforms is one of its own, so that the ordinary one stays as it is.
tracing = $(filter-out 0,$(call given,TRACE))
BUILD   = build
sim: BUILD = $(if $(tracing),build-trace,build)
JOBS  ?= $(shell nproc 2>/dev/null || echo 2)
TIER  ?= test

CMAKE_CONFIGURE = cmake -S . -B $(BUILD) -G Ninja --log-level=NOTICE
CMAKE_BUILD     = cmake --build $(BUILD) -j $(JOBS)
CTEST           = ctest --test-dir $(BUILD) --no-tests=error --output-on-failure -j $(JOBS)

# Variables of `make sim` and `make synth`, handed on as --model X and so on. Only those given on
# make's command line count, not those that happen to be in the environment. They travel as they
# are, in HWFFD_GIVEN_*, so that neither make nor the shell reads anything into a blank, a quote or
# a dollar.
SIM_OPTIONS   := model:MODEL deform:DEFORM lattice:LATTICE org:ORG format:FORMAT \
                 schedule:SCHEDULE stream:STREAM seed:SEED
SYNTH_OPTIONS := target:TARGET org:ORG n:N format:FORMAT set:SET
option_of   = $(firstword $(subst :, ,$1))
variable_of = $(lastword $(subst :, ,$1))
given       = $(and $(findstring command line,$(origin $1)),$(value $1))
ORGANIZATIONS_OPTIONS := org:ORG n:N format:FORMAT
OPTIONS     := prefix:PREFIX board:BOARD $(sort $(SIM_OPTIONS) $(SYNTH_OPTIONS) $(ORGANIZATIONS_OPTIONS))

$(foreach o,$(OPTIONS),$(eval export HWFFD_GIVEN_$(call variable_of,$o) := \
  $$(value $(call variable_of,$o))))
unexport $(foreach o,$(OPTIONS),$(call variable_of,$o))

arguments = $(foreach o,$1,$(if $(call given,$(call variable_of,$o)), \
  --$(call option_of,$o) "$$HWFFD_GIVEN_$(call variable_of,$o)"))
SIM_ARGUMENTS   = $(call arguments,$(SIM_OPTIONS)) $(if $(tracing),--trace)
SYNTH_ARGUMENTS = $(call arguments,$(SYNTH_OPTIONS))

help:
	@echo 'make sim       deform a mesh on the simulated RTL, compare every bit with the golden model'
	@echo '               MODEL= DEFORM= LATTICE= ORG= FORMAT= SCHEDULE= STREAM= SEED= TRACE=1'
	@echo 'make organizations  every organization: clocks against the formulas, operators, errors, seams'
	@echo '               ORG= N= FORMAT=; table, pictures, JSON'
	@echo 'make bfp       block floating point: error, measured and proved; bits of every organization'
	@echo '               ORG= N=; table, JSON (minutes)'
	@echo 'make streams   words moved by arrangements of the control points: table, plot, JSON'
	@echo 'make tangents  derivatives and det J out of the simulated RTL, against oracle and differences'
	@echo 'make words     error of every word length, measured and proved: table, plot, JSON (minutes)'
	@echo 'make embed     meshes in box, cylinder, sphere and custom lattices: table, JSON'
	@echo 'make hwffd     the command hwffd, the library and its Python module; PREFIX= installs them'
	@echo 'make plates    the ten plates of the paper as pictures, their vertices from the simulated RTL'
	@echo 'make mass-spring  a mesh in a lattice of masses and springs, as meshes and a picture'
	@echo 'make glapi     every OpenGL call, and its errors beside those of Mesa: table, JSON'
	@echo 'make synth     what organizations cost: LUTs, flip-flops, multipliers, memories, by yosys'
	@echo '               TARGET= ORG= N= FORMAT= SET=ci (a subset of two minutes)'
	@echo 'make synth-check  whether area or depth has grown by 3 % over synth/baseline.csv; make'
	@echo '               synth-baseline writes that file'
	@echo 'make docs      module hierarchy of the tops as pictures, the datasheet with its figures (minutes)'
	@echo 'make pnr       places and routes rows on ECP5 and iCE40, three seeds: clocks (an hour)'
	@echo '               TARGET= ORG= N= FORMAT='
	@echo 'make boards    bitstreams of ULX3S and iCEBreaker: what of the chip is used, clock after routing'
	@echo '               BOARD=ulx3s or icebreaker'
	@echo 'make formal    unbounded proofs of handshakes, buses and control; each finds a planted bug'
	@echo 'make test      build everything and run the tests'
	@echo 'make test-all  every configuration of the table, and the long tests'
	@echo 'make soak      mixed good and bad traffic through hwffd_axi, SEEDS= of them (100; minutes)'
	@echo 'make lint      every module and configuration through Verilator, Icarus, yosys; no warning is allowed'
	@echo 'make clean     remove build/ and build-trace/'
	@echo
	@echo 'JOBS=$(JOBS)              processes side by side'
	@echo 'TIER=$(TIER)           configurations that sim builds: sim, test or all'
	@echo 'HWFFD_NO_INSTALL=1  say which packages are missing instead of installing them'

install:
	@scripts/install

sim: install
	@$(CMAKE_CONFIGURE) -DHWFFD_TIER=$(TIER) -DHWFFD_TRACE=$(if $(tracing),ON,OFF)
	@$(CMAKE_BUILD) --target hwffd-sim
	@$(BUILD)/apps/hwffd-sim $(SIM_ARGUMENTS)

# Only the rows selected are verilated. The names are checked before they reach CMake.
organizations: install
	@scripts/configurations.py list $(call arguments,$(ORGANIZATIONS_OPTIONS)) >/dev/null
	@$(CMAKE_CONFIGURE) $(foreach v,ORG N FORMAT,-DHWFFD_$v="$(if $(call given,$v),$$HWFFD_GIVEN_$v)")
	@$(CMAKE_BUILD) --target hwffd-organizations
	@$(BUILD)/apps/hwffd-organizations

# The same selection, of one format; ORG= and N= narrow it.
bfp: install
	@scripts/configurations.py list --format bfp32 $(call arguments,org:ORG n:N) >/dev/null
	@$(CMAKE_CONFIGURE) $(foreach v,ORG N,-DHWFFD_$v="$(if $(call given,$v),$$HWFFD_GIVEN_$v)") -DHWFFD_FORMAT=bfp32
	@$(CMAKE_BUILD) --target hwffd-bfp
	@$(BUILD)/apps/hwffd-bfp

streams: install
	@$(CMAKE_CONFIGURE) -DHWFFD_TIER=$(TIER)
	@$(CMAKE_BUILD) --target hwffd-streams
	@$(BUILD)/apps/hwffd-streams

words: install
	@$(CMAKE_CONFIGURE) -DHWFFD_TIER=$(TIER)
	@$(CMAKE_BUILD) --target hwffd-words
	@$(BUILD)/apps/hwffd-words

tangents: install
	@$(CMAKE_CONFIGURE) -DHWFFD_TIER=$(TIER)
	@$(CMAKE_BUILD) --target hwffd-tangents
	@$(BUILD)/apps/hwffd-tangents

embed: install
	@$(CMAKE_CONFIGURE) -DHWFFD_TIER=$(TIER)
	@$(CMAKE_BUILD) --target hwffd-embed
	@$(BUILD)/apps/hwffd-embed

hwffd: install
	@scripts/python_env
	@$(CMAKE_CONFIGURE) -DHWFFD_TIER=$(TIER)
	@$(CMAKE_BUILD) --target hwffd hwffd_gl_shared hwffd-command hwffd_python
	@$(if $(call given,PREFIX),cmake --install $(BUILD) --prefix "$$HWFFD_GIVEN_PREFIX", \
	  echo 'built build/apps/hwffd; to install it: make hwffd PREFIX=/usr/local')

plates: install
	@$(CMAKE_CONFIGURE) -DHWFFD_TIER=$(TIER)
	@$(CMAKE_BUILD) --target hwffd-plates
	@$(BUILD)/apps/hwffd-plates

mass-spring: install
	@$(CMAKE_CONFIGURE) -DHWFFD_TIER=$(TIER)
	@$(CMAKE_BUILD) --target hwffd-example-mass-spring
	@$(BUILD)/examples/hwffd-example-mass-spring

glapi: install
	@$(CMAKE_CONFIGURE) -DHWFFD_TIER=$(TIER)
	@$(CMAKE_BUILD) --target hwffd-glapi
	@$(BUILD)/studies/glapi/hwffd-glapi

synth: install
	@scripts/synth -j $(JOBS) $(SYNTH_ARGUMENTS)

synth-check: install
	@scripts/synth_baseline check -j $(JOBS) $(call arguments,target:TARGET org:ORG n:N format:FORMAT)

synth-baseline: install
	@scripts/synth_baseline write -j $(JOBS)

docs: install
	@scripts/structure -j $(JOBS)
	@scripts/datasheet.py --keep write

pnr: install
	@scripts/python_env route
	@scripts/pnr -j $(JOBS) $(call arguments,target:TARGET org:ORG n:N format:FORMAT)

boards: install
	@scripts/python_env route
	@scripts/boards $(call arguments,board:BOARD)

formal: install
	@scripts/formal -j $(JOBS)

test: install
	@scripts/python_env
	@$(CMAKE_CONFIGURE) -DHWFFD_TIER=test
	@$(CMAKE_BUILD)
	@$(CTEST) -L '^test$$'

test-all: install
	@scripts/python_env all
	@$(CMAKE_CONFIGURE) -DHWFFD_TIER=all
	@$(CMAKE_BUILD)
	@$(CTEST) -L '^(test|all)$$'

soak: install
	@$(CMAKE_CONFIGURE) -DHWFFD_TIER=$(TIER)
	@$(CMAKE_BUILD) --target axi_test
	@HWFFD_SOAK="$(or $(call given,SEEDS),100)" $(BUILD)/tests/bus/axi/axi_test --gtest_brief=1 --gtest_filter='*Soak*'

lint: install
	@$(CMAKE_CONFIGURE)
	@scripts/lint -j $(JOBS)

clean:
	@rm -rf build build-trace
