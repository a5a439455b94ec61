# The controller of `profile: misra` beside the plain one: the same bits, see same_bits.c. A shared
# library of it needs no other. With LOOPS, both against controllers whose dynamics loop over links:
# other roundings, and those of both profiles are the same again.
# cmake -DTREELINE=program -DROBOTS=dir -DSOURCE=dir -DFOLDER=dir -DHOST=c++ -P same_bits.cmake
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
file(REMOVE_RECURSE ${FOLDER})
file(READ ${SOURCE}/puma.yaml scene)
file(WRITE ${FOLDER}/scene.yaml "${scene}\nlanes: 1\n")  # the safe one has none

set(level -O2)
if(LOOPS)
  set(level -O1)  # where a loop clears an array more makes a call of memset
endif()
# The controllers puma_arm and puma_safe in `folder`, each with options of its own.
function(make_pair folder plain_options safe_options)
  foreach(name puma_arm puma_safe)
    set(options ${plain_options})
    if(name STREQUAL "puma_safe")
      set(options ${safe_options})
    endif()
    run(${TREELINE} generate ${ROBOTS}/puma560/puma560.urdf ${FOLDER}/scene.yaml --name ${name}
      ${options} --output ${folder}/${name})
    file(GLOB sources ${folder}/${name}/controller*.cpp)
    run(${HOST} -std=c++17 ${level} -ffp-contract=off -fPIC -shared -nostdlib -ffreestanding
      -fno-exceptions -fno-rtti -Wl,--no-undefined -I${folder}/${name} ${sources}
      -o ${folder}/lib${name}.so)
  endforeach()
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
  make_pair(${FOLDER}/roundings "" "${size}")
  file(STRINGS ${FOLDER}/roundings/puma_safe/controller_task_torque.cpp loops REGEX "link_functions")
  if(NOT loops)
    message(FATAL_ERROR "the task torque does not loop over links")
  endif()
  compare(${FOLDER}/roundings -DTOLERANCE=1e-9)
  make_pair(${FOLDER}/bits "${size}" "${size};--profile;misra")
  compare(${FOLDER}/bits)
else()
  make_pair(${FOLDER} "" "--profile;misra")
  compare(${FOLDER})
endif()
