# Netlists as ordinary build steps: a row of the table through yosys, and what comes out through
# Verilator, with models of the target's cells. yosys is wanted by the steps, not while CMake configures.

file(GLOB netlist_steps CONFIGURE_DEPENDS ${hwffd_SOURCE_DIR}/synth/*.ys
     ${hwffd_SOURCE_DIR}/synth/*/*.v ${hwffd_SOURCE_DIR}/synth/*/*.map
     ${hwffd_SOURCE_DIR}/synth/*/*.txt)

# hwffd_of_yosys(<name> <copy> [<file>])
#
# Copies a file of those that yosys brings, or a folder, of which <file> is one. Who takes it depends on
# the file and on the target hwffd_of_yosys.
add_custom_target(hwffd_of_yosys)
function(hwffd_of_yosys name copy)
  string(MAKE_C_IDENTIFIER of_yosys_${name} target)
  add_custom_command(
    OUTPUT ${copy}${ARGN}
    COMMAND ${HWFFD_PYTHON_TOOL} tools.synth.yosys_files ${name} ${copy}
    DEPENDS ${hwffd_SOURCE_DIR}/tools/synth/yosys_files.py
    VERBATIM)
  add_custom_target(${target} DEPENDS ${copy}${ARGN})
  add_dependencies(hwffd_of_yosys ${target})
endfunction()

# The cells of a target: ours, and yosys' own for the others. (Gates need none.)
foreach(cells ecp5,ecp5 gw5a,gowin)
  hwffd_row(cells target,folder ${cells})
  set(copy ${hwffd_BINARY_DIR}/netlists/cells/${target}.v)
  hwffd_of_yosys(${folder}/cells_sim.v ${copy})
  file(GLOB netlist_cells_${target} CONFIGURE_DEPENDS ${hwffd_SOURCE_DIR}/tb/cells/${target}/*.v)
  set(netlist_library_${target} LIBRARY ${copy} AFTER hwffd_of_yosys)
endforeach()

# hwffd_netlist(<identifier> <target> [<variant>])
#
# Makes the static library <identifier>_<target>_netlist, as hwffd_verilate does, of the netlist of a row,
# or of one of synth/variants.csv, whose identifier ends with the word of the variant. It is made once,
# however many ask for it; so is that of a fault.
function(hwffd_netlist id target)
  if(TARGET ${id}_${target}_netlist)
    return()
  endif()
  set(name ${HWFFD_CONFIGURATION_NAME_${id}})
  if(ARGC GREATER 2)
    string(REGEX REPLACE "_${ARGV2}$" "" row ${id})
    set(name ${HWFFD_CONFIGURATION_NAME_${row}}+${ARGV2})
  endif()
  set(netlist ${hwffd_BINARY_DIR}/netlists/${id}_${target}.v)
  file(GLOB headers CONFIGURE_DEPENDS ${HWFFD_RTL_DIR}/*/*.vh)
  add_custom_command(
    OUTPUT ${netlist}
    COMMAND ${HWFFD_PYTHON_TOOL} tools.synth.netlist
            ${name} ${target} ${netlist}
    DEPENDS ${HWFFD_RTL_SOURCES} ${headers} ${HWFFD_RTL_DIR}/configurations.csv
            ${HWFFD_RTL_DIR}/organizations.csv ${hwffd_SOURCE_DIR}/synth/variants.csv ${netlist_steps}
            ${hwffd_SOURCE_DIR}/tools/synth/netlist.py ${hwffd_SOURCE_DIR}/tools/synth/synthesis.py ${hwffd_SOURCE_DIR}/tools/rtl/rtl_sources.py
    COMMENT "Synthesizing the netlist of ${id} for ${target}"
    VERBATIM)
  hwffd_verilate_netlist(${id}_${target}_netlist ${target} ${netlist})
endfunction()

# hwffd_faulty_netlist(<identifier>)
#
# The same as <identifier>_fault_netlist, of a copy of the netlist for ecp5 in which one LUT is wrong.
function(hwffd_faulty_netlist id)
  if(TARGET ${id}_fault_netlist)
    return()
  endif()
  set(good ${hwffd_BINARY_DIR}/netlists/${id}_ecp5.v)
  set(faulty ${hwffd_BINARY_DIR}/netlists/${id}_fault.v)
  add_custom_command(
    OUTPUT ${faulty}
    COMMAND ${HWFFD_PYTHON_TOOL} tools.synth.netlist_fault ${good} ${faulty}
    DEPENDS ${good} ${hwffd_SOURCE_DIR}/tools/synth/netlist_fault.py
    VERBATIM)
  hwffd_verilate_netlist(${id}_fault_netlist ecp5 ${faulty})
endfunction()

function(hwffd_verilate_netlist library target netlist)
  hwffd_verilate(${library} NETLIST TOP hwffd_stream
    SOURCES ${netlist} ${netlist_cells_${target}} ${netlist_library_${target}})
endfunction()
