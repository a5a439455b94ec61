# Checks emitted C against MISRA C:2012 with the rules that cppcheck knows. Fails at every violation but
# of the advisory rules that docs/reference/safe-code.md lists. Says SKIPPED where cppcheck is missing.
# cmake -DTREELINE=program -DROBOTS=dir -DFOLDER=dir -DPROFILE=plain|misra -P misra.cmake
cmake_policy(SET CMP0007 NEW)
find_program(cppcheck cppcheck)
if(NOT cppcheck)
  message("SKIPPED: cppcheck is missing: run .ci/install-packages with what .ci/packages names")
  return()
endif()
set(allowed_plain "2\\.3|2\\.4|2\\.5|8\\.9|19\\.2")
set(allowed_misra "2\\.3|2\\.4|8\\.9")
# What <float.h> defines, since cppcheck reads no headers of the system.
set(float -DFLT_RADIX=2 -DFLT_MANT_DIG=24 -DFLT_MAX_EXP=128 -DDBL_MANT_DIG=53 -DDBL_MAX_EXP=1024
  -DFLT_EVAL_METHOD=0 -D__GNUC__=12)
# Without lanes: their vectors are no C99.
file(READ ${ROBOTS}/ur10e/scene.yaml scene)
file(WRITE ${FOLDER}/${PROFILE}/scene.yaml "${scene}\nlanes: 1\n")
foreach(real float double)
  set(folder ${FOLDER}/${PROFILE}/${real})
  execute_process(COMMAND ${TREELINE} generate ${ROBOTS}/ur10e/ur10e.urdf
      ${FOLDER}/${PROFILE}/scene.yaml
      --language c --profile ${PROFILE} --name arm --real ${real} --output ${folder}
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${TREELINE} generate ${ROBOTS}/ur10e/ur10e.urdf
      ${CMAKE_CURRENT_LIST_DIR}/misra_limits.yaml
      --language c --profile ${PROFILE} --real ${real} --output ${folder}_limits
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${TREELINE} generate ${ROBOTS}/puma560/puma560.urdf
      ${CMAKE_CURRENT_LIST_DIR}/misra_controller.yaml
      --language c --profile ${PROFILE} --real ${real} --output ${folder}_controller
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  # Of a tree with sliding joints, friction and springs, and of one whose base floats.
  foreach(robot samm humanoid24)
    execute_process(COMMAND ${TREELINE} generate ${ROBOTS}/${robot}/${robot}.urdf
        ${CMAKE_CURRENT_LIST_DIR}/misra_loops_${robot}.yaml
        --language c --profile ${PROFILE} --real ${real} --output ${folder}_${robot}
      OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
    file(STRINGS ${folder}_${robot}/control_torque.c loops REGEX "link_functions\\.h")
    if(NOT loops)
      message(FATAL_ERROR "control_torque of ${robot} does not loop over links")
    endif()
    # As one source, as the emitted CMakeLists.txt makes it.
    file(WRITE ${folder}_${robot}/loops.c "")
    foreach(function forward_dynamics mass_matrix control_torque)
      file(APPEND ${folder}_${robot}/loops.c "#include \"${function}.c\"\n")
    endforeach()
  endforeach()
  # The headers, the loops of damped and limited control, and straight lines with all operations.
  # Each folder by itself: names that two robots share are not shared by one program.
  set(said)
  foreach(sources IN ITEMS
      "${folder}/damped_control_torque.c;${folder}/gravity.c;${folder}/control_torque.c"
      "${folder}_limits/limited_control_torque.c"
      "${folder}_controller/controller.c"
      "${folder}_samm/loops.c" "${folder}_humanoid24/loops.c")
    execute_process(COMMAND ${cppcheck} -q --std=c99 --addon=misra --enable=style ${float}
        --suppress=unusedFunction --suppress=missingIncludeSystem ${sources}
      ERROR_VARIABLE one OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
    string(APPEND said "${one}")
  endforeach()
  string(REGEX MATCHALL "[^\n]*\\[[a-zA-Z0-9.-]+\\]\n[^\n]*" found "${said}")
  set(violations)
  set(expected 0)
  foreach(each IN LISTS found)
    if(each MATCHES "misra-c2012-(${allowed_${PROFILE}})\\]")
      math(EXPR expected "${expected} + 1")
    else()
      list(APPEND violations "${each}")
    endif()
  endforeach()
  if(expected EQUAL 0)
    message(FATAL_ERROR "cppcheck sees not even the violations that are known: ${said}")
  endif()
  if(violations)
    list(JOIN violations "\n" violations)
    message(FATAL_ERROR "in ${real}:\n${violations}")
  endif()
endforeach()
