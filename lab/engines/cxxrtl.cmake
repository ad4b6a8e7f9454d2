# Cores as yosys writes them in C++ (CXXRTL), as ordinary build steps.

set(cxxrtl_include ${hwffd_BINARY_DIR}/cxxrtl/include)
hwffd_of_yosys(include ${cxxrtl_include} /backends/cxxrtl/cxxrtl.h)

# hwffd_cxxrtl(<library> <row> <source> [<planted>])
#
# Makes the static library of `hwffd_stream` of a row. The source is compiled with the macros
# HWFFD_CXXRTL_HEADER and HWFFD_ROW. A planted file is taken for that of rtl/ of its name.
function(hwffd_cxxrtl library row source)
  set(source_of_row ${hwffd_BINARY_DIR}/cxxrtl/${library}.cc)
  file(GLOB headers CONFIGURE_DEPENDS ${HWFFD_RTL_DIR}/*/*.vh)
  add_custom_command(
    OUTPUT ${source_of_row} ${hwffd_BINARY_DIR}/cxxrtl/${library}.h
    COMMAND ${HWFFD_PYTHON_TOOL} lab.engines.cxxrtl ${row} ${source_of_row} --planted ${ARGN}
    DEPENDS hwffd_of_yosys ${cxxrtl_include}/backends/cxxrtl/cxxrtl.h ${HWFFD_RTL_SOURCES} ${ARGN} ${headers} ${HWFFD_RTL_DIR}/configurations.csv
            ${HWFFD_LAB_DIR}/engines/cxxrtl.py ${hwffd_SOURCE_DIR}/tools/rtl/rtl_sources.py
    COMMENT "Writing ${row} as C++"
    VERBATIM)
  add_library(${library} STATIC EXCLUDE_FROM_ALL ${source_of_row} ${source})
  set_target_properties(${library} PROPERTIES UNITY_BUILD OFF)
  target_include_directories(${library} SYSTEM PRIVATE ${cxxrtl_include} ${hwffd_BINARY_DIR}/cxxrtl)
  target_compile_definitions(${library} PRIVATE
    HWFFD_CXXRTL_HEADER="${library}.h" HWFFD_ROW="${row}")
  target_compile_options(${library} PRIVATE -w -g0 -O1)
  target_link_libraries(${library} PUBLIC hwffd_core_interface)
endfunction()
