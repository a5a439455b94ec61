# What CppADCodeGen records of Pinocchio's algorithms, compiled and metered as the generated code is.
set(BENCH_RECORDED_FUNCTIONS inverse_dynamics forward_dynamics mass_matrix lambda_inverse lambda
  control_torque)
set(BENCH_RECORDED_VARIANTS gcc_o3 clang_o3)

# Rules that record ROBOT and compile it for one variant, like bench_compile_robot. Of SCENE it takes
# the base and the points' links: there must be nothing else in it.
function(bench_record_robot robot urdf scene key)
  set(name ${robot}_recorded_${key})
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/generated/${name})
  file(READ ${scene} text)
  string(REGEX MATCHALL "link: *[A-Za-z0-9_]+" links "${text}")
  list(TRANSFORM links REPLACE "link: *" "")
  set(base fixed)
  if("${text}" MATCHES "base: floating")
    set(base floating)
  endif()
  list(TRANSFORM BENCH_RECORDED_FUNCTIONS REPLACE "(.+)" "${folder}/\\1.cpp" OUTPUT_VARIABLE sources)
  add_custom_command(OUTPUT ${sources}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
    COMMAND treeline_bench_compile_meter ${folder}.generation.json -
      $<TARGET_FILE:treeline_bench_cppadcodegen_record> ${urdf} ${base} ${name} ${folder} ${links}
    DEPENDS treeline_bench_compile_meter treeline_bench_cppadcodegen_record ${urdf} ${scene}
    COMMENT "Recording ${name}"
    VERBATIM)
  bench_compile(${name} ${key} ${BENCH_RECORDED_FUNCTIONS})

  set(BENCH_ROBOT ${robot})
  set(BENCH_NAME ${name})
  set(BENCH_FACTS ${folder})
  set(BENCH_INCLUDES "")
  set(declarations)
  foreach(function IN LISTS BENCH_RECORDED_FUNCTIONS)
    string(APPEND declarations "void ${function}(const double* const* in, double* out) noexcept;\n")
  endforeach()
  string(APPEND BENCH_INCLUDES "namespace ${name} {\n${declarations}}\n")
  set(BENCH_SUBJECT_LINES)
  bench_subject_lines("CppADCodeGen, ${bench_label_${key}}" "" generated 1
    "${BENCH_RECORDED_FUNCTIONS}" BENCH_SUBJECT_LINES)
  configure_file(variant.cpp.in ${name}.cpp @ONLY)
  set(BENCH_OBJECTS ${BENCH_OBJECTS} PARENT_SCOPE)
  set(BENCH_BINDINGS ${BENCH_BINDINGS} ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp PARENT_SCOPE)
  set(BENCH_SUBJECTS ${BENCH_SUBJECTS} ${name} PARENT_SCOPE)
endfunction()
