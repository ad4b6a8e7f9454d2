# The table of configurations, rtl/configurations.csv, as CMake needs it:
#   HWFFD_RTL_SOURCES                     every source of rtl/hwffd.f and rtl/boards.f
#   HWFFD_CONFIGURATION_IDENTIFIERS       all rows
#   HWFFD_TIER_IDENTIFIERS                those of this build's tier
#   HWFFD_STREAM_IDENTIFIERS              those of them that are verilated with their streams
#   HWFFD_AXI_IDENTIFIERS                 those of them that are verilated with their buses, too
#   HWFFD_SELECTED_IDENTIFIERS            those that hwffd-organizations compares
#   HWFFD_CONFIGURATION_PARAMETERS_<id>   a row's parameters, NAME=value
#   HWFFD_CONFIGURATION_OPTIONS_<id>      what hwffd_verilate has to know of it besides
# and, in HWFFD_GENERATED_DIR, the C++ that follows from it: the table, the models, the cores.

set(HWFFD_TIER test CACHE STRING "configurations to verilate: sim, cover, test or all")
set_property(CACHE HWFFD_TIER PROPERTY STRINGS sim cover test all)
set(HWFFD_ORG "" CACHE STRING "organization that hwffd-organizations compares; empty: all")
set(HWFFD_N "" CACHE STRING "units of the organizations that it compares; empty: any")
set(HWFFD_FORMAT "" CACHE STRING "format of the organizations that it compares; empty: all")
set(HWFFD_SELECTION "")
foreach(column ORG N FORMAT)
  string(TOLOWER ${column} option)
  if(HWFFD_${column})
    list(APPEND HWFFD_SELECTION --${option} ${HWFFD_${column}})
  endif()
endforeach()
set(HWFFD_GENERATED_DIR ${hwffd_BINARY_DIR}/generated)
include(${CMAKE_CURRENT_LIST_DIR}/HwffdPython.cmake)

set(table ${HWFFD_RTL_DIR}/configurations.csv)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
  ${HWFFD_RTL_DIR}/evaluator/ffd_org_tree.v ${HWFFD_RTL_DIR}/organizations.csv
  ${HWFFD_RTL_DIR}/gone.csv ${HWFFD_RTL_DIR}/formats.csv ${HWFFD_RTL_DIR}/stream/fields.csv
  ${table} ${HWFFD_RTL_DIR}/hwffd.f ${HWFFD_RTL_DIR}/boards.f ${HWFFD_RTL_DIR}/bus/registers.csv
  ${HWFFD_RTL_DIR}/bus/registers_preamble.md ${hwffd_SOURCE_DIR}/VERSION)
file(GLOB modules CONFIGURE_DEPENDS ${hwffd_SOURCE_DIR}/tools/tables/*.py)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${modules}
  ${hwffd_SOURCE_DIR}/tools/csv_table.py ${hwffd_SOURCE_DIR}/tools/rtl/module_header.py
  ${hwffd_SOURCE_DIR}/tools/rtl/rtl_sources.py)

function(hwffd_generate)
  execute_process(COMMAND ${HWFFD_PYTHON_TOOL} tools.tables.configurations ${ARGN} RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "the table of configurations is broken; see the line above")
  endif()
endfunction()

execute_process(COMMAND ${HWFFD_PYTHON_TOOL} tools.tables.generated_files write
  RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "a table is broken; see the line above")
endif()
hwffd_generate(build ${HWFFD_GENERATED_DIR} --tier ${HWFFD_TIER} ${HWFFD_SELECTION})
include(${HWFFD_GENERATED_DIR}/configurations.cmake)

file(STRINGS ${HWFFD_RTL_DIR}/hwffd.f HWFFD_RTL_SOURCES REGEX "^[^/+].*[.]v$")
file(STRINGS ${HWFFD_RTL_DIR}/boards.f boards REGEX "^[^/+].*[.]v$")
list(APPEND HWFFD_RTL_SOURCES ${boards})
list(TRANSFORM HWFFD_RTL_SOURCES PREPEND ${HWFFD_RTL_DIR}/)
