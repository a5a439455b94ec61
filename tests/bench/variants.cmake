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

# Rules that generate ROBOT from URDF and SCENE and compile it, metered, for one variant. Appends to
# BENCH_OBJECTS, BENCH_BINDINGS (the source that makes it a subject) and BENCH_SUBJECTS.
function(bench_compile_robot robot urdf scene key)
  set(name ${robot}_${key})
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/generated/${name})
  set(sources ${TREELINE_ALL_FUNCTIONS})
  list(TRANSFORM sources REPLACE "(.+)" "${folder}/\\1.cpp")
  add_custom_command(OUTPUT ${folder}/${name}.hpp ${sources}
    COMMAND treeline::treeline generate ${urdf} ${scene} --name ${name} --output ${folder} > ${folder}.txt
    COMMAND ${CMAKE_COMMAND} -E touch ${folder}/${name}.hpp ${sources}
    DEPENDS treeline::treeline ${urdf} ${scene}
    COMMENT "Generating ${name}"
    VERBATIM)
  foreach(function IN LISTS TREELINE_ALL_FUNCTIONS)
    set(object ${folder}/${function}.o)
    add_custom_command(OUTPUT ${object}
      BYPRODUCTS ${folder}/${function}.json
      COMMAND treeline_bench_compile_meter ${folder}/${function}.json ${object}
        ${bench_compiler_${key}} ${bench_flags_${key}} -fstack-usage
        -c ${folder}/${function}.cpp -o ${object}
      DEPENDS treeline_bench_compile_meter ${folder}/${function}.cpp
      COMMENT "Compiling ${name} ${function}"
      VERBATIM)
    list(APPEND BENCH_OBJECTS ${object})
  endforeach()

  set(BENCH_ROBOT ${robot})
  set(BENCH_NAME ${name})
  set(BENCH_LABEL "generated, ${bench_label_${key}}")
  set(BENCH_FACTS ${folder})
  configure_file(variant.cpp.in ${name}.cpp @ONLY)
  set_property(SOURCE ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp
    PROPERTY OBJECT_DEPENDS ${folder}/${name}.hpp)
  set_property(SOURCE ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp
    PROPERTY INCLUDE_DIRECTORIES ${folder})
  set(BENCH_OBJECTS ${BENCH_OBJECTS} PARENT_SCOPE)
  set(BENCH_BINDINGS ${BENCH_BINDINGS} ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp PARENT_SCOPE)
  set(BENCH_SUBJECTS ${BENCH_SUBJECTS} ${name} PARENT_SCOPE)
endfunction()
