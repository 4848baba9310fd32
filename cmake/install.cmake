# `cmake --install`: the library with its headers and a package file, the program if it was built.
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/coppice)

install(TARGETS coppice EXPORT coppiceTargets)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/coppice TYPE INCLUDE)
install(EXPORT coppiceTargets NAMESPACE coppice:: DESTINATION ${package_folder})

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/coppiceConfig.cmake.in
  ${PROJECT_BINARY_DIR}/coppiceConfig.cmake INSTALL_DESTINATION ${package_folder})
# Before 1.0 a minor version may break a user's code.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/coppiceConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/coppiceConfig.cmake
  ${PROJECT_BINARY_DIR}/coppiceConfigVersion.cmake DESTINATION ${package_folder})

if(TARGET coppice_cli)
  install(TARGETS coppice_cli)
endif()
