# Read by the product's project(): at its end come the rooms of the laboratory.
foreach(room IN LISTS HWFFD_LAB_ROOMS)
  cmake_language(DEFER CALL add_subdirectory ${HWFFD_LAB_DIR}/${room} ${hwffd_lab_BINARY_DIR}/${room})
endforeach()
