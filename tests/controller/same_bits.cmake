# The controller of `profile: misra` beside the plain one: the same bits, see same_bits.c. A shared
# library of it needs no other.
# cmake -DTREELINE=program -DROBOTS=dir -DSOURCE=dir -DFOLDER=dir -DHOST=c++ -P same_bits.cmake
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
file(REMOVE_RECURSE ${FOLDER})
file(READ ${SOURCE}/puma.yaml scene)
file(WRITE ${FOLDER}/scene.yaml "${scene}\nlanes: 1\n")  # the safe one has none
set(libraries)
foreach(name puma_arm puma_safe)
  set(profile plain)
  if(name STREQUAL "puma_safe")
    set(profile misra)
  endif()
  run(${TREELINE} generate ${ROBOTS}/puma560/puma560.urdf ${FOLDER}/scene.yaml --name ${name}
    --profile ${profile} --output ${FOLDER}/${name})
  file(GLOB sources ${FOLDER}/${name}/controller*.cpp)
  run(${HOST} -std=c++17 -O2 -ffp-contract=off -fPIC -shared -nostdlib -ffreestanding
    -fno-exceptions -fno-rtti -Wl,--no-undefined -I${FOLDER}/${name} ${sources}
    -o ${FOLDER}/lib${name}.so)
  list(APPEND libraries -I${FOLDER}/${name} -l${name})
endforeach()
run(gcc -std=c99 -Wall -Wextra -Werror ${SOURCE}/same_bits.c -L${FOLDER} ${libraries} -lm
  -Wl,-rpath,${FOLDER} -o ${FOLDER}/same_bits)
run(${FOLDER}/same_bits)
