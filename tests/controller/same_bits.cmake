# The controllers of `profile: misra` and of `language: c` beside the plain one in C++: the same bits, see
# same_bits.c. A shared library of each needs no other. With LOOPS, against controllers whose dynamics loop over
# links: other roundings, and those of both profiles are the same again.
# cmake -DTREELINE=program -DROBOTS=dir -DSOURCE=dir -DFOLDER=dir -DHOST=c++ -P same_bits.cmake
cmake_minimum_required(VERSION 3.25)
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
file(REMOVE_RECURSE ${FOLDER})
file(READ ${SOURCE}/puma.yaml scene)
file(WRITE ${FOLDER}/scene.yaml "${scene}\nlanes: 1\n")  # the safe one has none
if(NOT LOOPS)  # which do every task whole
  run(${CMAKE_COMMAND} -DFILE=${FOLDER}/scene.yaml -P ${SOURCE}/add_behaviours.cmake)
endif()

set(level -O2)
if(LOOPS)
  set(level -O1)  # where a loop clears an array more makes a call of memset
endif()
set(warnings -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wmissing-declarations -Werror)
# The controller `name` in `folder`, compiled as C where its options say so; further compilers come behind.
function(make_controller folder name compiler)
  run(${TREELINE} generate ${ROBOTS}/puma560/puma560.urdf ${FOLDER}/scene.yaml --name ${name}
    ${ARGN} --output ${folder}/${name})
  set(standard -std=c++17 -fno-exceptions -fno-rtti)
  file(GLOB sources ${folder}/${name}/controller*.cpp)
  if("c" IN_LIST ARGN)
    set(standard -std=c99 -Wstrict-prototypes)
    file(GLOB sources ${folder}/${name}/controller*.c)
  endif()
  run(${compiler} ${standard} ${level} ${warnings} -ffp-contract=off -fPIC -shared -nostdlib -ffreestanding
    -Wl,--no-undefined -I${folder}/${name} ${sources} -o ${folder}/lib${name}.so)
endfunction()

function(compare folder)
  run(gcc -std=c99 -Wall -Wextra -Werror ${ARGN} ${SOURCE}/same_bits.c -L${folder}
    -I${folder}/puma_arm -I${folder}/puma_safe -lpuma_arm -lpuma_safe -lm -Wl,-rpath,${folder}
    -o ${folder}/same_bits)
  run(${folder}/same_bits)
endfunction()

if(LOOPS)
  # For a processor that computes doubles by calls loops are smaller than PUMA's straight lines.
  set(size --optimize size --target cortex-m4f)
  make_controller(${FOLDER}/roundings puma_arm ${HOST})
  make_controller(${FOLDER}/roundings puma_safe ${HOST} ${size})
  file(STRINGS ${FOLDER}/roundings/puma_safe/controller_task_torque.cpp loops REGEX "link_functions")
  if(NOT loops)
    message(FATAL_ERROR "the task torque does not loop over links")
  endif()
  compare(${FOLDER}/roundings -DTOLERANCE=1e-9)
  make_controller(${FOLDER}/bits puma_arm ${HOST} ${size})
  make_controller(${FOLDER}/bits puma_safe ${HOST} ${size} --profile misra)
  compare(${FOLDER}/bits)
  make_controller(${FOLDER}/bits puma_safe gcc ${size} --language c)
  compare(${FOLDER}/bits)
else()
  make_controller(${FOLDER} puma_arm ${HOST})
  make_controller(${FOLDER} puma_safe ${HOST} --profile misra)
  compare(${FOLDER})
  make_controller(${FOLDER} puma_safe gcc --language c)
  compare(${FOLDER})
  make_controller(${FOLDER} puma_safe clang --language c --profile misra)
  compare(${FOLDER})
endif()
