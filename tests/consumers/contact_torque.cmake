# Generates the hopper of contact_torque.cpp, rows in either axes, builds and runs it.
# cmake -DTREELINE=program -DURDF=hopper.urdf -DFOLDER=dir -DHOST=c++ -P contact_torque.cmake
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
file(REMOVE_RECURSE ${FOLDER})
foreach(axes world local)
  set(folder ${FOLDER}/${axes})
  file(WRITE ${folder}/scene.yaml "base: floating\nconstraints:\n"
    "  - {name: sole, between: [foot, world], origin: {xyz: [0, 0, -0.4]}, axes: ${axes}}\n"
    "functions: [supported_control_torque, mass_matrix, inverse_dynamics, constraint_jacobian]\n")
  run(${TREELINE} generate ${URDF} ${folder}/scene.yaml --name hopper --output ${folder}/hopper)
  file(GLOB sources ${folder}/hopper/*.cpp)
  run(${HOST} -std=c++17 -O1 -Wall -Wextra -I${folder}/hopper
    ${CMAKE_CURRENT_LIST_DIR}/contact_torque.cpp ${sources} -o ${folder}/contact_torque)
  run(${folder}/contact_torque)
endforeach()
