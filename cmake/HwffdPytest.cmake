# hwffd_pytest(<set> <suite> <name>... [LABEL <label>] [FOLDER <folder>] [ARGUMENTS <word>...] [PROPERTIES <property> <value>...])
#
# Each test_<name>.py of this folder, or of one below it, is the test <suite>.<name>, by the pytest of build/venv;
# <set> is that of tests/in_venv.py. Its label is `test`, unless another is given. The fixture `arguments` has the words. Where
# some are marked as `whole`, which are left out, <suite>.<name>_whole of test-all has them all, with the same properties.
function(hwffd_pytest set suite)
  cmake_parse_arguments(PARSE_ARGV 2 pytest "" "LABEL;FOLDER" "ARGUMENTS;PROPERTIES")
  if(NOT pytest_LABEL)
    set(pytest_LABEL test)
  endif()
  list(TRANSFORM pytest_ARGUMENTS PREPEND --argument=)
  set(pytest_folder ${CMAKE_CURRENT_SOURCE_DIR})
  if(pytest_FOLDER)
    set(pytest_folder ${CMAKE_CURRENT_SOURCE_DIR}/${pytest_FOLDER})
  endif()
  foreach(name IN LISTS pytest_UNPARSED_ARGUMENTS)
    add_test(NAME ${suite}.${name}
      COMMAND ${Python3_EXECUTABLE} -B ${hwffd_SOURCE_DIR}/tests/in_venv.py ${set}
              -m pytest ${pytest_folder}/test_${name}.py ${pytest_ARGUMENTS})
    set_tests_properties(${suite}.${name} PROPERTIES LABELS ${pytest_LABEL} TIMEOUT 600 ${pytest_PROPERTIES})
    file(STRINGS ${pytest_folder}/test_${name}.py marked REGEX "mark[.]whole")
    if(marked)
      add_test(NAME ${suite}.${name}_whole
        COMMAND ${Python3_EXECUTABLE} -B ${hwffd_SOURCE_DIR}/tests/in_venv.py ${set}
                -m pytest ${pytest_folder}/test_${name}.py ${pytest_ARGUMENTS})
      set_tests_properties(${suite}.${name}_whole PROPERTIES LABELS all TIMEOUT 7200 ${pytest_PROPERTIES})
      set_property(TEST ${suite}.${name}_whole APPEND PROPERTY ENVIRONMENT HWFFD_WHOLE=1)
    endif()
  endforeach()
endfunction()
