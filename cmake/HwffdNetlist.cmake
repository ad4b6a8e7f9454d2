# Netlists as ordinary build steps: a row of the table through yosys, and what comes out through
# Verilator, with models of the target's cells.

find_program(YOSYS yosys REQUIRED)
get_filename_component(yosys_folder ${YOSYS} DIRECTORY)
set(netlist_scripts ${CMAKE_SOURCE_DIR}/scripts)
file(GLOB netlist_steps CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/synth/*.ys
     ${CMAKE_SOURCE_DIR}/synth/*/*.v)

# The cells of a target: ours, and yosys' own for the others. (Gates need none.)
find_file(YOSYS_ECP5_CELLS ecp5/cells_sim.v PATHS ${yosys_folder}/../share/yosys NO_DEFAULT_PATH REQUIRED)
file(GLOB netlist_cells_ecp5 CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tb/cells/ecp5/*.v)
set(netlist_library_ecp5 LIBRARY ${YOSYS_ECP5_CELLS})

# hwffd_netlist(<identifier> <target>)
#
# Makes the static library <identifier>_<target>_netlist, as hwffd_verilate does, of the netlist of a row.
function(hwffd_netlist id target)
  set(netlist ${CMAKE_BINARY_DIR}/netlists/${id}_${target}.v)
  file(GLOB headers CONFIGURE_DEPENDS ${HWFFD_RTL_DIR}/*/*.vh)
  add_custom_command(
    OUTPUT ${netlist}
    COMMAND ${Python3_EXECUTABLE} -B ${netlist_scripts}/netlist.py
            ${HWFFD_CONFIGURATION_NAME_${id}} ${target} ${netlist}
    DEPENDS ${HWFFD_RTL_SOURCES} ${headers} ${HWFFD_RTL_DIR}/configurations.csv
            ${HWFFD_RTL_DIR}/organizations.csv ${netlist_steps}
            ${netlist_scripts}/netlist.py ${netlist_scripts}/synthesis.py ${netlist_scripts}/rtl.py
    COMMENT "Synthesizing the netlist of ${id} for ${target}"
    VERBATIM)
  hwffd_verilate_netlist(${id}_${target}_netlist ${target} ${netlist})
endfunction()

# hwffd_faulty_netlist(<identifier>)
#
# The same as <identifier>_fault_netlist, of a copy of the netlist for ecp5 in which one LUT is wrong.
function(hwffd_faulty_netlist id)
  set(good ${CMAKE_BINARY_DIR}/netlists/${id}_ecp5.v)
  set(faulty ${CMAKE_BINARY_DIR}/netlists/${id}_fault.v)
  add_custom_command(
    OUTPUT ${faulty}
    COMMAND ${Python3_EXECUTABLE} -B ${netlist_scripts}/netlist_fault.py ${good} ${faulty}
    DEPENDS ${good} ${netlist_scripts}/netlist_fault.py
    VERBATIM)
  hwffd_verilate_netlist(${id}_fault_netlist ecp5 ${faulty})
endfunction()

function(hwffd_verilate_netlist library target netlist)
  hwffd_verilate(${library} NETLIST TOP hwffd_stream
    SOURCES ${netlist} ${netlist_cells_${target}} ${netlist_library_${target}})
endfunction()
