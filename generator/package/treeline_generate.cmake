# treeline_generate(LIBRARY [URDF file] [SCENE file] [NAME identifier] [REAL float|double]
#                   [LANGUAGE c|c++|opencl] [PROFILE plain|misra] [OPTIMIZE speed|size]
#                   [FUNCTIONS function...] [TARGET processor] [CHOICES file])
#
# Makes the static library LIBRARY from a robot and a scene (without one: functions of the joints
# alone), or from a scene that lists its robots and no URDF (CMake 3.20), while building: link it and
# include "NAME.hpp" (or "NAME_calls.hpp", "NAME_eigen.hpp", "NAME_joints.hpp", or
# "NAME_batch.hpp" where the scene has a key `batch`). NAME, which is also the namespace, is the library's name unless
# given; REAL, LANGUAGE, PROFILE, OPTIMIZE, FUNCTIONS and TARGET go before what the scene says. In C
# the headers are "NAME.h" and "NAME_joints.h", and the project has to have the language C. In OpenCL C LIBRARY is an
# interface: the folder of "NAME.cl", which the driver of a device compiles while the program runs, is its
# INTERFACE_INCLUDE_DIRECTORIES. Flags for
# the processor, for small code and for GCC are used as in the emitted CMakeLists.txt: those of another
# processor than this machine's where CMake cross-compiles, or as TREELINE_TARGET_FLAGS says. CHOICES
# is the manifest.json that `treeline generate --tune` has written. The code is generated again when the
# URDFs, the scene, the choices or the generator change, compiled again only where its text did.
# Relative paths are relative to the calling CMakeLists.txt.

# Which sources there will be the program tells when the project is configured, where it is there by then:
# an installed one is, one of this very build is not. Without it there is a source for every function that a
# scene may ask for: TREELINE_FUNCTIONS, from treeline_functions.cmake.

if(POLICY CMP0116)
  cmake_policy(SET CMP0116 NEW)  # DEPFILE of Ninja names absolute paths
endif()

option(TREELINE_FP_CONTRACT
  "Leave it to the compiler whether products and sums are fused; OFF: same bits on every target" ON)

# Sets RESULT to the lines of the scene that may have a key, else to nothing.
function(treeline_find_key scene key result)
  set(line)
  if(scene AND EXISTS ${scene})
    file(STRINGS ${scene} line REGEX "(^|[{,]) *[\"']?${key}[\"']? *:")
  endif()
  set(${result} "${line}" PARENT_SCOPE)
endfunction()

# Sets RESULT to the names of the sources that the program makes of these inputs, as far as it can tell
# now; else to nothing. It is asked again when they change.
function(treeline_ask_for_sources urdf scene options result)
  set(${result} "" PARENT_SCOPE)
  get_target_property(imported treeline::treeline IMPORTED)
  if(NOT imported)
    return()
  endif()
  foreach(input IN ITEMS ${urdf} ${scene})
    get_source_file_property(generated ${input} GENERATED)
    if(generated OR NOT EXISTS ${input})
      return()
    endif()
  endforeach()
  get_target_property(program treeline::treeline LOCATION)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${urdf} ${program})
  execute_process(COMMAND ${program} generate ${urdf} ${scene} ${options} --list-sources
    OUTPUT_VARIABLE listed RESULT_VARIABLE failed ERROR_QUIET)
  if(failed)
    return()  # and the build will say why
  endif()
  string(REGEX MATCHALL "[^\n]+" listed "${listed}")
  set(${result} ${listed} PARENT_SCOPE)
endfunction()

# Sets RESULT to all sources that the program may make of a scene.
function(treeline_possible_sources scene ending result)
  set(sources ${TREELINE_FUNCTIONS} id)
  treeline_find_key("${scene}" batch batch)
  if(batch)
    list(TRANSFORM TREELINE_FUNCTIONS PREPEND batch_ OUTPUT_VARIABLE batch_sources)
    list(APPEND sources ${batch_sources})
  endif()
  treeline_find_key("${scene}" controller controller)
  if(controller)
    list(APPEND sources controller controller_kinematics controller_gravity controller_joint_torque
      controller_push_torque controller_task_torque)
  endif()
  treeline_find_key("${scene}" ground ground)
  if(ground)
    list(APPEND sources ground ground_flight ground_heights ground_dynamics ground_energy)
  endif()
  treeline_find_key("${scene}" selftest selftest)
  if(selftest)
    list(APPEND sources selftest)
  endif()
  if(ending STREQUAL "c")
    list(APPEND sources damped_control_torque limited_control_torque
      batch_limited_control_torque)  # in C++ headers
  endif()
  set(${result} ${sources} PARENT_SCOPE)
