# `cmake --install`: the libraries with their headers, CMake package and pkg-config files, the program
# if it was built. The package has a component for each library: core, io.
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/coppice)
set(to_develop COMPONENT coppice_development)

# coppice_install_library(<part> <target>...)
function(coppice_install_library part)
  install(TARGETS ${ARGN} EXPORT coppice-${part}-targets
    LIBRARY COMPONENT coppice_runtime NAMELINK_COMPONENT coppice_development
    ARCHIVE ${to_develop})
  install(EXPORT coppice-${part}-targets NAMESPACE coppice:: DESTINATION ${package_folder} ${to_develop})
  configure_file(${PROJECT_SOURCE_DIR}/cmake/coppice-${part}.pc.in
    ${PROJECT_BINARY_DIR}/coppice-${part}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/coppice-${part}.pc
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig ${to_develop})
endfunction()

# pkg-config files find their prefix from where they are: what is installed may be moved.
file(RELATIVE_PATH pc_prefix /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
set(pc_define "")
set(pc_core_requires "")
set(pc_io_requires "")
if(NOT BUILD_SHARED_LIBS) # a static library leaves it to its user to link what it uses itself
  set(pc_define " -DCOPPICE_STATIC")
  set(pc_io_requires "zlib fmt tinyobjloader")
  if(COPPICE_TASKING STREQUAL "tbb")
    set(pc_core_requires "tbb")
  endif()
  if(COPPICE_HAS_ASSIMP)
    string(APPEND pc_io_requires " assimp")
  endif()
endif()

set(no_headers "")
coppice_install_library(core coppice_core)
if(COPPICE_BUILD_IO)
  coppice_install_library(io coppice_io coppice)
else()
  foreach(of_io IN ITEMS io store json coppice.h)
    list(APPEND no_headers PATTERN include/coppice/${of_io} EXCLUDE)
  endforeach()
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/coppice TYPE INCLUDE ${to_develop} ${no_headers})

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/coppiceConfig.cmake.in
  ${PROJECT_BINARY_DIR}/coppiceConfig.cmake INSTALL_DESTINATION ${package_folder})
# Before 1.0 a minor version may break a user's code.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/coppiceConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/coppiceConfig.cmake
  ${PROJECT_BINARY_DIR}/coppiceConfigVersion.cmake DESTINATION ${package_folder} ${to_develop})

if(TARGET coppice_cli)
  install(TARGETS coppice_cli)
endif()
