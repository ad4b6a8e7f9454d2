# Verilated models as ordinary build steps: they run in parallel, only where a target asks for them,
# and never while CMake configures (which the function shipped with Verilator does).

include(${CMAKE_CURRENT_LIST_DIR}/HwffdTable.cmake)
hwffd_find_program(VERILATOR verilator)
execute_process(
  COMMAND ${VERILATOR} --getenv VERILATOR_ROOT
  OUTPUT_VARIABLE VERILATOR_ROOT
  OUTPUT_STRIP_TRAILING_WHITESPACE)
hwffd_find(ZLIB)

option(HWFFD_TRACE "models that can write waveforms; they run slower" OFF)

# The simulator's own run time, compiled once for all models.
set(runtime verilated.cpp verilated_threads.cpp)
if(HWFFD_TRACE)
  list(APPEND runtime verilated_fst_c.cpp)
endif()
list(TRANSFORM runtime PREPEND ${VERILATOR_ROOT}/include/)
if(HWFFD_COVERAGE)
  list(APPEND runtime ${hwffd_SOURCE_DIR}/tb/coverage/coverage_counters.cpp)
endif()
# What is not counted in a build that counts: what simulators have written.
set(uncounted "")
if(HWFFD_COVERAGE)
  set(uncounted -fno-profile-arcs -fno-test-coverage)
endif()
add_library(verilated_runtime STATIC ${runtime})
target_include_directories(verilated_runtime SYSTEM PUBLIC
  ${VERILATOR_ROOT}/include ${VERILATOR_ROOT}/include/vltstd)
target_link_libraries(verilated_runtime PUBLIC Threads::Threads ZLIB::ZLIB)
target_compile_options(verilated_runtime PRIVATE -w ${uncounted})
set_target_properties(verilated_runtime PROPERTIES HWFFD_UNCOUNTED ON)

# Headers, and modules by their names, are found in the folders of rtl/hwffd.f.
set(HWFFD_BENCH_CONTROL ${hwffd_SOURCE_DIR}/cores/rtl/ffd_bench.vlt)
set(verilate_folders ${HWFFD_RTL_SOURCES})
list(TRANSFORM verilate_folders REPLACE "/[^/]*$" "")
list(REMOVE_DUPLICATES verilate_folders)
list(TRANSFORM verilate_folders PREPEND -I)

# How models are compiled, and those that stay on this machine; so is what is timed beside them. Most of the time to
# compile one would go into the question what a store may change, asked of functions with thousands of them: it is
# answered after a few looks.
set(HWFFD_MODEL_OPTIONS "-O1")
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  string(APPEND HWFFD_MODEL_OPTIONS " -fno-tree-pta --param=sccvn-max-alias-queries-per-access=4"
    " --param=dse-max-alias-queries-per-store=4")
endif()
set(HWFFD_NATIVE_OPTIONS "-march=native")

# hwffd_verilate_table(<program> <prefix> TOP <module> [SOURCES <file>...] TABLE <head> <row>...)
#
# A model of each row of a table (hwffd_row), for a program; its first cell stands behind the prefix in its name.
function(hwffd_verilate_table program prefix)
  cmake_parse_arguments(ARG "" "TOP" "SOURCES;TABLE" ${ARGN})
  list(POP_FRONT ARG_TABLE head)
  foreach(row IN LISTS ARG_TABLE)
    hwffd_row("${program}: ${row}" ${head} ${row})
    string(REGEX MATCH "^[^ ]+" first ${row})
    hwffd_verilate(${prefix}${first} TOP ${ARG_TOP} SOURCES ${ARG_SOURCES} PARAMETERS ${parameters})
    target_link_libraries(${program} PUBLIC ${prefix}${first})
  endforeach()
endfunction()

