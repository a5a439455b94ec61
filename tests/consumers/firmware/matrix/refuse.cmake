# The emitted header stops the compiler at flags that change results, with words that say what to do,
# and takes them where they are taken back.
# cmake -DKIND=g++|clang++|gcc|clang -DFOLDER=dir -P refuse.cmake
include(${CMAKE_CURRENT_LIST_DIR}/../cores.cmake)
if(KIND MATCHES "\\+\\+")
  set(language c++)
  set(header arm/arm.hpp)
else()
  set(language c)
  set(header c_arm/c_arm.h)
  set(freestanding ${freestanding_c})
endif()

# compile(CORE MESSAGE FLAGS...): MESSAGE is in what the compiler says; empty: it says nothing.
function(compile core message)
  find_cross(${KIND} ${core} compiler)
  execute_process(COMMAND ${compiler} ${freestanding} ${flags_${core}} ${ARGN} -fsyntax-only
      -x ${language} ${FOLDER}/double/${header}
    RESULT_VARIABLE failed ERROR_VARIABLE said)
  string(REGEX REPLACE "[^\n]*#pragma once in main file[^\n]*\n([^\n]*\n[^\n]*\n)?" "" said "${said}")
  if(message)
    string(FIND "${said}" "${message}" at)
    if(NOT failed OR at EQUAL -1)
      message(SEND_ERROR "${KIND} for ${core} with ${ARGN} is not refused by '${message}': ${said}")
    endif()
  elseif(failed)
    message(SEND_ERROR "${KIND} for ${core} with ${ARGN}: ${said}")
  endif()
endfunction()

foreach(core host m0 m4f m7 rv32 a64)
  compile(${core} "" -O2)
  compile(${core} "compile without -ffast-math" -O2 -ffast-math)
  compile(${core} "compile without -ffast-math" -Ofast)
  compile(${core} "compile without -ffinite-math-only" -ffinite-math-only)
  compile(${core} "" -Ofast -fno-fast-math)
endforeach()
compile(host "add -msse2 -mfpmath=sse" -m32 -mno-sse)
if(KIND MATCHES "^g")
  compile(m7 "compile without -ffast-math" -funsafe-math-optimizations)
  compile(m7 "compile without -ffast-math" -freciprocal-math)
endif()
