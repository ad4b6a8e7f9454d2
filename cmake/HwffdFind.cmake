# hwffd_find(<package> <words of find_package>...)
#
# A package that must be there, or one line that says what brings it.
macro(hwffd_find package)
  find_package(${package} ${ARGN} QUIET)
  if(NOT ${package}_FOUND)
    message(FATAL_ERROR "${package} not found: tools/install build installs it")
  endif()
endmacro()

# hwffd_find_program(<variable> <name>): the same of a program.
macro(hwffd_find_program variable name)
  find_program(${variable} ${name})
  if(NOT ${variable})
    message(FATAL_ERROR "${name} not found: tools/install build installs it")
  endif()
endmacro()
