// No tests: its program carries the headers that the others use (CMakeLists.txt).
