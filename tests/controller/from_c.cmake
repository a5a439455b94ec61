# A controller from C: the header compiles as C99 without a warning, and a program in C steps the
# controller that a shared library holds. The library needs no other.
# cmake -DTREELINE=program -DROBOTS=dir -DSOURCE=dir -DFOLDER=dir -DHOST=c++ -P from_c.cmake
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
file(MAKE_DIRECTORY ${FOLDER})
run(${TREELINE} generate ${ROBOTS}/puma560/puma560.urdf ${SOURCE}/puma.yaml --output ${FOLDER}/puma_arm)
set(generated ${FOLDER}/puma_arm)
run(${HOST} -std=c++17 -O2 -fPIC -shared -nostdlib -ffreestanding -fno-exceptions -fno-rtti
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wmissing-declarations -Werror -Wl,--no-undefined -I${generated}
  ${generated}/controller.cpp ${generated}/controller_kinematics.cpp
  ${generated}/controller_joint_torque.cpp ${generated}/controller_push_torque.cpp
  ${generated}/controller_task_torque.cpp
  -o ${FOLDER}/libpuma_arm.so)
run(gcc -std=c99 -pedantic -Wall -Wextra -Wconversion -Wshadow -Wstrict-prototypes -Werror
  -I${generated} ${SOURCE}/from_c.c -L${FOLDER} -lpuma_arm -Wl,-rpath,${FOLDER} -o ${FOLDER}/from_c)
run(${FOLDER}/from_c)
