# Configures and builds cross/CMakeLists.txt with a toolchain file, in all ways that the README names. Would
# catch: a package that cannot be found, that asks for libraries of the other machine which the firmware
# does not need, that keeps in silence what it lacks, or that links libraries of this machine.
# cmake -DTOOLCHAIN=name -DPREFIX=installed -DROBOTS=dir -DFOLDER=dir -P build.cmake
set(source ${CMAKE_CURRENT_LIST_DIR})
set(target_arm-none-eabi cortex-m4f)
set(target_riscv64-unknown-elf rv64gc)
set(target_aarch64-linux-gnu aarch64)
set(ENV{TREELINE_TEST_TOOLCHAIN} ${TOOLCHAIN})
file(REMOVE_RECURSE ${FOLDER})

# configure(NAME FILE FINDS option...): `said` is what CMake says; FINDS, whether it ends well.
function(configure name file finds)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${source} -B ${FOLDER}/${name} -G Ninja
      -DCMAKE_TOOLCHAIN_FILE=${source}/${file}.cmake -DCMAKE_BUILD_TYPE=Release
      -DROBOTS=${ROBOTS} -DTARGET=${target_${TOOLCHAIN}} ${ARGN}
    RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(finds AND failed OR NOT finds AND NOT failed)
    message(FATAL_ERROR "${name} (${failed}): ${said}")
  endif()
  string(REGEX REPLACE "[ \n]+" " " said "${said}")
  set(said "${said}" PARENT_SCOPE)
endfunction()
function(build name)
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${FOLDER}/${name} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  file(GLOB sources ${FOLDER}/${name}/treeline/arm*/*.sources/*.c*)
  foreach(each IN LISTS sources)
    file(STRINGS ${each} included REGEX "#include")
    if(NOT included)
      message(FATAL_ERROR "${each} is empty")
    endif()
  endforeach()
endfunction()
function(expect text)
  if(NOT said MATCHES "${text}")
    message(FATAL_ERROR "no word of `${text}`: ${said}")
  endif()
endfunction()

set(here -DCMAKE_PREFIX_PATH=${PREFIX})
configure(firmware ${TOOLCHAIN} TRUE ${here} "-DASKED=COMPONENTS firmware")
build(firmware)
configure(whatever_there_is ${TOOLCHAIN} TRUE ${here})
expect("left out.*report: fmt is not found")
build(whatever_there_is)
configure(unknown ${TOOLCHAIN} FALSE ${here} "-DASKED=COMPONENTS firmwear")
expect("firmwear: there is no such part")

# Packages of the other machine alone: where this one is, is said.
configure(only_by_prefix only FALSE ${here})
configure(only_by_folder only TRUE -Dtreeline_DIR=${PREFIX}/lib/cmake/treeline "-DASKED=COMPONENTS firmware")
build(only_by_folder)
configure(only_by_call only TRUE ${here} "-DASKED=NO_CMAKE_FIND_ROOT_PATH")

if(TOOLCHAIN MATCHES linux)
  # What runs on this machine is not linked: it is compiled again.
  configure(loop ${TOOLCHAIN} TRUE ${here} "-DASKED=COMPONENTS servo batch" "-DPARTS=treeline::servo treeline::batch")
  build(loop)
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${FOLDER}/loop --target treeline_servo treeline_batch
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND readelf -h ${FOLDER}/loop/libtreeline_servo.a OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
  expect("AArch64")
else()
  configure(loop ${TOOLCHAIN} FALSE ${here} "-DASKED=COMPONENTS servo")
  expect("servo: there are no threads")
endif()
