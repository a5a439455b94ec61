# Builds a program, changes its scene and builds it again, once.
# cmake -DPREFIX=.. -DROBOTS=.. -DFOLDER=.. -DGENERATOR=.. -DHOST=compiler -P changed_scene.cmake
# Would catch: objects of the library, or of who includes its header, that are those of the scene before.
file(REMOVE_RECURSE ${FOLDER})
file(WRITE ${FOLDER}/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)
project(weighed LANGUAGES CXX)
find_package(treeline REQUIRED COMPONENTS firmware)
treeline_generate(arm URDF ${ROBOTS}/puma560/puma560.urdf SCENE scene.yaml)
add_executable(weighed main.cpp)
target_link_libraries(weighed PRIVATE arm)
")
file(WRITE ${FOLDER}/main.cpp "#include <cstdio>
#include \"arm.hpp\"
int main() {
  const double q[6] = {0, 0.3};
  double g[6];
  arm::gravity(q, g);
  std::printf(\"%d %.9f\", arm::kTaskRows, g[1]);
}
")
# build(SCENE RESULT): sets RESULT to what the program prints.
function(build scene result)
  file(WRITE ${FOLDER}/scene.yaml "${scene}")
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${FOLDER}/build OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${FOLDER}/build/weighed OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
  set(${result} "${printed}" PARENT_SCOPE)
endfunction()

set(functions "functions: [gravity]\n")
file(WRITE ${FOLDER}/scene.yaml "${functions}")
execute_process(COMMAND ${CMAKE_COMMAND} -S ${FOLDER} -B ${FOLDER}/build -G ${GENERATOR}
  -DCMAKE_PREFIX_PATH=${PREFIX} -DCMAKE_CXX_COMPILER=${HOST} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
build("${functions}" earth)
build("gravity: [0, 0, -19.62]\n${functions}" heavier)
build("operational_points: [{name: tool, link: tool, rows: [x, y]}]\n${functions}" with_point)
if(NOT earth MATCHES "^0 (.+)$")
  message(FATAL_ERROR "on earth: ${earth}")
endif()
set(weight "${CMAKE_MATCH_1}")
if(NOT with_point STREQUAL "2 ${weight}")
  message(FATAL_ERROR "with a point: ${with_point}, without: ${earth}")
endif()
if(heavier STREQUAL earth)
  message(FATAL_ERROR "with twice the gravity and with it once: ${earth}")
endif()
