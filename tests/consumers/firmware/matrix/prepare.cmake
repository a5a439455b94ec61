# Generates in float and double what the matrix compiles, and one file that includes all of it: every
# emitted .cpp, the inline damped control, and all of runtime/core; and one with every emitted .c.
# cmake -DTREELINE=program -DSOURCE=the repository -DFOLDER=dir -P prepare.cmake
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# generate(ROBOT SCENE NAME REAL FUNCTIONS OPTIONS...)
function(generate robot scene name real functions)
  run(${TREELINE} generate ${SOURCE}/robots/${robot}/${robot}.urdf ${scene} --output
    ${FOLDER}/${real}/${name} --name ${name} --real ${real} --functions ${functions} ${ARGN})
endfunction()

foreach(real float double)
  set(folder ${FOLDER}/${real})
  generate(ur10e ${CMAKE_CURRENT_LIST_DIR}/arm.yaml arm ${real}
    lambda_inverse,jacobian,bias_acceleration,inverse_dynamics)
  generate(planar3r ${CMAKE_CURRENT_LIST_DIR}/planar.yaml planar ${real} jacobian,mass_matrix)
  # Limbs that are alike share lanes.
  generate(humanoid24 ${SOURCE}/robots/humanoid24/scene.yaml humanoid ${real} forward_kinematics)
  file(GLOB sources RELATIVE ${folder}
    ${folder}/arm/*.cpp ${folder}/humanoid/*.cpp ${folder}/planar/*.cpp)
  set(text "#define TREELINE_REAL ${real}\n#include \"tests/core/freestanding_test.cpp\"\n")
  foreach(source IN LISTS sources)
    if(source MATCHES "batch_")
      string(APPEND text "#if !defined(WITHOUT_VECTORS)\n#include \"${source}\"\n#endif\n")
    else()
      string(APPEND text "#include \"${source}\"\n")
    endif()
  endforeach()
  string(APPEND text "#include \"arm/arm_damped.hpp\"\n
arm::Real use_damped(const arm::Real (&q)[6], const arm::Real (&x)[6], arm::Real (&tau)[6]) noexcept;
arm::Real use_damped(const arm::Real (&q)[6], const arm::Real (&x)[6], arm::Real (&tau)[6]) noexcept {
  return arm::damped_control_torque(q, q, q, x, tau);
}
")
  file(WRITE ${folder}/everything.cpp "${text}")

  # Names without a robot's before them would meet here.
  generate(ur10e ${CMAKE_CURRENT_LIST_DIR}/arm.yaml c_arm ${real}
    lambda_inverse,jacobian,bias_acceleration,inverse_dynamics,control_torque --language c)
  generate(humanoid24 ${CMAKE_CURRENT_LIST_DIR}/hands.yaml c_humanoid ${real}
    forward_kinematics,gravity --language c)
  file(GLOB sources RELATIVE ${folder} ${folder}/c_arm/*.c ${folder}/c_humanoid/*.c)
  set(text)
  foreach(source IN LISTS sources)
    set(include "#include \"${source}\"\n")
    if(source MATCHES "humanoid")
      set(include "#if !defined(WITHOUT_VECTORS)\n${include}#endif\n")
    endif()
    string(APPEND text "${include}")
  endforeach()
  string(APPEND text "#include \"c_arm/c_arm_joints.h\"\n#include \"c_humanoid/c_humanoid_joints.h\"\n")
  file(WRITE ${folder}/everything.c "${text}")
endforeach()
