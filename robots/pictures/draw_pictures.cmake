# Draws the pictures that the pages show into FOLDER: touch_floor.svg and time_and_error.svg.
# cmake -DTOUCH_FLOOR=.. -DTREELINE=.. -DDRAW_BENCH=.. -DROBOTS=.. -DFOLDER=.. -P draw_pictures.cmake
file(MAKE_DIRECTORY ${FOLDER})
function(run)
  execute_process(COMMAND ${ARGN} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endfunction()
set(humanoid ${ROBOTS}/humanoid24)
run(${TOUCH_FLOOR} --csv ${FOLDER}/touch_floor.csv)
run(${TREELINE} draw ${humanoid}/humanoid24.urdf ${humanoid}/scene.yaml
  --motion ${FOLDER}/touch_floor.csv --times 0.25,1.75,2.75,3.75,5.25 --path left_hand
  --elevation 0.18 --svg ${FOLDER}/touch_floor.svg)
run(${DRAW_BENCH} ${humanoid}/bench.txt --svg ${FOLDER}/time_and_error.svg
  --functions inverse_dynamics,mass_matrix,forward_dynamics,lambda_inverse,lambda,control_torque)
