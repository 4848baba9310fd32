# Compiles each header of lanes and kernels by itself: what it needs it includes. Kernels' headers also
# for AVX2, where the processor's architecture has it. Needs: compiler, source, processor.
cmake_minimum_required(VERSION 3.25)

file(GLOB headers ${source}/src/simd/*.h ${source}/src/*/kernels/*.h ${source}/src/cost/split_cost.h)
list(REMOVE_ITEM headers ${source}/src/simd/foreach_set.h) # after the definitions it describes

set(of_kernels)
foreach(header IN LISTS headers)
  file(STRINGS ${header} toggles REGEX "COPPICE_SIMD_TOGGLE$")
  if(toggles)
    list(APPEND of_kernels ${header})
  endif()
endforeach()

set(failed FALSE)
function(compile_alone flags)
  execute_process(
    COMMAND ${compiler} -std=c++20 -fsyntax-only -w -x c++ ${flags} -I${source}/include -I${source}/src ${ARGN}
    RESULT_VARIABLE result)
  if(result)
    set(failed TRUE PARENT_SCOPE)
  endif()
endfunction()

compile_alone("" ${headers})
if(processor MATCHES "x86_64|AMD64")
  compile_alone("-DCOPPICE_SIMD_ISA=4" ${of_kernels}) # COPPICE_SIMD_AVX2
endif()
if(failed)
  message(FATAL_ERROR "a header does not compile by itself: include what it needs in it")
endif()
