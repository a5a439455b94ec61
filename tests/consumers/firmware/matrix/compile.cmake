# Compiles the prepared code with KIND, with the compiler's own C headers only, and fails at a warning
# or at a call of anything but the compiler's arithmetic.
# cmake -DKIND=g++|clang++|gcc|clang -DCASES=core:real:level:level...,... -DSOURCE=the repository -DFOLDER=dir -P compile.cmake
include(${CMAKE_CURRENT_LIST_DIR}/../cores.cmake)
set(warnings -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wdouble-promotion -Wshadow -Werror)
if(KIND MATCHES "\\+\\+")
  set(source everything.cpp)
  list(APPEND warnings -Wold-style-cast)
else()
  set(source everything.c)
  set(freestanding ${freestanding_c})
  list(APPEND warnings -Wstrict-prototypes -Wmissing-prototypes)
endif()
if(KIND STREQUAL "g++")
  list(APPEND warnings -Wuseless-cast)
endif()
# What libgcc and compiler-rt are for: __aeabi_dmul, __muldf3, __udivsi3, ...
set(arithmetic "__aeabi_(d|f|i|ui|l|ul|lcmp|ulcmp)[a-z0-9_]*|__(add|sub|mul|div|udiv|mod|umod|neg|eq|ne|lt|le|gt|ge|unord|fix|fixuns|float|floatun|extend|trunc|ashl|ashr|lshr|clz)[a-z]*[sdt]+[fi]*[sdt]*[fi]*[234]?")

# check(CORE REAL LEVEL)
function(check core real level)
  set(choice)
  if(KIND MATCHES "^g" AND core STREQUAL "m0" AND level STREQUAL "-O0")
    set(choice -DWITHOUT_VECTORS)  # the one exception, which headers of batches and lanes in C state
  endif()
  set(object ${FOLDER}/${KIND}_${core}_${real}${level}.o)
  execute_process(COMMAND ${compiler} ${freestanding} ${flags_${core}} ${level} ${warnings}
      ${choice} -nostdinc -isystem ${headers} -I${FOLDER}/${real} -I${SOURCE} -I${SOURCE}/runtime
      -c ${FOLDER}/${real}/${source} -o ${object}
    COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${nm} -u ${object} OUTPUT_VARIABLE calls COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX REPLACE "[ \n]+U " ";" calls "\n ${calls}")
  foreach(call IN LISTS calls)
    string(STRIP "${call}" call)
    if(call AND NOT call MATCHES "^(${arithmetic}|_GLOBAL_OFFSET_TABLE_)$")
      message(SEND_ERROR "${KIND} ${level} for ${core} in ${real} calls ${call}")
    endif()
  endforeach()
endfunction()

string(REPLACE "," ";" CASES "${CASES}")
foreach(case IN LISTS CASES)
  string(REPLACE ":" ";" case ${case})
  list(POP_FRONT case core real)
  find_cross(${KIND} ${core} compiler)
  find_tool(${prefix_${core}}nm nm)
  execute_process(COMMAND ${compiler} -print-file-name=include OUTPUT_VARIABLE headers
    OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  foreach(level IN LISTS case)
    check(${core} ${real} -${level})
  endforeach()
endforeach()
