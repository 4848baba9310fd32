# cmake -D way=find_package|add_subdirectory -D ... -P run.cmake
# Configures, builds and runs tests/consume against a fresh install of a build, or against the sources.

function(run)
  execute_process(COMMAND ${ARGV} WORKING_DIRECTORY ${work} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${work})
file(MAKE_DIRECTORY ${work})
if(way STREQUAL "find_package")
  run(${CMAKE_COMMAND} --install ${coppice_build} --prefix ${work}/prefix)
  set(how -DCMAKE_PREFIX_PATH=${work}/prefix)
else()
  set(how -DCOPPICE_SOURCE=${coppice_source})
endif()

run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${work}/build -G ${generator}
  -DCMAKE_CXX_COMPILER=${compiler} -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0 ${how})
run(${CMAKE_COMMAND} --build ${work}/build --target consume)
run(${work}/build/consume)
