# Tools that make code of Pinocchio's algorithms, with their headers from PyPI: the same sources,
# whose scalars differ. Compiled with little optimization, since it is their code
# that is timed, which the module compiles with -O3 -march=native for each robot.
set(recorders ${CMAKE_CURRENT_BINARY_DIR}/recorders)
if(TREELINE_DEBIAN_PYTHON)
  message(STATUS "Peers: installing CasADi and CppADCodeGen from PyPI")
  execute_process(COMMAND ${PROJECT_SOURCE_DIR}/tests/install_environment ${TREELINE_DEBIAN_PYTHON}
    ${recorders} ${CMAKE_CURRENT_SOURCE_DIR}/recorders.txt)
endif()
set(recorders ${recorders}/lib/python3.11/site-packages)
set(sources adapt read_solver record_routes)
list(TRANSFORM sources REPLACE "(.+)" "pinocchio/\\1.cpp")
set_source_files_properties(pinocchio/record_routes.cpp PROPERTIES COMPILE_OPTIONS -O0)

find_path(TREELINE_CASADI_INCLUDE casadi/casadi.hpp PATHS ${recorders}/casadi/include)
find_library(TREELINE_CASADI casadi PATHS ${recorders}/casadi)
if(TREELINE_CASADI_INCLUDE AND TREELINE_CASADI)
  treeline_add_peer(casadi pinocchio/recorded_peer.cpp pinocchio/record_by_casadi.cpp ${sources})
  treeline_adapt_pinocchio(treeline_peer_casadi -O1)
  target_compile_definitions(treeline_peer_casadi PRIVATE TREELINE_RECORD_BY_CASADI)
  target_include_directories(treeline_peer_casadi SYSTEM PRIVATE ${TREELINE_CASADI_INCLUDE})
  target_link_libraries(treeline_peer_casadi PRIVATE ${TREELINE_CASADI} ${CMAKE_DL_LIBS})
else()
  message(STATUS "Peers: CasADi is not measured (PyPI)")
endif()

find_path(TREELINE_CPPADCODEGEN_INCLUDE cppad/cg.hpp PATHS ${recorders}/cmeel.prefix/include)
find_library(TREELINE_CPPAD cppad_lib PATHS ${recorders}/cmeel.prefix/lib)
if(TREELINE_CPPADCODEGEN_INCLUDE AND TREELINE_CPPAD)
  # Boards count what it records: see tests/board.
  add_library(treeline_cppadcodegen OBJECT EXCLUDE_FROM_ALL
    pinocchio/record_by_cppadcodegen.cpp ${sources})
  treeline_adapt_pinocchio(treeline_cppadcodegen -O1)
  target_include_directories(treeline_cppadcodegen
    PRIVATE ${PROJECT_SOURCE_DIR}/generator
    SYSTEM ${TREELINE_CPPADCODEGEN_INCLUDE})
endif()
