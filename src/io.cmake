# coppice::io, and the libraries that read files for it.
find_package(ZLIB REQUIRED)
find_package(tinyobjloader REQUIRED)
find_package(nlohmann_json REQUIRED)

set(COPPICE_WITH_ASSIMP AUTO CACHE STRING "Read STL, glTF, COLLADA and others by Assimp: AUTO (if found), ON, OFF")
set_property(CACHE COPPICE_WITH_ASSIMP PROPERTY STRINGS AUTO ON OFF)
set(COPPICE_HAS_ASSIMP OFF)
if(COPPICE_WITH_ASSIMP STREQUAL "AUTO")
  find_package(assimp QUIET)
  set(COPPICE_HAS_ASSIMP ${assimp_FOUND})
  if(NOT assimp_FOUND)
    message(STATUS "Assimp not found (Debian: libassimp-dev): no STL, glTF, COLLADA and others")
  endif()
elseif(COPPICE_WITH_ASSIMP)
  find_package(assimp REQUIRED)
  set(COPPICE_HAS_ASSIMP ON)
endif()

coppice_module_sources(sources ${io_modules})
if(COPPICE_HAS_ASSIMP)
  list(FILTER sources EXCLUDE REGEX "/io/no_scene_file\\.cpp$")
else()
  list(FILTER sources EXCLUDE REGEX "/io/(load_scene_file|assimp_log)\\.cpp$")
endif()
coppice_library(io ${sources})
coppice_precompile(coppice_io <algorithm> <functional> <string> <vector> <fmt/format.h>)
target_link_libraries(coppice_io
  PUBLIC coppice_core nlohmann_json::nlohmann_json
  PRIVATE fmt::fmt ZLIB::ZLIB tinyobjloader::tinyobjloader)
if(COPPICE_HAS_ASSIMP)
  target_link_libraries(coppice_io PRIVATE assimp::assimp)
endif()
set(COPPICE_HAS_ASSIMP ${COPPICE_HAS_ASSIMP} PARENT_SCOPE) # for tests and the package
