# The project's commands. Everything is built in build/ by CMake and Ninja; `make` alone explains.
# SPDX-License-Identifier: Apache-2.0
.DEFAULT_GOAL := help
.NOTPARALLEL:
.PHONY: help sim web organizations bfp streams words tangents embed compare energy coverage engines mutants upsets theorems bounds testfloat hwffd glapi plates mass-spring synth synth-check synth-baseline structure figures boards pnr formal workflow docs test test-all random soak lint clean

# A build with waveforms is one of its own, so that the ordinary one stays as it is.
tracing =
BUILD   = build
sim: tracing = $(filter-out 0,$(call given,TRACE))
sim: BUILD = $(if $(tracing),build-trace,build)
JOBS  ?= $(shell nproc 2>/dev/null || echo 2)
TIER  ?= test
TIERS  = sim cover test all
ifneq ($(TIER),$(filter $(TIERS),$(firstword $(TIER))))
  $(error TIER=$(TIER): one of $(TIERS))
endif

# Installs the sets of tools/packages.txt that a command needs.
INSTALL = @tools/install
# All that can be configured is said each time, so that nothing is as an earlier command has left it; the
# generator of a build that is there stays.
SELECTED  = $(call selected,)
selected  = $(foreach v,ORG N FORMAT,-DHWFFD_$v="$(if $(and $(filter $v,$1),$(call given,$v)),$$HWFFD_GIVEN_$v)")
COVERAGE  = OFF
CONFIGURE = @cmake -S . -B $(BUILD) $(if $(wildcard $(BUILD)/CMakeCache.txt),,-G Ninja) --log-level=NOTICE \
  -DHWFFD_TIER=$(TIER) -DHWFFD_TRACE=$(if $(tracing),ON,OFF) -DHWFFD_COVERAGE=$(COVERAGE) $(SELECTED)
COMPILE   = @cmake --build $(BUILD) -j $(JOBS)
RUN_TESTS = tools/run_tests $(BUILD)/reports/tests.xml ctest --test-dir $(BUILD) --no-tests=error --output-on-failure \
            --output-junit reports/tests.xml --test-output-size-passed 65536 -j $(JOBS)

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
OPTIONS     := prefix:PREFIX board:BOARD profile:PROFILE work:WORK seeds:SEEDS only:ONLY hours:HOURS flips:FLIPS \
               mutants:MUTANTS share:SHARE $(sort $(SIM_OPTIONS) $(SYNTH_OPTIONS) $(ORGANIZATIONS_OPTIONS))

$(foreach o,$(OPTIONS),$(eval export HWFFD_GIVEN_$(call variable_of,$o) := \
  $$(value $(call variable_of,$o))))
unexport $(foreach o,$(OPTIONS),$(call variable_of,$o))

arguments = $(foreach o,$1,$(if $(call given,$(call variable_of,$o)), \
  --$(call option_of,$o) "$$HWFFD_GIVEN_$(call variable_of,$o)"))
# Refuses what is no number, before anything is built.
numbers = @$(foreach v,$1,$(if $(call given,$v),case "$$HWFFD_GIVEN_$v" in (''|*[!0-9.]*|*.*.*) \
  echo "make: $v=$$HWFFD_GIVEN_$v: a number is wanted" >&2; exit 2 ;; esac;)) :
SIM_ARGUMENTS   = $(call arguments,$(SIM_OPTIONS)) $(if $(tracing),--trace)
SYNTH_ARGUMENTS = $(call arguments,$(SYNTH_OPTIONS))
# What docs/reports/ has of these sources is not measured again, unless AGAIN=1 says so.
AGAIN_ARGUMENT  = $(if $(filter-out 0,$(call given,AGAIN)),--again)

