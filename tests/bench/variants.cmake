# What the generated code of the benchmark is compiled with, whatever compiles the rest: each variant
# is generated under a name of its own (ROBOT_VARIANT), so that all are linked into one program.
set(BENCH_VARIANTS)

# bench_add_variant(KEY COMPILER-PROGRAM LABEL flags...)
macro(bench_add_variant key program label)
  find_program(TREELINE_BENCH_${program} ${program})
  if(TREELINE_BENCH_${program})
    list(APPEND BENCH_VARIANTS ${key})
    set(bench_compiler_${key} ${TREELINE_BENCH_${program}})
    set(bench_label_${key} "${label}")
    set(bench_flags_${key} -std=c++17 -fno-fast-math ${ARGN})
  else()
    message(STATUS "tests/bench: no ${program}, generated code is not measured with it")
  endif()
endmacro()

bench_add_variant(gcc_o3 g++ "g++ -O3" -O3 -march=native)
bench_add_variant(gcc_o2 g++ "g++ -O2" -O2 -march=native)
bench_add_variant(clang_o3 clang++ "clang++ -O3" -O3 -march=native)
if(CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
  # AVX2 and FMA, the same on every machine: what instructions are counted in.
  bench_add_variant(gcc_v3 g++ "g++ -O3 x86-64-v3" -O3 -march=x86-64-v3)
endif()
# Those of a call for one state, and of a call for eight.
set(BENCH_FUNCTIONS inverse_dynamics forward_dynamics mass_matrix lambda_inverse lambda control_torque
  inverse_dynamics_derivatives forward_dynamics_derivatives)
set(BENCH_BATCH_FUNCTIONS inverse_dynamics forward_dynamics mass_matrix lambda_inverse control_torque)
set(BENCH_BATCH_VARIANTS gcc_o3 clang_o3)
# A robot that is large: what is asked of it.
set(BENCH_FUNCTIONS_humanoid75 inverse_dynamics forward_dynamics lambda_inverse control_torque)
set(BENCH_BATCH_FUNCTIONS_humanoid75 "")
set(BENCH_VARIANTS_humanoid75 gcc_o3 clang_o3 gcc_v3)

# A line for the report: versions and flags of all variants.
set(BENCH_BUILD)
foreach(key IN LISTS BENCH_VARIANTS)
  execute_process(COMMAND ${bench_compiler_${key}} --version OUTPUT_VARIABLE version)
  string(REGEX MATCH "[0-9]+\\.[0-9]+\\.[0-9]+" version "${version}")
  list(JOIN bench_flags_${key} " " flags)
  string(APPEND BENCH_BUILD "${bench_label_${key}}: ${version} ${flags}\\n")
endforeach()
string(APPEND BENCH_BUILD "all else: ${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION} "
                          "${CMAKE_BUILD_TYPE} without -march\\n")

# Writes the scene that is measured: SCENE with the functions and batches of this benchmark.
function(bench_write_scene scene functions batch result)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${scene})
  file(READ ${scene} text)
  string(REGEX REPLACE "(^|\n)(functions|batch|name):[^\n]*" "" text "${text}")
  list(JOIN functions ", " listed)
  string(APPEND text "functions: [${listed}]\n")
  if(batch)
    string(APPEND text "batch: ${batch}\n")
  endif()
  file(CONFIGURE OUTPUT ${result} CONTENT "${text}" @ONLY)
endfunction()

# bench_compile(NAME COMPILE-KEY SOURCE...): metered; appends to BENCH_OBJECTS.
macro(bench_compile name key)
  foreach(source ${ARGN})
    set(object ${CMAKE_CURRENT_BINARY_DIR}/generated/${name}/${source}.o)
    add_custom_command(OUTPUT ${object}
      BYPRODUCTS ${CMAKE_CURRENT_BINARY_DIR}/generated/${name}/${source}.json
      COMMAND treeline_bench_compile_meter
        ${CMAKE_CURRENT_BINARY_DIR}/generated/${name}/${source}.json ${object}
        ${bench_compiler_${key}} ${bench_flags_${key}} -fstack-usage
        -c ${CMAKE_CURRENT_BINARY_DIR}/generated/${name}/${source}.cpp -o ${object}
      DEPENDS treeline_bench_compile_meter
        ${CMAKE_CURRENT_BINARY_DIR}/generated/${name}/${source}.cpp
      COMMENT "Compiling ${name} ${source}"
      VERBATIM)
    list(APPEND BENCH_OBJECTS ${object})
  endforeach()
