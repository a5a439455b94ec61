# Draws the pictures of the pages into FOLDER and compares them with those that are checked in. Would
# catch a picture that is older than the robot, the controller or the report that it shows.
include(${ROBOTS}/pictures/draw_pictures.cmake)
foreach(picture ${pictures})
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files
    ${FOLDER}/${picture}.svg ${ROBOTS}/${picture}.svg RESULT_VARIABLE differs)
  if(differs)
    message(FATAL_ERROR "robots/${picture}.svg is stale: cmake --build BUILD -t pictures")
  endif()
endforeach()
