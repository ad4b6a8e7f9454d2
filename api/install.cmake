# What `cmake --install` puts beside the library: headers, and how CMake and pkg-config find it. Each
# component of find_package is a file of targets.
include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/hwffd)

install(TARGETS hwffd EXPORT hwffd_core LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY include/hwffd
  ${hwffd_SOURCE_DIR}/golden/include/hwffd
  ${hwffd_SOURCE_DIR}/geometry/include/hwffd
  ${hwffd_SOURCE_DIR}/registration/include/hwffd
  ${hwffd_SOURCE_DIR}/cores/include/hwffd
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  PATTERN cores EXCLUDE)  # interfaces of simulated cores

set(components core)
if(NOT HWFFD_LIBRARY_ONLY)
  list(APPEND components gl rtl)
endif()
foreach(component IN LISTS components)
  install(EXPORT hwffd_${component} NAMESPACE hwffd:: FILE hwffd-${component}.cmake
    DESTINATION ${package})
endforeach()

configure_package_config_file(hwffdConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/hwffdConfig.cmake
  INSTALL_DESTINATION ${package})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/hwffdConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/hwffdConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/hwffdConfigVersion.cmake DESTINATION ${package})

configure_file(hwffd.pc.in ${CMAKE_CURRENT_BINARY_DIR}/hwffd.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/hwffd.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
