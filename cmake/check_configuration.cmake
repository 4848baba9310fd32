# Refuses what cannot be built, before anything is.
foreach(part IN ITEMS WORKBENCH TESTS EXAMPLES BENCH FUZZ)
  if(COPPICE_BUILD_${part} AND NOT COPPICE_BUILD_IO)
    message(FATAL_ERROR "COPPICE_BUILD_${part} needs coppice::io: set COPPICE_BUILD_IO=ON, "
                        "or COPPICE_BUILD_${part}=OFF")
  endif()
endforeach()
foreach(part IN ITEMS TESTS BENCH FUZZ)
  if(COPPICE_BUILD_${part} AND BUILD_SHARED_LIBS)
    message(FATAL_ERROR "COPPICE_BUILD_${part} looks behind the public headers, at what shared "
                        "libraries hide: set BUILD_SHARED_LIBS=OFF, or COPPICE_BUILD_${part}=OFF")
  endif()
endforeach()

# The version is written in two places: here for CMake, there for programs.
file(READ ${PROJECT_SOURCE_DIR}/include/coppice/version.h header)
foreach(part IN ITEMS MAJOR MINOR PATCH)
  if(NOT header MATCHES "define COPPICE_VERSION_${part} ${PROJECT_VERSION_${part}}\n")
    message(FATAL_ERROR "COPPICE_VERSION_${part} in include/coppice/version.h is not that of "
                        "project(VERSION ${PROJECT_VERSION}) in CMakeLists.txt: set them equal")
  endif()
endforeach()
