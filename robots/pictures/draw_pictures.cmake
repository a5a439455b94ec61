# Draws the pictures that the pages show into FOLDER, each in the folder of its robot.
# cmake -DPROGRAMS=touch_floor=..;.. -DROBOTS=.. -DFOLDER=.. -P draw_pictures.cmake
# PROGRAMS are treeline, draw_bench and the experiments, by their names.
foreach(program ${PROGRAMS})
  string(REPLACE "=" ";" parts ${program})
  list(GET parts 0 name)
  list(GET parts 1 ${name})
endforeach()
set(pictures humanoid24/touch_floor humanoid24/touch_floor_film humanoid24/rock_torso humanoid24/put_box humanoid24/carry_ladder
  humanoid24/hit_wall humanoid24/time_and_error puma560/elbow_lock puma560/head_lock puma560/wrist_lock
  samm/carry_object samm/circles ur10e/reach ur10e/wrist ur10e/goal_1
  anymal_c/trot
  hands/allegro hands/shadow)
file(MAKE_DIRECTORY ${FOLDER}/anymal_c ${FOLDER}/hands ${FOLDER}/humanoid24 ${FOLDER}/puma560 ${FOLDER}/samm
  ${FOLDER}/ur10e ${FOLDER}/circles ${FOLDER}/locks ${FOLDER}/lines)
function(run)
  execute_process(COMMAND ${ARGN} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endfunction()
# draw(PICTURE MOTION robot and options)
function(draw picture motion)
  run(${treeline} draw ${ARGN} --motion ${motion} --output ${FOLDER}/${picture}.svg)
endfunction()
set(humanoid ${ROBOTS}/humanoid24)

foreach(experiment touch_floor rock_torso put_box hit_wall carry_object carry_ladder trot_anymal)
  run(${${experiment}} --csv ${FOLDER}/${experiment}.csv)
endforeach()
run(${samm_circles} --output ${FOLDER}/circles)
run(${puma560_singularity} --output ${FOLDER}/locks)
run(${ur10e_singularity} --output ${FOLDER}/lines)

draw(humanoid24/touch_floor ${FOLDER}/touch_floor.csv
  ${humanoid}/humanoid24.urdf ${humanoid}/scene.yaml
  --times 0.25,1.75,2.75,3.75,5.25 --path left_hand --elevation 0.18)
draw(humanoid24/touch_floor_film ${FOLDER}/touch_floor.csv
  ${humanoid}/humanoid24.urdf ${humanoid}/scene.yaml
  --animate --times 0.5,5.5 --pause 1 --path left_hand --elevation 0.18 --width 360)
draw(humanoid24/rock_torso ${FOLDER}/rock_torso.csv
  ${humanoid}/humanoid24.urdf ${humanoid}/scene.yaml
  --times 5.7,6.2,6.7,7.2,7.7 --azimuth 0.1 --elevation 0.12)
draw(humanoid24/put_box ${FOLDER}/put_box.csv
  ${humanoid}/humanoid24.urdf ${humanoid}/scene_box.yaml
  --times 0.25,1.75,2.75,3.75,5.25 --elevation 0.18)
draw(humanoid24/hit_wall ${FOLDER}/hit_wall.csv
  ${humanoid}/humanoid24.urdf ${humanoid}/scene_hit_wall.yaml
  --times 0,0.2,0.37,0.6,2.5 --azimuth 1.5 --elevation 0.1)
# Rounding, and so the machine, decides about the end of a fall: they are drawn, but not among the pictures to compare.
run(${treeline} simulate ${humanoid}/humanoid24.urdf ${humanoid}/scene_floating.yaml --ground --height 0.3
  --stops --seconds 1.5 --csv ${FOLDER}/fall.csv --warnings none)
draw(humanoid24/fall ${FOLDER}/fall.csv ${humanoid}/humanoid24.urdf ${humanoid}/scene_floating.yaml
  --times 0,0.25,0.35,0.45,0.55,1.5)
# A fall ends the drive with 3.
execute_process(COMMAND ${treeline} drive ${humanoid}/humanoid24.urdf ${humanoid}/standing.yaml
  --headless --script ${humanoid}/pull_over.txt --record ${FOLDER}/topple.jsonl --warnings none
  OUTPUT_QUIET ERROR_QUIET)
draw(humanoid24/topple ${FOLDER}/topple.jsonl ${humanoid}/humanoid24.urdf ${humanoid}/standing.yaml
  --times 0.5,0.75,0.95,1.15,1.35,2)
draw(samm/carry_object ${FOLDER}/carry_object.csv ${ROBOTS}/samm/pair.yaml
  --times 0.5,3.5,5,6.5 --path first_hand,second_hand --azimuth 1.2 --elevation 0.5)
foreach(lock elbow head)
  draw(puma560/${lock}_lock ${FOLDER}/locks/${lock}_lock_singular.csv
    ${ROBOTS}/puma560/puma560.urdf ${ROBOTS}/puma560/scene.yaml
    --times 0,0.75,1.5,2.25,3 --path tool)
endforeach()
draw(puma560/wrist_lock ${FOLDER}/locks/wrist_lock_singular.csv
  ${ROBOTS}/puma560/puma560.urdf ${ROBOTS}/puma560/scene.yaml
  --times 0,0.9,1.6,2.4,4.2 --close-up link5)
foreach(line reach wrist goal_1)
  draw(ur10e/${line} ${FOLDER}/lines/${line}_damped.csv
    ${ROBOTS}/ur10e/ur10e.urdf ${ROBOTS}/ur10e/scene.yaml --times 0,1,2,3,4.5 --path tool)
endforeach()
draw(humanoid24/carry_ladder ${FOLDER}/carry_ladder.csv ${humanoid}/ladder.yaml
  --times 0,2,4 --path first_left,second_left --azimuth 1.3 --elevation 0.5 --width 360)
draw(anymal_c/trot ${FOLDER}/trot_anymal.csv
  ${ROBOTS}/../tests/data/published/anymal_c.urdf ${ROBOTS}/anymal_c/scene_simulated.yaml
  --times 4.65,5.05,5.45,5.85 --path left_fore --azimuth 1.2 --elevation 0.18)
foreach(hand allegro shadow)
  run(${turn_ball} --hand ${hand} --csv ${FOLDER}/turn_ball_${hand}.csv)
  draw(hands/${hand} ${FOLDER}/turn_ball_${hand}.csv ${ROBOTS}/hands/${hand}_apart.yaml
    --times 0.5,2,6.5,11 --azimuth 0.6 --elevation 0.2)
endforeach()
draw(samm/circles ${FOLDER}/circles/tool_and_base_ideal.csv
  ${ROBOTS}/samm/samm.urdf ${ROBOTS}/samm/scene.yaml
  --times 0.5,2,3,4,5 --path tool,base --azimuth 0.5 --elevation 0.3)
run(${draw_bench} ${humanoid}/bench.txt --svg ${FOLDER}/humanoid24/time_and_error.svg
  --functions inverse_dynamics,mass_matrix,forward_dynamics,lambda_inverse,lambda,control_torque)