help:
	@echo 'Use it'
	@echo '  make sim            deform a mesh on the simulated hardware and compare every bit with the model'
	@echo '  make web            a page for the browser: a mesh deformed live by simulated cores, and a look inside'
	@echo '  make hwffd          the command hwffd, the library, the Python module; PREFIX= installs them'
	@echo '  make plates         the ten plates of the paper, drawn from the simulated hardware'
	@echo '  make mass-spring    an example: a mesh in a lattice of masses and springs'
	@echo '  make workflow       synth, pnr, mutants, upsets and soak as jobs, also on clusters: PROFILE='
	@echo '  make clean          remove build/, build-trace/ and build-coverage/'
	@echo 'See it (tables, pictures and reports)'
	@echo '  make organizations  what organizations of the arithmetic cost in clock cycles and operators'
	@echo '  make words          how many bits fixed point needs: errors measured and proved'
	@echo '  make bfp            the error of block floating point, measured and proved'
	@echo '  make tangents       derivatives and fold flags out of the simulated hardware'
	@echo '  make streams        how many words must be moved for each vertex'
	@echo '  make embed          meshes in box, cylinder, sphere and custom lattices'
	@echo '  make compare        vertices a second beside other programs, on one core and in hardware'
	@echo 'Check it'
	@echo '  make test           build everything and run the tests'
	@echo '  make test-all       every configuration, and the long tests'
	@echo '  make lint           Verilator, Icarus, yosys, clang and text rules: no warning is allowed'
	@echo '  make formal         unbounded proofs of control and transport, each with a planted bug'
	@echo '  make glapi          the OpenGL calls and their errors, beside those of Mesa'
	@echo '  make random         N= cores of random parameters on random packets, from SEED= on'
	@echo '  make soak           random traffic with new seeds, for HOURS='
	@echo 'Trust it (docs/assurance.md)'
	@echo '  make coverage       lines, branches and bits of the RTL that the tests run (hours)'
	@echo '  make mutants        single changes of the RTL, and whether the tests see them'
	@echo '  make upsets         bits that flip while the core works: what becomes of each'
	@echo '  make theorems       the arithmetic proved for all operands, each with a planted bug'
	@echo '  make bounds         bounds of every error by Gappa, accepted by Coq, beside errors reached'
	@echo '  make testfloat      the binary32 units on N= operands by the scheme of TestFloat'
	@echo '  make engines        the same commands in four simulators, and where an X may be'
	@echo 'Build hardware'
	@echo '  make synth          size on FPGAs and in standard cells, by yosys (half an hour)'
	@echo '  make synth-check    whether size or depth has grown over synth/baseline.csv'
	@echo '  make synth-baseline write that file anew'
	@echo '  make structure      the tops as trees of modules, with the size of each'
	@echo '  make pnr            clocks after place and route with nextpnr (an hour)'
	@echo '  make energy         what a vertex costs in standard cells, from the toggles of their nets'
	@echo '  make boards         bitstreams for ULX3S and iCEBreaker'
	@echo 'Read it'
	@echo '  make docs           the texts as a site with search and the reference of the libraries'
	@echo '  make figures        draw all pictures, fill all figures of the texts from the reports'
	@echo
	@echo 'JOBS=$(JOBS) processes side by side. docs/commands.md has all variables, docs/studies the results.'

# The rows that it runs: those of tier sim, unless it is asked for others.
sim: TIER = $(or $(call given,TIER),$(if $(call given,ORG),test,$(if $(call given,FORMAT),$$(test \
  -n "$$(tools/configurations.py list --tier sim --format "$$HWFFD_GIVEN_FORMAT" 2>/dev/null)" \
  && echo sim || echo test),sim)))
sim:
	$(INSTALL) build
	$(call numbers,SEED)
	@case "$$HWFFD_GIVEN_STREAM" in ''|interleaved|resident|dma) ;; *) \
	  echo "make: STREAM=$$HWFFD_GIVEN_STREAM: one of interleaved, resident, dma" >&2; exit 2 ;; esac
	@tools/configurations.py list --tier $(TIER) --top $(if $(filter dma,$(call given,STREAM)),axi,stream) \
	  $(call arguments,org:ORG format:FORMAT schedule:SCHEDULE) >/dev/null
	$(CONFIGURE)
	$(COMPILE) --target hwffd-sim
	@$(STUDY) --quiet $(if $(filter dma,$(call given,STREAM)),dma,sim) -- $(BUILD)/tb/hwffd-sim $(SIM_ARGUMENTS)

# One file, build/web/index.html, and its test in a browser, which measures it.
web:
	$(INSTALL) build web
	$(CONFIGURE)
	$(COMPILE) --target hwffd-web-engine hwffd-web-plates
	@$(BUILD)/apps/hwffd-web-plates $(BUILD)/web/plates.json
	@$(BUILD)/venv/bin/python -B apps/web/bundle.py --engine $(BUILD)/web/engine \
	  --plates $(BUILD)/web/plates.json --output $(BUILD)/web/index.html
	@$(STUDY) web -- $(BUILD)/venv/bin/python -B -m pytest --quiet tests/web/test_page.py \
	  --argument=$(BUILD)/web/index.html

# A study measures and writes its report; tools/figures stamps, prints and draws it.
STUDY = tools/figures measure

