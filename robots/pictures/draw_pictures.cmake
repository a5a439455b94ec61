# Draws the pictures that the pages show into FOLDER: touch_floor.svg and time_and_error.svg.
# cmake -DTOUCH_FLOOR=.. -DDRAW_STRIP=.. -DDRAW_BENCH=.. -DROBOTS=.. -DFOLDER=.. -P draw_pictures.cmake
file(MAKE_DIRECTORY ${FOLDER})
function(run)
  execute_process(COMMAND ${ARGN} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endfunction()
set(humanoid ${ROBOTS}/humanoid24)
run(${TOUCH_FLOOR} --csv ${FOLDER}/touch_floor.csv)
run(${DRAW_STRIP} ${humanoid}/humanoid24.urdf ${FOLDER}/touch_floor.csv
  --times 0.25,1.75,2.75,3.75,5.25 --path left_x,left_y,left_z --svg ${FOLDER}/touch_floor.svg)
run(${DRAW_BENCH} ${humanoid}/bench.txt --svg ${FOLDER}/time_and_error.svg
  --functions inverse_dynamics,mass_matrix,forward_dynamics,lambda_inverse,lambda,control_torque)
