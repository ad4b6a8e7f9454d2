# The table of registers, rtl/bus/registers.csv, and the version: RTL, C headers and document follow
# from them. They are committed; here they are brought up to date.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
  ${HWFFD_RTL_DIR}/bus/registers.csv ${HWFFD_RTL_DIR}/bus/registers_preamble.md
  ${CMAKE_SOURCE_DIR}/VERSION ${CMAKE_SOURCE_DIR}/scripts/version.py
  ${CMAKE_SOURCE_DIR}/scripts/registers.py ${CMAKE_SOURCE_DIR}/scripts/register_rtl.py
  ${CMAKE_SOURCE_DIR}/scripts/register_texts.py)
execute_process(COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_SOURCE_DIR}/scripts/registers.py write
  RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "the table of registers is broken; see the line above")
endif()
