# What rows/machine.h tells about the build. The git revision is looked up at every build, but only
# a changed one recompiles its one small file.
string(TOUPPER "${CMAKE_BUILD_TYPE}" stamp_config)
string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${stamp_config}}" stamp_flags)
set(stamp_source ${CMAKE_CURRENT_BINARY_DIR}/stamp.cpp)
file(CONFIGURE OUTPUT ${stamp_source} @ONLY CONTENT [[
#include "rows/machine.h"

std::string_view coppice::lab::build_type() noexcept {
    return "@CMAKE_BUILD_TYPE@";
}

std::string_view coppice::lab::compiler_flags() noexcept {
    return R"(@stamp_flags@)";
}
]])

set(revision_source ${CMAKE_CURRENT_BINARY_DIR}/git_revision.cpp)
add_custom_target(coppice_git_revision
  BYPRODUCTS ${revision_source}
  COMMAND ${CMAKE_COMMAND} -D source=${PROJECT_SOURCE_DIR} -D output=${revision_source}
    -P ${CMAKE_CURRENT_LIST_DIR}/write_git_revision.cmake
  COMMENT "Looking up the git revision")
add_dependencies(coppice_workbench coppice_git_revision)
target_sources(coppice_workbench PRIVATE ${stamp_source} ${revision_source})
# Alone, so that a new revision recompiles nothing else; of so little no precompiled header is due.
set_source_files_properties(${stamp_source} ${revision_source} PROPERTIES
  SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
