# Generates the PUMA's control torque for REAL, compiles and links it for a Cortex-M7 and tells its
# size. cmake -DTREELINE=program -DROBOTS=dir -DMAIN=main.cpp -DREAL=float|double -DFOLDER=dir
#         -DPREFIX=arm-none-eabi- -P build.cmake
set(name firmware_${REAL})
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run(${TREELINE} generate ${ROBOTS}/puma560/puma560.urdf ${ROBOTS}/puma560/scene.yaml
  --output ${FOLDER}/${name} --name ${name} --real ${REAL}
  --functions inverse_dynamics,control_torque)
set(flags -mcpu=cortex-m7 -mthumb -mfpu=fpv5-d16 -mfloat-abi=hard -std=c++17 -O2
  -ffreestanding -fno-exceptions -fno-rtti -fno-threadsafe-statics -Wall -Wextra -Wconversion -Werror
  -Wdouble-promotion)
# -nostdlib: neither libc nor libm nor the C++ library; libgcc holds what instructions cannot do.
run(${PREFIX}g++ ${flags} -nostdlib
  -DFIRMWARE_HEADER="${name}.hpp" -DFIRMWARE_NAMESPACE=${name} -I${FOLDER}/${name}
  ${MAIN} ${FOLDER}/${name}/inverse_dynamics.cpp ${FOLDER}/${name}/control_torque.cpp
  -o ${FOLDER}/${name}.elf -lgcc)
run(${PREFIX}size ${FOLDER}/${name}.elf)
