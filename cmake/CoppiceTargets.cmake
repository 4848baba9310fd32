# What every target of coppice shares: the language level, the warnings, where programs are put,
# and the one way in which files are found.
include_guard()
include(GNUInstallDirs)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
if(PROJECT_IS_TOP_LEVEL)
  set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
endif()

# coppice_sources(<variable> <folder>): all .cpp files below a folder; a new file needs no list.
function(coppice_sources variable folder)
  file(GLOB_RECURSE found CONFIGURE_DEPENDS ${folder}/*.cpp)
  set(${variable} ${found} PARENT_SCOPE)
endfunction()

# Where time is short: code outside the library waits for nothing but its compilation.
set(COPPICE_OUTER_FLAGS "" CACHE STRING "More compiler flags of all our code but the library")

# coppice_target(<target>): the compile options of our own code.
function(coppice_target target)
  if(NOT target MATCHES "^coppice_(core|io)$")
    separate_arguments(outer_flags NATIVE_COMMAND "${COPPICE_OUTER_FLAGS}")
    target_compile_options(${target} PRIVATE ${outer_flags})
  endif()
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wshadow
    -Wno-missing-field-initializers # {.rate = 0.05} leaves the rest at its defaults on purpose
    # In clang-tidy's place, whose modernize-use-nullptr mistakes what C++20 makes of `tuple < tuple`;
    # and g++ 12 is wrong about "a" + std::string (GCC bug 105651).
    # a & b of two conditions means without a branch.
    $<$<CXX_COMPILER_ID:Clang>:-Wno-bitwise-instead-of-logical -Wno-shadow> # the latter: of friends, too
    $<$<CXX_COMPILER_ID:GNU>:-Wzero-as-null-pointer-constant -Wno-restrict>)
  if(COPPICE_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()

# coppice_precompile(<target> <header>...): parses what most sources of a target include once. Of use
# only without ccache, which does not keep what was compiled so.
if(CMAKE_CXX_COMPILER_LAUNCHER)
  option(COPPICE_PRECOMPILE "Precompile headers" OFF)
else()
  option(COPPICE_PRECOMPILE "Precompile headers" ON)
endif()
function(coppice_precompile target)
  if(COPPICE_PRECOMPILE)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()

# coppice_compile_together(<target>): most of what small sources take to compile is what they include.
# Not for the library, which is to be compiled as others compile it, nor in the preset `dev`, where
# one source changes at a time.
set(COPPICE_TOGETHER 0 CACHE STRING "Sources of workbench, program and tests to compile as one; 0: each alone")
function(coppice_compile_together target)
  if(COPPICE_TOGETHER)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${COPPICE_TOGETHER})
    # Another source's definitions are shadowed, and g++ is wrong about what it then inlines.
    target_compile_options(${target} PRIVATE -Wno-shadow
      $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  endif()
endfunction()

# coppice_embed(<target> <symbol> <file>): puts a file's bytes into a target, readable through
#   extern "C" const char <symbol>_begin[], <symbol>_end[];
function(coppice_embed target symbol file)
  set(assembly ${CMAKE_CURRENT_BINARY_DIR}/${symbol}.S)
  file(CONFIGURE OUTPUT ${assembly} @ONLY CONTENT [[
.section .rodata
.global @symbol@_begin
.global @symbol@_end
@symbol@_begin:
.incbin "@file@"
@symbol@_end:
.byte 0
.section .note.GNU-stack,"",%progbits
]])
  set_source_files_properties(${assembly} PROPERTIES OBJECT_DEPENDS ${file})
  target_sources(${target} PRIVATE ${assembly})
endfunction()
