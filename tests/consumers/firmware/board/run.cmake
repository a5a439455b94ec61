# Generates the PUMA's control torque in REAL, runs it on CORE under QEMU and on this machine: the same
# bits, and the same number of instructions for every state. Prints that number. On CORE it is code in
# LANGUAGE, on this machine in C++.
# cmake -DTREELINE=program -DROBOTS=dir -DSOURCE=dir above this -DFOLDER=dir -DREAL=float|double
#       -DLANGUAGE=c++|c -DCORE=m4f|m7 -DMACHINE=mps2-an386|mps2-an500 -DQEMU=program -DHOST=c++ -P run.cmake
include(${SOURCE}/cores.cmake)
if(LANGUAGE STREQUAL "c")
  set(FOLDER ${FOLDER}/c) # another test may be at work on the same in C++
endif()
set(name firmware_${CORE}_${REAL})
set(folder ${FOLDER}/${name})
set(board ${SOURCE}/board)
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run(${TREELINE} generate ${ROBOTS}/puma560/puma560.urdf ${ROBOTS}/puma560/scene.yaml
  --output ${folder} --name ${name} --real ${REAL} --functions inverse_dynamics,control_torque)
set(names -DFIRMWARE_HEADER="${name}.hpp" -DFIRMWARE_NAMESPACE=${name} -I${folder} -I${board})
set(sources ${board}/run_states.cpp ${folder}/control_torque.cpp)
find_cross(g++ ${CORE} compiler)
set(flags ${flags_${CORE}} -O2 -ffp-contract=off -Wall -Wextra -Werror)
set(names_there ${names})
set(sources_there ${sources})
if(LANGUAGE STREQUAL "c")
  set(folder ${folder}_c)
  string(TOUPPER ${name}_c capitals)
  run(${TREELINE} generate ${ROBOTS}/puma560/puma560.urdf ${ROBOTS}/puma560/scene.yaml --language c
    --output ${folder} --name ${name}_c --real ${REAL} --functions control_torque)
  find_cross(gcc ${CORE} c_compiler)
  run(${c_compiler} ${freestanding_c} ${flags} -c ${folder}/control_torque.c -o ${folder}.o)
  set(names_there -DFIRMWARE_HEADER="${name}_c.h" -DFIRMWARE_C=${name}_c
    -DFIRMWARE_C_CAPITALS=${capitals} -DFIRMWARE_NAMESPACE=c_robot -I${folder} -I${board}
    -include ${board}/c_robot.hpp)
  set(sources_there ${board}/run_states.cpp ${folder}.o)
endif()
run(${compiler} ${freestanding} ${flags} -nostdlib ${names_there} ${sources_there} ${board}/board.cpp
  -T ${board}/board.ld -o ${folder}.elf -lgcc)
run(${HOST} -std=c++17 -O2 -ffp-contract=off ${names} ${sources} ${board}/host.cpp -o ${folder}.host)

execute_process(COMMAND ${folder}.host OUTPUT_VARIABLE expected COMMAND_ERROR_IS_FATAL ANY)
# Semihosting writes to the standard error of QEMU where it has no console.
execute_process(COMMAND ${QEMU} -M ${MACHINE} -icount shift=0 -nographic -monitor none -serial none
    -semihosting-config enable=on,target=native -kernel ${folder}.elf
  OUTPUT_VARIABLE out ERROR_VARIABLE error TIMEOUT 120 COMMAND_ERROR_IS_FATAL ANY)
string(CONCAT actual "${out}" "${error}")
string(REGEX MATCH "least ([0-9a-f]+) most ([0-9a-f]+)" counted "${actual}")
set(least 0x${CMAKE_MATCH_1})
set(most 0x${CMAKE_MATCH_2})
string(REGEX REPLACE "instructions.*" "" actual "${actual}")
string(REGEX REPLACE "instructions.*" "" expected "${expected}")
if(NOT actual STREQUAL expected)
  message(FATAL_ERROR "other bits on ${CORE}:\n${actual}\nthan here:\n${expected}")
endif()
math(EXPR instructions "${most}")
math(EXPR spread "${most} - ${least}")
message(STATUS "control_torque in ${REAL} on ${CORE}: ${instructions} instructions a call")
if(spread GREATER 1) # what is counted is a mean of calls, rounded down
  message(FATAL_ERROR "${spread} instructions more for some states than for others")
endif()
