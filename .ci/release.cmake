# cmake -C .ci/release.cmake -S . -B build: what is installed and tested. A folder at a time goes through the compiler: most of
# what its files read are the same headers.
set(CMAKE_BUILD_TYPE Release CACHE STRING "")
set(CMAKE_UNITY_BUILD ON CACHE BOOL "")
# Memory that the compiler does not collect saves it a tenth of its time.
set(CMAKE_CXX_FLAGS "--param=ggc-min-heapsize=600000" CACHE STRING "")