# hwffd_verilate(<target> [NETLIST] [NATIVE] [WIDE] TOP <module> [SOURCES <file>...]
#                [PARAMETERS NAME=value...] [LIBRARY <file>] [AFTER <target>] [CONTROL <file>...])
#
# Makes the static library <target>, whose class is V<target> (header "V<target>.h"); with waveforms
# where HWFFD_TRACE is on, which its users see as a definition of that name.
#
# The sources are those of modules outside rtl/, or that of the top; the others are found by their
# names. A model is verilated anew when a file that Verilator has read for it changes, and compiled
# anew when that changes the model.
#
# Warnings are errors; what else Verilator says is in verilator.log, and shown where it fails.
#
# A model is compiled as one file, since its headers take longer than most of its parts. Partial
# redundancies are left alone: to look for them is half of the time to compile `factored`, which then
# runs a tenth slower.
#
# Where HWFFD_COVERAGE is on, a model counts its lines, branches and toggles (tb/coverage/). Netlists do not.
# A counter a bit makes so much C++ of a core that no optimizer gets through in a minute.
#
# What cannot happen ends a simulation (rtl/common/ffd_assert.vh), but of netlists.
#
# NETLIST says that the sources are gates or cells: not linted, since yosys writes what it likes; and
# compiled for a short build, because an optimizer gains little on a hundred thousand lines without a
# branch.
#
# LIBRARY is a file for the modules that the sources lack; of those that both have, it is the sources' that
# count. (NO_INCLUDES is how yosys' files of cells are told to stay alone.) AFTER is the target that makes it.
#
# WIDE says that many float units work side by side: Verilator's optimization of gates would make the
# build four times as long and the simulation no faster.
#
# CONTROL are control files of Verilator beside the bench's. The target <target>_verilated then makes
# the C++ alone, for another compiler.
#
# NATIVE says that the model stays on this machine and may use all of its processor: a third faster
# where many units move side by side.
function(hwffd_verilate target)
  cmake_parse_arguments(ARG "NETLIST;NATIVE;WIDE" "TOP;LIBRARY;AFTER" "SOURCES;PARAMETERS;CONTROL" ${ARGN})
  set(class V${target})
  set(dir ${hwffd_BINARY_DIR}/verilated/${target})
  if(NOT ARG_SOURCES)
    set(ARG_SOURCES ${HWFFD_RTL_SOURCES})
    list(FILTER ARG_SOURCES INCLUDE REGEX "/${ARG_TOP}[.]v$")
  endif()
  set(flags --cc --default-language 1364-2005 -O3 --x-initial unique --x-assign unique
    -DFFD_SIMULATION --top-module ${ARG_TOP} --prefix ${class})
  separate_arguments(options UNIX_COMMAND "${HWFFD_MODEL_OPTIONS}")
  set(control "")
  if(ARG_NETLIST)
    list(APPEND flags -Wno-lint -Wno-fatal)
    set(options -O0)
  else()
    set(control ${HWFFD_BENCH_CONTROL} ${ARG_CONTROL})
    list(APPEND flags -Wall -DFFD_ASSERTIONS ${verilate_folders} ${control})
    if(HWFFD_COVERAGE)
      list(APPEND flags --coverage-line --coverage-toggle)
      set(options -O0)
    endif()
  endif()
  if(ARG_LIBRARY)
    list(APPEND flags -DNO_INCLUDES -v ${ARG_LIBRARY})
  endif()
  if(ARG_NATIVE)
    list(APPEND options ${HWFFD_NATIVE_OPTIONS})
  endif()
  if(ARG_WIDE)
    list(APPEND flags -fno-gate)
  endif()
  hwffd_feature_parameters(parameters ${ARG_TOP} ${ARG_PARAMETERS})
  if(ARG_NETLIST)
    set(parameters ${ARG_PARAMETERS})
  endif()
  list(TRANSFORM parameters PREPEND -G)
  list(APPEND flags ${parameters})
  if(HWFFD_TRACE)
    list(APPEND flags --trace-fst --trace-structs)
  endif()
  file(MAKE_DIRECTORY ${dir})
  set(script ${hwffd_SOURCE_DIR}/cmake/verilate.sh)
  set(counters ${hwffd_SOURCE_DIR}/cmake/compact_counters.py)
  add_custom_command(
    OUTPUT ${dir}/${class}.cpp ${dir}/${class}.h
    COMMAND ${script} ${class} ${VERILATOR} ${flags} ${ARG_SOURCES}
    WORKING_DIRECTORY ${dir}
    DEPENDS ${ARG_SOURCES} ${ARG_LIBRARY} ${ARG_AFTER} ${control} ${script} $<$<BOOL:${HWFFD_COVERAGE}>:${counters}>
    DEPFILE ${dir}/${class}.d
    COMMENT "Verilating ${target}"
    VERBATIM)
  hwffd_compile_model(${target} ${dir} ${options})
  if(ARG_CONTROL)
    add_custom_target(${target}_verilated DEPENDS ${dir}/${class}.cpp ${dir}/${class}.h)
  endif()
endfunction()

# hwffd_precompiled_runtime(<result> <option>...)
#
# The target that compiles what each model includes, once for all models with these options: for a small one that is
# three quarters of the time.
function(hwffd_precompiled_runtime result)
  string(MD5 name "${ARGN}")
  set(precompiled verilated_precompiled_${name})
  if(NOT TARGET ${precompiled})
    add_library(${precompiled} OBJECT EXCLUDE_FROM_ALL ${hwffd_SOURCE_DIR}/cmake/precompiled_runtime.cpp)
    set_target_properties(${precompiled} PROPERTIES UNITY_BUILD OFF HWFFD_UNCOUNTED ON)
    target_precompile_headers(${precompiled} PRIVATE <verilated.h> <svdpi.h>)
    hwffd_model_options(${precompiled} ${ARGN})
  endif()
  set(${result} ${precompiled} PARENT_SCOPE)
endfunction()

# hwffd_model_options(<target> <option>...)
#
# How what was verilated is compiled, and what it includes: alike, or the one would not serve the other.
function(hwffd_model_options target)
  target_compile_options(${target} PRIVATE -w -g0 ${uncounted} ${ARGN})
  target_compile_definitions(${target} PRIVATE
    VM_TRACE=$<BOOL:${HWFFD_TRACE}> VM_TRACE_FST=$<BOOL:${HWFFD_TRACE}>)
  if(HWFFD_COVERAGE)
    target_include_directories(${target} PRIVATE ${hwffd_SOURCE_DIR}/tb/coverage)
  endif()
  target_link_libraries(${target} PUBLIC verilated_runtime)
endfunction()

# hwffd_compile_model(<target> <folder> <option>...)
#
# The library of what was verilated there.
function(hwffd_compile_model target dir)
  add_library(${target} STATIC EXCLUDE_FROM_ALL ${dir}/V${target}.cpp)
  target_include_directories(${target} SYSTEM INTERFACE ${dir})
  set_target_properties(${target} PROPERTIES UNITY_BUILD OFF HWFFD_UNCOUNTED ON)
  hwffd_model_options(${target} ${ARGN})
  hwffd_precompiled_runtime(precompiled ${ARGN})
  target_precompile_headers(${target} REUSE_FROM ${precompiled})
  if(HWFFD_TRACE)
    target_compile_definitions(${target} INTERFACE HWFFD_TRACE)
  endif()
endfunction()
