# cmake -C .ci/checked.cmake -S . -B build/checked: sanitizers, and clang-tidy on every file. Lines are all that a sanitizer
# tells: variables would make up a third of the compiler's time, and memory that it collects a seventh.
set(CMAKE_BUILD_TYPE Debug CACHE STRING "")
set(CMAKE_CXX_FLAGS_DEBUG "-g1 --param=ggc-min-heapsize=600000" CACHE STRING "")
set(CMAKE_UNITY_BUILD ON CACHE BOOL "")
set(ROCKSTACK_SANITIZE ON CACHE STRING "")
set(ROCKSTACK_TIDY ON CACHE BOOL "")
# Pages without a solver are tested here, those with one in the other build.
set(ROCKSTACK_WASM OFF CACHE BOOL "")
