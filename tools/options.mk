# What the Makefiles of the product and of the laboratory share: variables of a command line as options of a
# program, and how a build is configured and compiled.
# SPDX-License-Identifier: Apache-2.0
# Where Python finds the packages of the checkout: tools, and lab.
export PYTHONPATH := $(CURDIR)$(if $(PYTHONPATH),:$(PYTHONPATH))
ifeq ($(JOBS),)
  JOBS := $(shell nproc 2>/dev/null || echo 2)
endif
ifneq ($(shell case '$(JOBS)' in (''|*[!0-9]*|0*) echo wrong ;; esac),)
  $(error JOBS=$(JOBS): a number from 1 on)
endif
TIERS  = sim cover test all
ifneq ($(TIER),$(filter $(TIERS),$(firstword $(TIER))))
  $(error TIER=$(TIER): one of $(TIERS))
endif

# Installs the sets of packages that a command needs.
INSTALL = @tools/install
# All that can be configured is said each time, so that nothing is as an earlier command has left it; the
# generator of a build that is there stays.
SELECTED  = $(call selected,)
selected  = $(foreach v,ORG N FORMAT,-DHWFFD_$v="$(if $(and $(filter $v,$1),$(call given,$v)),$$HWFFD_GIVEN_$v)")
COVERAGE  = OFF
CONFIGURE = @cmake -S $(SOURCE) -B $(BUILD) $(if $(wildcard $(BUILD)/CMakeCache.txt),,-G Ninja) --log-level=NOTICE \
  -DHWFFD_TIER=$(TIER) -DHWFFD_TRACE=$(if $(tracing),ON,OFF) -DHWFFD_COVERAGE=$(COVERAGE) $(SELECTED)
COMPILE   = @cmake --build $(BUILD) -j $(JOBS)

# Variables are handed on as --model X and so on. Only those given on make's command line count, not those that
# happen to be in the environment. They travel as they are, in HWFFD_GIVEN_*, so that neither make nor the shell
# reads anything into a blank, a quote or a dollar.
option_of   = $(firstword $(subst :, ,$1))
variable_of = $(lastword $(subst :, ,$1))
given       = $(and $(findstring command line,$(origin $1)),$(value $1))
# exported NAME:VARIABLE...
define exported
$(foreach o,$1,$(eval export HWFFD_GIVEN_$(call variable_of,$o) := $$(value $(call variable_of,$o))))
$(eval unexport $(foreach o,$1,$(call variable_of,$o)))
endef

arguments = $(foreach o,$1,$(if $(call given,$(call variable_of,$o)), \
  --$(call option_of,$o) "$$HWFFD_GIVEN_$(call variable_of,$o)"))
# Refuses what is no number, before anything is built.
numbers = @$(foreach v,$1,$(if $(call given,$v),case "$$HWFFD_GIVEN_$v" in (''|*[!0-9.]*|*.*.*) \
  echo "make: $v=$$HWFFD_GIVEN_$v: a number is wanted" >&2; exit 2 ;; esac;)) :

# How tests run, with the name of their report: make's last lines are ctest's.
run_tests = python3 -B -m tools.checks.run_tests $(BUILD)/reports/$1.xml ctest --test-dir $(BUILD) --no-tests=error --output-on-failure \
            --output-junit reports/$1.xml --test-output-size-passed 65536 -j $(JOBS)
