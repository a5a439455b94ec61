# Compiles C++ of `profile: misra` whole, as freestanding code without a warning, with compilers of
# hosts and of microcontrollers: what is emitted from loops beside straight-line functions.
# cmake -DTREELINE=program -DROBOTS=dir -DFOLDER=dir -P safe_cpp.cmake
cmake_policy(SET CMP0007 NEW)
set(flags -std=c++17 -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wdouble-promotion
  -Wshadow -Wold-style-cast -Wmissing-declarations -Werror -O1 -ffreestanding -fno-exceptions
  -fno-rtti -fsyntax-only)
set(flags_g++ -Wuseless-cast)
set(flags_arm-none-eabi-g++ -Wuseless-cast -mcpu=cortex-m4)
set(flags_riscv64-unknown-elf-g++ -Wuseless-cast -march=rv32imfc -mabi=ilp32f)
foreach(case ur10e:${CMAKE_CURRENT_LIST_DIR}/misra_limits.yaml
    puma560:${CMAKE_CURRENT_LIST_DIR}/../controller/puma.yaml
    samm:${CMAKE_CURRENT_LIST_DIR}/../controller/samm.yaml
    humanoid24:${CMAKE_CURRENT_LIST_DIR}/../experiments/humanoid24_limits.yaml
    samm:${CMAKE_CURRENT_LIST_DIR}/misra_loops_samm.yaml
    humanoid24:${CMAKE_CURRENT_LIST_DIR}/misra_loops_humanoid24.yaml)
  string(REPLACE ":" ";" case ${case})
  list(GET case 0 robot)
  list(GET case 1 scene)
  get_filename_component(stem ${scene} NAME_WE)
  foreach(real float double)
    set(folder ${FOLDER}/${robot}_${stem}_${real})
    file(REMOVE_RECURSE ${folder})
    execute_process(COMMAND ${TREELINE} generate ${ROBOTS}/${robot}/${robot}.urdf ${scene}
        --profile misra --real ${real} --output ${folder} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
    # Headers that hold functions are compiled as sources are.
    file(GLOB sources ${folder}/*.cpp)
    file(GLOB headers ${folder}/*_limited.hpp)
    foreach(header IN LISTS headers)
      file(WRITE ${folder}/header.cc "#include \"${header}\"\n")
      list(APPEND sources ${folder}/header.cc)
    endforeach()
    foreach(compiler g++ clang++ arm-none-eabi-g++ riscv64-unknown-elf-g++)
      execute_process(COMMAND ${compiler} ${flags} ${flags_${compiler}} ${sources}
        COMMAND_ERROR_IS_FATAL ANY)
    endforeach()
  endforeach()
endforeach()
