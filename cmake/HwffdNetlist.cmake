# Gate netlists as ordinary build steps: a row of the table through yosys, and what comes out through
# Verilator.

find_program(YOSYS yosys REQUIRED)
set(netlist_scripts ${CMAKE_SOURCE_DIR}/scripts)

# hwffd_netlist(<identifier>)
#
# Makes the static library <identifier>_netlist, as hwffd_verilate does, of the netlist of a row.
function(hwffd_netlist id)
  set(netlist ${CMAKE_BINARY_DIR}/netlists/${id}.v)
  file(GLOB headers CONFIGURE_DEPENDS ${HWFFD_RTL_DIR}/*/*.vh)
  add_custom_command(
    OUTPUT ${netlist}
    COMMAND ${Python3_EXECUTABLE} -B ${netlist_scripts}/netlist.py
            ${HWFFD_CONFIGURATION_NAME_${id}} ${netlist}
    DEPENDS ${HWFFD_RTL_SOURCES} ${headers} ${HWFFD_RTL_DIR}/configurations.csv
            ${netlist_scripts}/netlist.py ${netlist_scripts}/rtl.py
    COMMENT "Synthesizing the netlist of ${id}"
    VERBATIM)
  hwffd_verilate(${id}_netlist NETLIST TOP hwffd_stream SOURCES ${netlist})
endfunction()