# Only the rows selected are verilated. The names are checked before they reach CMake.
organizations: SELECTED = $(call selected,ORG N FORMAT)
organizations:
	$(INSTALL) build yosys figures
	@tools/configurations.py list $(call arguments,$(ORGANIZATIONS_OPTIONS)) >/dev/null
	$(CONFIGURE)
	$(COMPILE) --target hwffd-organizations
	@$(STUDY) organizations,timelines -- $(BUILD)/lab/hwffd-organizations

# The same selection, of one format; ORG= and N= narrow it.
bfp: SELECTED = $(filter-out -DHWFFD_FORMAT=%,$(call selected,ORG N)) -DHWFFD_FORMAT=bfp32
bfp:
	$(INSTALL) build figures
	@tools/configurations.py list --format bfp32 $(call arguments,org:ORG n:N) >/dev/null
	$(CONFIGURE)
	$(COMPILE) --target hwffd-bfp
	@$(STUDY) bfp -- $(BUILD)/lab/hwffd-bfp

streams words tangents embed:
	$(INSTALL) build figures
	$(CONFIGURE)
	$(COMPILE) --target hwffd-$@
	@$(STUDY) $@ -- $(BUILD)/lab/hwffd-$@

# Programs of others are its peers: as many cores each, in one run.
compare:
	$(INSTALL) build compare
	$(CONFIGURE)
	$(COMPILE) --target hwffd-compare hwffd_python
	@$(STUDY) compare,bench -- $(BUILD)/venv/bin/python -B lab/compare

# Netlists are kept in build/energy/, since to map them takes as long as the rest.
energy:
	$(INSTALL) build energy figures
	$(CONFIGURE)
	$(COMPILE) --target hwffd-energy-words
	@$(STUDY) energy -- $(BUILD)/venv/bin/python -B lab/energy

# Netlists and C++ of small rows, each compiled once.
engines:
	$(INSTALL) build engines figures
	$(CONFIGURE)
	$(COMPILE) --target hwffd_engines
	@$(STUDY) engines,unknowns -- $(BUILD)/venv/bin/python -B lab/engines

# What Coq has accepted is kept in build/bounds/.
bounds:
	$(INSTALL) build bounds figures
	$(CONFIGURE)
	$(COMPILE) --target hwffd-bounds
	@$(STUDY) bounds -- python3 -B lab/bounds

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
	@$(STUDY) --quiet plates -- $(BUILD)/apps/hwffd-plates

mass-spring:
	$(INSTALL) build
	$(CONFIGURE)
	$(COMPILE) --target hwffd-example-mass-spring
	@$(BUILD)/examples/hwffd-example-mass-spring

glapi:
	$(INSTALL) build module
	$(CONFIGURE)
	$(COMPILE) --target hwffd_rtl hwffd_gl_shared hwffd_python
	@$(STUDY) glapi -- $(BUILD)/venv/bin/python tests/gl/glapi.py --output $(BUILD)

# Standard cells are one of the targets.
CELLS = $(if $(filter-out osu018,$(call given,TARGET)),,cells)
synth:
	$(INSTALL) engine $(CELLS)
	@$(STUDY) --quiet synth -- tools/synth -j $(JOBS) $(SYNTH_ARGUMENTS) $(AGAIN_ARGUMENT)

synth-check:
	$(INSTALL) engine $(CELLS)
	@tools/synth_baseline check -j $(JOBS) $(call arguments,target:TARGET org:ORG n:N format:FORMAT)

synth-baseline:
	$(INSTALL) engine cells
	@tools/synth_baseline write -j $(JOBS)

structure:
	$(INSTALL) engine figures
	@$(STUDY) structure -- tools/structure -j $(JOBS)

# The texts as a site, with what `make web` has made.
docs:
	$(INSTALL) docs
	@$(BUILD)/venv/bin/python -B apps/docs

# Everything that is drawn or filled in from reports.
figures:
	$(INSTALL) figures
	@tools/figures

pnr:
	$(INSTALL) route
	@$(STUDY) --quiet pnr,synth -- tools/pnr -j $(JOBS) $(call arguments,target:TARGET org:ORG n:N format:FORMAT) $(AGAIN_ARGUMENT)

boards:
	$(INSTALL) route
	@$(STUDY) --quiet boards -- tools/boards -j $(JOBS) $(call arguments,board:BOARD)

# PROFILE= of these or a site's own; WORK= which reports, SEEDS= of the soak.
PROFILES = lab/workflow/profiles
profile  = $(if $(call given,PROFILE),$(if $(wildcard $(PROFILES)/$(call given,PROFILE)),$(PROFILES)/)"$$HWFFD_GIVEN_PROFILE",$(PROFILES)/local)

