# cmake -D source=<project> -D output=<file.cpp> -P write_git_revision.cmake
# Writes the definition of coppice::lab::git_revision(), and touches the file only if it changed.
set(revision unknown)
execute_process(COMMAND git -C ${source} rev-parse --show-toplevel
  OUTPUT_VARIABLE checkout OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed ERROR_QUIET)
file(REAL_PATH ${source} real_source)
# Sources unpacked inside some other project's checkout have no revision.
if(NOT failed AND checkout STREQUAL real_source)
  execute_process(
    COMMAND git --no-optional-locks -C ${source} describe --always --dirty --abbrev=7 --exclude=*
    OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed ERROR_QUIET)
  if(NOT failed)
    set(revision ${described})
  endif()
endif()
file(CONFIGURE OUTPUT ${output} @ONLY CONTENT [[
#include "rows/machine.h"

std::string_view coppice::lab::git_revision() noexcept {
    return "@revision@";
}
]])