endmacro()

# The lines of a function that make a subject of routines NAMESPACE::FUNCTION.
function(bench_subject_lines label prefix namespace states functions result)
  set(lines)
  foreach(function IN LISTS functions)
    string(APPEND lines "       {Function::${function}, bind_generated<${namespace}::${function}>(${states})},\n")
  endforeach()
  set(${result} "${${result}}  subjects.push_back(\n      {\"${label}\",\n       {\n${lines}       },\n       \"${BENCH_FACTS}\",\n       \"${prefix}\"});\n" PARENT_SCOPE)
endfunction()

# Rules that generate ROBOT from URDF and SCENE and compile it, metered, for one variant. Appends to
# BENCH_OBJECTS, BENCH_BINDINGS (the source that makes subjects of it) and BENCH_SUBJECTS.
function(bench_compile_robot robot urdf scene key)
  set(name ${robot}_${key})
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/generated/${name})
  set(batch_functions)
  set(batch 0)
  if(BENCH_BATCH_FUNCTIONS AND "${key}" IN_LIST BENCH_BATCH_VARIANTS)
    set(batch 8)
    list(TRANSFORM BENCH_BATCH_FUNCTIONS PREPEND batch_ OUTPUT_VARIABLE batch_functions)
  endif()
  bench_write_scene(${scene} "${BENCH_FUNCTIONS}" ${batch} ${folder}.yaml)
  set(stems ${BENCH_FUNCTIONS} ${batch_functions})
  list(TRANSFORM stems REPLACE "(.+)" "${folder}/\\1.cpp" OUTPUT_VARIABLE sources)
  add_custom_command(OUTPUT ${folder}/${name}.hpp ${sources}
    COMMAND treeline_bench_compile_meter ${folder}.generation.json -
      $<TARGET_FILE:treeline::treeline> generate ${urdf} ${folder}.yaml --name ${name} --output ${folder} > ${folder}.txt
    COMMAND ${CMAKE_COMMAND} -E touch ${folder}/${name}.hpp ${sources}
    DEPENDS treeline::treeline treeline_bench_compile_meter ${urdf} ${folder}.yaml
    COMMENT "Generating ${name}"
    VERBATIM)
  bench_compile(${name} ${key} ${stems})

  set(BENCH_ROBOT ${robot})
  set(BENCH_NAME ${name})
  set(BENCH_FACTS ${folder})
  set(BENCH_INCLUDES "#include \"${name}.hpp\"\n")
  set(BENCH_SUBJECT_LINES)
  set(label "generated, ${bench_label_${key}}")
  bench_subject_lines("${label}" "" generated 1 "${BENCH_FUNCTIONS}" BENCH_SUBJECT_LINES)
  if(batch)
    string(APPEND BENCH_INCLUDES "#include \"${name}_batch.hpp\"\n")
    bench_subject_lines("${label}, ${batch} a call" batch_ generated::batch ${batch}
      "${BENCH_BATCH_FUNCTIONS}" BENCH_SUBJECT_LINES)
  endif()
  configure_file(variant.cpp.in ${name}.cpp @ONLY)
  set_property(SOURCE ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp
    PROPERTY OBJECT_DEPENDS ${folder}/${name}.hpp)
  set_property(SOURCE ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp
    PROPERTY INCLUDE_DIRECTORIES ${folder})
  set(BENCH_OBJECTS ${BENCH_OBJECTS} PARENT_SCOPE)
  set(BENCH_BINDINGS ${BENCH_BINDINGS} ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp PARENT_SCOPE)
  set(BENCH_SUBJECTS ${BENCH_SUBJECTS} ${name} PARENT_SCOPE)
endfunction()

# All variants of ROBOT, with what the benchmark asks of it.
macro(bench_compile_variants robot urdf scene)
  foreach(list BENCH_FUNCTIONS BENCH_BATCH_FUNCTIONS BENCH_VARIANTS)
    set(all_${list} ${${list}})
    if(DEFINED ${list}_${robot})
      set(${list} ${${list}_${robot}})
    endif()
  endforeach()
  foreach(key IN LISTS BENCH_VARIANTS)
    if("${key}" IN_LIST all_BENCH_VARIANTS)
      bench_compile_robot(${robot} ${urdf} ${scene} ${key})
    endif()
  endforeach()
  foreach(list BENCH_FUNCTIONS BENCH_BATCH_FUNCTIONS BENCH_VARIANTS)
    set(${list} ${all_${list}})
  endforeach()
endmacro()