workflow:
	$(INSTALL) build route figures workflow
	$(call numbers,SEEDS)
	$(CONFIGURE)
	@$(BUILD)/venv/bin/snakemake --snakefile lab/workflow/Snakefile --directory $(BUILD) \
	  --workflow-profile synth/profiles/default --profile $(profile) \
	  $(if $(call given,JOBS),--cores $(JOBS) --jobs $(JOBS)) --config "root=$(CURDIR)" \
	  $(if $(call given,WORK),"work=$$HWFFD_GIVEN_WORK") $(if $(call given,SEEDS),"soak_seeds=$$HWFFD_GIVEN_SEEDS")

formal:
	$(INSTALL) engine
	@$(STUDY) --quiet formal -- tools/formal -j $(JOBS) $(call arguments,only:ONLY)

test: override TIER = test
test:
	$(INSTALL) test
	$(CONFIGURE)
	$(COMPILE)
	@$(STUDY) --quiet tests -- $(RUN_TESTS) -L '^test$$'

test-all: override TIER = all
test-all:
	$(INSTALL) test-all
	$(CONFIGURE)
	$(COMPILE)
	@$(RUN_TESTS) -L '^(test|all)$$'

# A build of its own, whose models and libraries count, of the rows of tier cover; SHARE=8 runs an eighth of each
# program's tests.
coverage: BUILD = build-coverage
coverage: TIER = cover
coverage: COVERAGE = ON
coverage:
	$(INSTALL) test coverage
	$(call numbers,SHARE)
	$(CONFIGURE)
	$(COMPILE) --target hwffd_tests_test
	@$(STUDY) coverage -- build/venv/bin/python -B lab/rtl_coverage -j $(JOBS) --share $(or $(call given,SHARE),1)

# The test programs in a column of a table.
programs_of = $(sort $(notdir $(shell tail -n +2 $1 | cut -d, -f$2)))

# MUTANTS= of all subjects together; what is known of the same mutants is not run again.
mutants:
	$(INSTALL) build engine
	$(call numbers,MUTANTS)
	$(CONFIGURE)
	$(COMPILE) --target $(foreach column,3 9,$(call programs_of,lab/mutants/subjects.csv,$(column)))
	@$(STUDY) mutants -- python3 -B lab/mutants -j $(JOBS) $(addprefix --mutants ,$(call given,MUTANTS)) $(AGAIN_ARGUMENT)

# FLIPS= of each core in registers, and as many in memories.
upsets:
	$(INSTALL) build engines
	$(call numbers,FLIPS)
	$(CONFIGURE)
	$(COMPILE) --target hwffd_upsets_programs
	@$(STUDY) upsets -- python3 -B lab/upsets -j $(JOBS) $(addprefix --flips ,$(call given,FLIPS))

# NIGHTLY=1 proves the fused unit too, ten minutes. Answers are kept by the digest of the question.
theorems:
	$(INSTALL) theorems figures
	@$(STUDY) theorems -- $(BUILD)/venv/bin/python -B lab/theorems -j $(JOBS) $(if $(filter-out 0,$(call given,NIGHTLY)),--nightly)

# N= cases of each unit and latency: 100000000 nightly.
testfloat:
	$(INSTALL) build figures
	$(call numbers,N)
	$(CONFIGURE)
	$(COMPILE) --target hwffd-testfloat
	@$(STUDY) testfloat -- $(BUILD)/lab/testfloat/hwffd-testfloat --cases $(or $(call given,N),1000000)

random:
	$(INSTALL) build engines
	$(call numbers,N SEED)
	$(CONFIGURE)
	$(COMPILE) --target hwffd-random-words
	@python3 -B tests/random --words $(BUILD)/tests/random/hwffd-random-words --folder $(BUILD)/random \
	  --count $(or $(call given,N),20) $(addprefix --seed ,$(call given,SEED))

soak:
	$(INSTALL) build engines
	$(call numbers,HOURS)
	$(CONFIGURE)
	$(COMPILE) --target $(call programs_of,lab/soak/traffic.csv,2)
	@$(STUDY) soak -- python3 -B lab/soak -j $(JOBS) $(addprefix --hours ,$(call given,HOURS))

lint:
	$(INSTALL) build lint
	$(CONFIGURE)
	@tools/lint -j $(JOBS)

clean:
	@rm -rf build build-trace build-coverage
