# Draws the pictures of the pages into FOLDER and compares them with those that are checked in. Would
# catch a picture that is older than the robot, the controller or the report that it shows.
include(${ROBOTS}/pictures/draw_pictures.cmake)
foreach(picture touch_floor time_and_error)
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files
    ${FOLDER}/${picture}.svg ${ROBOTS}/humanoid24/${picture}.svg RESULT_VARIABLE differs)
  if(differs)
    message(FATAL_ERROR "robots/humanoid24/${picture}.svg is stale: cmake --build BUILD -t pictures")
  endif()
endforeach()