endfunction()

function(treeline_generate target)
  cmake_parse_arguments(PARSE_ARGV 1 arg ""
    "URDF;SCENE;NAME;REAL;LANGUAGE;PROFILE;OPTIMIZE;TARGET;CHOICES" "FUNCTIONS")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "treeline_generate(${target}): unknown ${arg_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT arg_URDF AND NOT arg_SCENE)
    message(FATAL_ERROR
      "treeline_generate(${target}): URDF is missing, and no SCENE is there that lists robots")
  endif()
  set(from ${arg_SCENE})
  if(arg_URDF)
    get_filename_component(arg_URDF ${arg_URDF} ABSOLUTE)
    set(from ${arg_URDF})
  endif()
  if(arg_SCENE)
    get_filename_component(arg_SCENE ${arg_SCENE} ABSOLUTE)
    # Only where the scene may ask for batches there are any; an edit that adds the key configures
    # anew.
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${arg_SCENE})
  endif()
  if(NOT arg_NAME)
    string(MAKE_C_IDENTIFIER ${target} arg_NAME)
  endif()

  set(folder ${CMAKE_CURRENT_BINARY_DIR}/treeline/${target}/${arg_NAME})
  set(options --name ${arg_NAME})
  if(arg_REAL)
    list(APPEND options --real ${arg_REAL})
  endif()
  treeline_find_key("${arg_SCENE}" language language)
  if(NOT arg_LANGUAGE AND language MATCHES ": *[\"']?c[\"']? *(#.*)?$")
    set(arg_LANGUAGE c)
  endif()
  if(language MATCHES ": *[\"']?opencl[\"']? *(#.*)?$" AND NOT arg_LANGUAGE)
    set(arg_LANGUAGE opencl)
  endif()
  set(ending cpp)
  set(standard cxx_std_17)
  set(compiler ${CMAKE_CXX_COMPILER_ID})
  if(arg_LANGUAGE STREQUAL "c")
    get_property(languages GLOBAL PROPERTY ENABLED_LANGUAGES)
    if(NOT "C" IN_LIST languages)
      message(FATAL_ERROR "treeline_generate(${target}): the project lacks the language C, "
        "call enable_language(C)")
    endif()
    set(ending c)
    set(standard c_std_99)
    set(compiler ${CMAKE_C_COMPILER_ID})
  elseif(arg_LANGUAGE AND NOT arg_LANGUAGE MATCHES "^(c\\+\\+|opencl)$")
    message(FATAL_ERROR "treeline_generate(${target}): LANGUAGE is c, c++ or opencl, not ${arg_LANGUAGE}")
  endif()
  if(arg_LANGUAGE)
    list(APPEND options --language ${arg_LANGUAGE})
  endif()
  if(arg_PROFILE)
    list(APPEND options --profile ${arg_PROFILE})
  endif()
  if(arg_OPTIMIZE)
    list(APPEND options --optimize ${arg_OPTIMIZE})
  endif()
  if(arg_FUNCTIONS)
    list(JOIN arg_FUNCTIONS , functions)
    list(APPEND options --functions ${functions})
  endif()

  if(arg_TARGET)
    list(APPEND options --target ${arg_TARGET})
  endif()
  if(arg_CHOICES)
    get_filename_component(arg_CHOICES ${arg_CHOICES} ABSOLUTE)
    list(APPEND options --choices ${arg_CHOICES})
  endif()

  set(stamp ${folder}.stamp)
  set(generate treeline::treeline generate ${arg_URDF} ${arg_SCENE} --output ${folder} ${options})
  set(dependencies ${arg_URDF} ${arg_SCENE} ${arg_CHOICES} treeline::treeline)
  set(depfile)
  if(NOT arg_URDF)  # which URDFs the scene lists is known once it is read
    list(APPEND generate --depfile ${stamp}.d)
    set(depfile DEPFILE ${stamp}.d)
  endif()
  if(arg_LANGUAGE STREQUAL "opencl")
    add_custom_command(OUTPUT ${stamp}
      COMMAND ${generate}
      COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
      DEPENDS ${dependencies}
      ${depfile}
      COMMENT "Generating ${arg_NAME} from ${from}"
      VERBATIM)
    add_custom_target(${target}_generate DEPENDS ${stamp})
    add_library(${target} INTERFACE)
    add_dependencies(${target} ${target}_generate)
    target_include_directories(${target} INTERFACE ${folder})
    return()
  endif()

  treeline_ask_for_sources("${arg_URDF}" "${arg_SCENE}" "${options}" sources)
  if(NOT sources)
    treeline_possible_sources("${arg_SCENE}" ${ending} sources)
  endif()
  set(stems ${sources})
  list(TRANSFORM sources REPLACE "(.+)" "${folder}.sources/\\1.${ending}")
  set(flags ${folder}.sources/target.flags)
  list(TRANSFORM stems REPLACE "(.+)" "${folder}.sources/\\1.flags" OUTPUT_VARIABLE own_flags)
  # Files that are not known to be made here would look as they were before to what includes them, and
  # Ninja would compile that one build too late. collect_sources.cmake lists them; where their names
  # change, the next build configures again.
  set(list ${folder}.files)
  if(NOT EXISTS ${list})
    file(WRITE ${list} "")
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${list})
  file(STRINGS ${list} files)
  list(TRANSFORM files PREPEND ${folder}/)
  add_custom_command(OUTPUT ${stamp}
    BYPRODUCTS ${sources} ${flags} ${own_flags} ${files}
    COMMAND ${generate}
    COMMAND ${CMAKE_COMMAND} -DFOLDER=${folder} "-DFUNCTIONS=${stems}" -DENDING=${ending}
      "-DCROSSCOMPILING=${CMAKE_CROSSCOMPILING}" "-DTARGET_FLAGS=${TREELINE_TARGET_FLAGS}"
      -DCOMPILER=${compiler}
      -P ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/collect_sources.cmake
    COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
    DEPENDS ${dependencies} ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/collect_sources.cmake
    ${depfile}
    COMMENT "Generating ${arg_NAME} from ${from}"
    VERBATIM)
  add_custom_target(${target}_generate DEPENDS ${stamp})

  set_source_files_properties(${sources} PROPERTIES GENERATED ON)
  add_library(${target} STATIC ${sources})
  add_dependencies(${target} ${target}_generate)
  target_include_directories(${target} PUBLIC ${folder})
  target_compile_features(${target} PUBLIC ${standard})
  if(compiler MATCHES "GNU|Clang" AND NOT APPLE AND NOT MSVC)  # as in the emitted CMakeLists.txt
    target_link_options(${target} INTERFACE "LINKER:--undefined=${arg_NAME}_id")
  endif()
  if(NOT DEFINED CMAKE_POSITION_INDEPENDENT_CODE AND NOT CMAKE_SYSTEM_NAME STREQUAL "Generic")
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)  # for shared libraries
  endif()
  if(compiler MATCHES "GNU|Clang|IntelLLVM")
    target_compile_options(${target} PRIVATE -fno-fast-math @${flags})
    if(compiler STREQUAL "GNU")  # as in the emitted CMakeLists.txt
      target_compile_options(${target} PRIVATE
        "$<$<IN_LIST:$<CONFIG>,Release;RelWithDebInfo;MinSizeRel>:-flive-range-shrinkage>"
        "$<$<IN_LIST:$<CONFIG>,Release;RelWithDebInfo;MinSizeRel>:-frename-registers>")
    endif()
    foreach(source own IN ZIP_LISTS sources own_flags)
      set_source_files_properties(${source} PROPERTIES
        COMPILE_OPTIONS @${own} OBJECT_DEPENDS "${flags};${own}")
    endforeach()
    if(NOT TREELINE_FP_CONTRACT)
      target_compile_options(${target} PRIVATE -ffp-contract=off)
      if(compiler STREQUAL "GNU")
        target_compile_options(${target} PRIVATE -fno-tree-slp-vectorize)
      endif()
    endif()
  endif()
endfunction()
