# The generated controller of a PUMA, compiled in many ways: over 2000 steps through every mode and law
# all builds of a precision tell the same bits, see step_bits.cpp. On this machine by LEVELS of g++ and
# clang++, without and with its own instructions; under QEMU on a Cortex-M7, and in float on an M4F.
# There doubles are computed by libgcc, whose subtraction rounds wrongly at times: see
# tests/reproducibility/README.md. Prints a row for each build.
# cmake -DTREELINE=program -DROBOTS=dir -DTESTS=dir of all tests -DFOLDER=dir "-DLEVELS=-O0;-O2"
#       -DQEMU=program -P step_bits.cmake
cmake_minimum_required(VERSION 3.25)
set(firmware ${TESTS}/consumers/firmware)
include(${firmware}/cores.cmake)
file(REMOVE_RECURSE ${FOLDER})
file(READ ${TESTS}/controller/puma.yaml scene)
file(WRITE ${FOLDER}/scene.yaml "${scene}\nlanes: 1\n")
execute_process(COMMAND ${CMAKE_COMMAND} -DFILE=${FOLDER}/scene.yaml
  -P ${TESTS}/controller/add_behaviours.cmake COMMAND_ERROR_IS_FATAL ANY)

set(count 0)
# Runs what was built, and compares what it prints with the first build's.
function(compare what)
  # Semihosting writes to the standard error of QEMU where it has no console.
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE out ERROR_VARIABLE error TIMEOUT 300
    COMMAND_ERROR_IS_FATAL ANY)
  string(STRIP "${out}${error}" told)
  string(REPLACE ";" " " what "${what}")
  message(STATUS "${what}: ${told}")
  if(NOT told MATCHES "^[0-9a-f]+ 0000000f00000007$")
    message(FATAL_ERROR "not every mode and law was seen")
  endif()
  if(expected AND NOT told STREQUAL expected)
    message(FATAL_ERROR "other bits than ${expected}")
  endif()
  math(EXPR more "${count} + 1")
  set(count ${more} PARENT_SCOPE)
  set(expected ${told} PARENT_SCOPE)
endfunction()

# g++ fuses what it vectorizes although contraction is off, see tests/reproducibility/README.md.
set(own_g++ -march=native -fno-tree-slp-vectorize)
set(own_clang++ -march=native)
set(machine_m4f mps2-an386)
set(machine_m7 mps2-an500)
set(cores_float m4f m7)
set(cores_double m7)
foreach(real double float)
  set(expected "")
  set(folder ${FOLDER}/${real})
  execute_process(COMMAND ${TREELINE} generate ${ROBOTS}/puma560/puma560.urdf ${FOLDER}/scene.yaml
    --name puma_arm --real ${real} --output ${folder}/puma_arm OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  file(GLOB sources ${folder}/puma_arm/controller*.cpp)
  list(APPEND sources ${TESTS}/controller/step_bits.cpp)
  set(includes -ffp-contract=off -I${folder}/puma_arm -I${firmware}/board -I${TESTS}/controller)
  foreach(compiler g++ clang++)
    find_tool(${compiler} command)
    foreach(own "" "${own_${compiler}}")
      foreach(level ${LEVELS})
        execute_process(COMMAND ${command} -std=c++17 ${level} ${own} ${includes} ${sources}
          ${firmware}/board/host.cpp -o ${folder}/host COMMAND_ERROR_IS_FATAL ANY)
        compare("${real} ${compiler} ${level} ${own}" ${folder}/host)
      endforeach()
    endforeach()
  endforeach()
  foreach(core ${cores_${real}})
    find_cross(g++ ${core} compiler)
    foreach(level ${LEVELS})
      execute_process(COMMAND ${compiler} ${freestanding} ${flags_${core}} ${level} -nostdlib
        ${includes} ${sources} ${firmware}/board/board.cpp -T ${firmware}/board/board.ld
        -o ${folder}/${core}.elf -lgcc COMMAND_ERROR_IS_FATAL ANY)
      compare("${real} ${core} ${level}" ${QEMU} -M ${machine_${core}} -nographic -monitor none
        -serial none -semihosting-config enable=on,target=native -kernel ${folder}/${core}.elf)
    endforeach()
  endforeach()
endforeach()
message(STATUS "${count} builds, in each precision the same bits")
