# coppice::core. Parts of fmt that it uses are compiled into it and hidden.
find_package(fmt REQUIRED)

set(COPPICE_TASKING tbb CACHE STRING "What runs tasks: tbb, or serial without threads and without oneTBB")
set_property(CACHE COPPICE_TASKING PROPERTY STRINGS tbb serial)
if(NOT COPPICE_TASKING MATCHES "^(tbb|serial)$")
  message(FATAL_ERROR "COPPICE_TASKING is '${COPPICE_TASKING}': set it to tbb or serial")
endif()

coppice_module_sources(sources ${core_modules})
list(FILTER sources EXCLUDE REGEX "/base/tasking_[a-z]+\\.cpp$")
coppice_library(core ${sources} base/tasking_${COPPICE_TASKING}.cpp)
coppice_precompile(coppice_core <algorithm> <functional> <string> <vector> <fmt/format.h>)
target_link_libraries(coppice_core PRIVATE $<BUILD_INTERFACE:fmt::fmt-header-only>)
if(COPPICE_TASKING STREQUAL "tbb")
  find_package(TBB REQUIRED)
  target_link_libraries(coppice_core PRIVATE TBB::tbb)
endif()

# What oneTBB's headers copy, in memory that it orders itself, clang's thread sanitizer would take for
# our copies, which tests/tsan.supp could not tell apart.
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  set_source_files_properties(base/tasking_tbb.cpp PROPERTIES
    COMPILE_OPTIONS "-mllvm;-tsan-instrument-memintrinsics=0")
endif()
