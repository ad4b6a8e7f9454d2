# Tables that CMake reads, and the names of features in them.

# hwffd_features(<result> <where> <name>[+<name>...])
#
# The value of FEATURES, of the names of its bits (rtl/bus/registers.csv).
function(hwffd_features result where names)
  set(value 0)
  string(REPLACE + ";" words ${names})
  foreach(name IN LISTS words)
    if(NOT DEFINED HWFFD_FEATURE_${name})
      list(JOIN HWFFD_FEATURES ", " known)
      message(FATAL_ERROR "${where}: FEATURES=${names}: unknown feature '${name}': some of ${known} wanted, with + between")
    endif()
    math(EXPR value "${value} | ${HWFFD_FEATURE_${name}}")
  endforeach()
  set(${result} ${value} PARENT_SCOPE)
endfunction()

# hwffd_row(<where> <head> <row>)
#
# A row of a table, whose head names its columns; a comma, or blanks, stand between its cells. It sets a variable of
# each column's name, and `parameters`, NAME=value of those in capitals.
function(hwffd_row where head row)
  string(REGEX MATCHALL "[^ ,]+" columns "${head}")
  string(REGEX MATCHALL "[^ ,]+" cells "${row}")
  list(LENGTH columns wanted)
  list(LENGTH cells count)
  if(NOT count EQUAL wanted)
    message(FATAL_ERROR "${where}: ${count} cells, ${wanted} wanted: ${head}")
  endif()
  set(parameters "")
  foreach(column cell IN ZIP_LISTS columns cells)
    if(column MATCHES "^FEATURES$")
      hwffd_features(cell ${where} ${cell})
    endif()
    if(column MATCHES "^[A-Z_]+$")
      list(APPEND parameters ${column}=${cell})
    endif()
    set(${column} ${cell} PARENT_SCOPE)
  endforeach()
  set(parameters ${parameters} PARENT_SCOPE)
endfunction()
