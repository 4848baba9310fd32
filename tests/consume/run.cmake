# cmake -D way=installed|add_subdirectory|fetch_content -D ... -P run.cmake
#
#   installed         the static libraries of this build, installed and then moved: find_package of core
#                     alone and of both, and pkg-config
#   add_subdirectory  static, serial tasks, without Assimp
#   fetch_content     core alone, shared; then its install by find_package and pkg-config
#
# Configures, builds and runs the programs beside this file, and looks at what they need at run time.

cmake_minimum_required(VERSION 3.25)

set(tests ${CMAKE_CURRENT_LIST_DIR})
set(options -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0)

function(run)
  execute_process(COMMAND ${ARGV} WORKING_DIRECTORY ${work} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# build(<folder> <way> <core|core,io> <option>...): the programs that use these parts, built and run.
function(build folder way parts)
  run(${CMAKE_COMMAND} -S ${tests} -B ${work}/${folder} -G ${generator} ${options}
    -DCMAKE_CXX_COMPILER=${compiler} -DCMAKE_CXX_COMPILER_LAUNCHER=${launcher} -Dway=${way}
    -Dparts=${parts} -Dcoppice_source=${coppice_source} ${ARGN})
  run(${CMAKE_COMMAND} --build ${work}/${folder})
  run(${work}/${folder}/core_alone)
  if(parts MATCHES io)
    run(${work}/${folder}/with_io)
  endif()
endfunction()

# needs_only(<file> <library>...): fails if a program or library needs another than these, those of the
# compiler and of C at run time (readelf -d).
function(needs_only file)
  execute_process(COMMAND readelf -d ${file} OUTPUT_VARIABLE dynamic COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "\\(NEEDED\\)[^[]*\\[[^]]*\\]" needed "${dynamic}")
  if(NOT needed)
    message(FATAL_ERROR "readelf -d ${file} tells nothing:\n${dynamic}")
  endif()
  foreach(line IN LISTS needed)
    string(REGEX REPLACE ".*\\[(.*)\\]" "\\1" library ${line})
    string(REGEX REPLACE "\\.so.*" "" name ${library})
    if(NOT name IN_LIST ARGN AND NOT name MATCHES "^(libstdc\\+\\+|libm|libgcc_s|libc|ld-linux.*)$")
      message(FATAL_ERROR "${file} needs ${library}")
    endif()
    message(STATUS "${file}: ${library}")
  endforeach()
endfunction()

# pkg_config(<prefix> <package> <source> <how>...): compiles a program by what pkg-config prints, at
# most three flags for the linker where `how` says so, and runs it.
function(pkg_config prefix package source)
  file(GLOB_RECURSE folder ${prefix}/*/${package}.pc)
  get_filename_component(folder ${folder} DIRECTORY)
  set(ENV{PKG_CONFIG_PATH} ${folder})
  execute_process(COMMAND pkg-config --cflags --libs ${ARGN} ${package} OUTPUT_VARIABLE flags
    OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  message(STATUS "${package}: ${flags}")
  separate_arguments(flags UNIX_COMMAND "${flags}")
  run(${compiler} -std=c++20 ${tests}/${source}.cpp ${flags} -o ${work}/${source})
  get_filename_component(libraries ${folder} DIRECTORY)
  run(${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${libraries} ${work}/${source})
endfunction()

# hides_all_but_coppice(<library>): fails if a shared library offers a symbol that is not of coppice.
function(hides_all_but_coppice library)
  execute_process(COMMAND nm -D --defined-only --demangle ${library} OUTPUT_VARIABLE symbols
    COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX REPLACE "[;[]" "." symbols "${symbols}")
  string(REGEX MATCHALL "[^\n]+" symbols "${symbols}")
  set(others ${symbols})
  list(FILTER symbols INCLUDE REGEX "coppice::v0::Scene::Scene")
  list(FILTER others EXCLUDE REGEX "^[0-9a-f]+ [A-Za-z] ((vtable|typeinfo|typeinfo name) for )?coppice::v0::")
  if(NOT symbols OR others)
    message(FATAL_ERROR "${library} must offer coppice::v0::Scene and no symbols of others: ${others}")
  endif()
endfunction()

set(tbb "")
if(tasking STREQUAL "tbb")
  set(tbb libtbb)
endif()

file(REMOVE_RECURSE ${work})
file(MAKE_DIRECTORY ${work})
if(way STREQUAL "installed")
  foreach(component IN ITEMS runtime development) # not the program, which may not be built
    run(${CMAKE_COMMAND} --install ${coppice_build} --prefix ${work}/there --component coppice_${component})
  endforeach()
  file(RENAME ${work}/there ${work}/prefix)
  build(core find_package core -DCMAKE_PREFIX_PATH=${work}/prefix)
  needs_only(${work}/core/core_alone ${tbb})
  build(both find_package core,io -DCMAKE_PREFIX_PATH=${work}/prefix)
  pkg_config(${work}/prefix coppice-core core_alone --static)
  needs_only(${work}/core_alone ${tbb})
  pkg_config(${work}/prefix coppice-io with_io --static)
elseif(way STREQUAL "add_subdirectory")
  build(build add_subdirectory core,io -DCOPPICE_TASKING=serial -DCOPPICE_WITH_ASSIMP=OFF
    -DCMAKE_DISABLE_FIND_PACKAGE_TBB=ON -DCMAKE_DISABLE_FIND_PACKAGE_assimp=ON)
  needs_only(${work}/build/core_alone)
else()
  build(build fetch_content core -DBUILD_SHARED_LIBS=ON -DCOPPICE_BUILD_IO=OFF -DCOPPICE_INSTALL=ON)
  run(${CMAKE_COMMAND} --install ${work}/build --prefix ${work}/prefix)
  file(GLOB_RECURSE library ${work}/prefix/*/libcoppice_core.so)
  needs_only(${library} ${tbb})
  hides_all_but_coppice(${library})
  build(core find_package core -DCMAKE_PREFIX_PATH=${work}/prefix)
  needs_only(${work}/core/core_alone libcoppice_core)
  pkg_config(${work}/prefix coppice-core core_alone)
endif()
