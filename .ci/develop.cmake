# cmake -C .ci/develop.cmake -S . -B build/develop: for editing. A file goes through the compiler by itself, with little
# optimisation, and once if there is a ccache.
set(CMAKE_BUILD_TYPE Release CACHE STRING "")
set(CMAKE_CXX_FLAGS_RELEASE -O1 CACHE STRING "")
set(CMAKE_UNITY_BUILD OFF CACHE BOOL "")
find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE} CACHE STRING "")
endif()
