# What rows/machine.h tells about the build. The git revision is looked up at every build, but only
# a changed one recompiles its one small file.
string(TOUPPER "${CMAKE_BUILD_TYPE}" stamp_config)
string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${stamp_config}}" stamp_flags)
set_property(SOURCE ${CMAKE_CURRENT_LIST_DIR}/machine.cpp APPEND PROPERTY COMPILE_DEFINITIONS
  COPPICE_BUILD_TYPE="${CMAKE_BUILD_TYPE}"
  COPPICE_COMPILER_FLAGS="${stamp_flags}")

set(revision_source ${CMAKE_CURRENT_BINARY_DIR}/git_revision.cpp)
add_custom_target(coppice_git_revision
  BYPRODUCTS ${revision_source}
  COMMAND ${CMAKE_COMMAND} -D source=${PROJECT_SOURCE_DIR} -D output=${revision_source}
    -P ${CMAKE_CURRENT_LIST_DIR}/write_git_revision.cmake
  COMMENT "Looking up the git revision")
add_dependencies(coppice_workbench coppice_git_revision)
target_sources(coppice_workbench PRIVATE ${revision_source})
