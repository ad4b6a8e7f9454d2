# Verilated models as ordinary build steps: they run in parallel, only where a target asks for them,
# and never while CMake configures (which the function shipped with Verilator does).

find_program(VERILATOR verilator REQUIRED)
execute_process(
  COMMAND ${VERILATOR} --getenv VERILATOR_ROOT
  OUTPUT_VARIABLE VERILATOR_ROOT
  OUTPUT_STRIP_TRAILING_WHITESPACE)
find_package(Threads REQUIRED)
find_package(ZLIB REQUIRED)

# The simulator's own run time, compiled once for all models.
add_library(verilated_runtime STATIC
  ${VERILATOR_ROOT}/include/verilated.cpp
  ${VERILATOR_ROOT}/include/verilated_threads.cpp
  ${VERILATOR_ROOT}/include/verilated_fst_c.cpp)
target_include_directories(verilated_runtime SYSTEM PUBLIC
  ${VERILATOR_ROOT}/include ${VERILATOR_ROOT}/include/vltstd)
target_link_libraries(verilated_runtime PUBLIC Threads::Threads ZLIB::ZLIB)
target_compile_options(verilated_runtime PRIVATE -w -O2)

set(HWFFD_BENCH_CONTROL ${CMAKE_SOURCE_DIR}/cores/rtl/ffd_bench.vlt)
option(HWFFD_TRACE "models that can write waveforms; they run slower" OFF)

# How models are compiled, and those that stay on this machine; so is what is timed beside them.
set(HWFFD_MODEL_OPTIONS "-O2 -fno-tree-pre -fno-code-hoisting")
set(HWFFD_NATIVE_OPTIONS "-march=native")

# hwffd_verilate(<target> [NETLIST] [NATIVE] [WIDE] TOP <module> SOURCES <file>... [PARAMETERS NAME=value...]
#                [LIBRARY <file>])
#
# Makes the static library <target>, whose class is V<target> (header "V<target>.h"); with waveforms
# where HWFFD_TRACE is on, which its users see as a definition of that name.
#
# Warnings are errors; what else Verilator says is in verilator.log, and shown where it fails.
#
# A model is compiled as one file, since its headers take longer than most of its parts. Partial
# redundancies are left alone: to look for them is half of the time to compile `factored`, which then
# runs a tenth slower.
#
# NETLIST says that the sources are gates or cells: not linted, since yosys writes what it likes; and
# compiled for a short build, because an optimizer gains little on a hundred thousand lines without a
# branch.
#
# LIBRARY is a file for the modules that the sources lack; of those that both have, it is the sources' that
# count. (NO_INCLUDES is how yosys' files of cells are told to stay alone.)
#
# WIDE says that many float units work side by side: Verilator's optimization of gates would make the
# build four times as long and the simulation no faster.
#
# NATIVE says that the model stays on this machine and may use all of its processor: a third faster
# where many units move side by side.
function(hwffd_verilate target)
  cmake_parse_arguments(ARG "NETLIST;NATIVE;WIDE" "TOP;LIBRARY" "SOURCES;PARAMETERS" ${ARGN})
  set(class V${target})
  set(dir ${CMAKE_BINARY_DIR}/verilated/${target})
  set(flags --cc --default-language 1364-2005 -O3 --x-initial unique --x-assign unique
    -DFFD_SIMULATION -CFLAGS -fPIC --top-module ${ARG_TOP} --prefix ${class} --Mdir ${dir})
  list(TRANSFORM HWFFD_RTL_INCLUDES PREPEND -I OUTPUT_VARIABLE includes)
  list(APPEND flags ${includes})
  set(optimize ${HWFFD_MODEL_OPTIONS})
  if(ARG_NETLIST)
    list(APPEND flags -Wno-lint -Wno-fatal)
    set(optimize -O0)
  else()
    list(APPEND flags -Wall ${HWFFD_BENCH_CONTROL})
  endif()
  if(ARG_LIBRARY)
    list(APPEND flags -DNO_INCLUDES -v ${ARG_LIBRARY})
  endif()
  if(ARG_NATIVE)
    list(APPEND flags -CFLAGS ${HWFFD_NATIVE_OPTIONS})
  endif()
  if(ARG_WIDE)
    list(APPEND flags -fno-gate)
  endif()
  foreach(parameter IN LISTS ARG_PARAMETERS)
    list(APPEND flags -G${parameter})
  endforeach()
  if(HWFFD_TRACE)
    list(APPEND flags --trace-fst --trace-structs)
  endif()
  file(MAKE_DIRECTORY ${dir})
  file(GLOB headers CONFIGURE_DEPENDS ${HWFFD_RTL_DIR}/*/*.vh)
  add_custom_command(
    OUTPUT ${dir}/${class}__ALL.a ${dir}/${class}.h
    COMMAND sh -c "\"$@\" 2>verilator.log || { cat verilator.log >&2; exit 1; }" -
            ${VERILATOR} ${flags} ${ARG_SOURCES}
    COMMAND ${CMAKE_COMMAND} -E env MAKEFLAGS= make --silent -C ${dir} -f ${class}.mk
            VM_PARALLEL_BUILDS=0 OPT_FAST=${optimize} ${class}__ALL.a > ${dir}/make.log
    WORKING_DIRECTORY ${dir}
    DEPENDS ${ARG_SOURCES} ${headers} ${HWFFD_BENCH_CONTROL}
    COMMENT "Verilating ${target}"
    VERBATIM)
  add_custom_target(${target}_verilate DEPENDS ${dir}/${class}__ALL.a)
  add_library(${target} INTERFACE)
  add_dependencies(${target} ${target}_verilate)
  target_include_directories(${target} SYSTEM INTERFACE ${dir})
  if(HWFFD_TRACE)
    target_compile_definitions(${target} INTERFACE HWFFD_TRACE)
  endif()
  target_link_libraries(${target} INTERFACE ${dir}/${class}__ALL.a verilated_runtime)
endfunction()
