# HWFFD_PYTHON_TOOL: the beginning of a command that runs a module of the checkout, as in
#   COMMAND ${HWFFD_PYTHON_TOOL} tools.synth.netlist <argument>...
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(HWFFD_PYTHON_TOOL
  ${CMAKE_COMMAND} -E env "PYTHONPATH=${hwffd_SOURCE_DIR}" ${Python3_EXECUTABLE} -B -m)
