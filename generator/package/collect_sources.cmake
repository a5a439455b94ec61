# One source for every function that a scene may ask for, so that a build knows its sources before
# the scene is read: it includes the generated source, or is empty where there is none.
# The compiler's options for the scene's processor go to the file target.flags; where the scene has
# the key `optimize`, those of a single source to a file such as gravity.flags.
# cmake -DFOLDER=generated-folder -DFUNCTIONS=list -DENDING=cpp|c -DCROSSCOMPILING=ON|OFF
#   -DTARGET_FLAGS=ON|OFF|"" -DOPTIMIZES=ON|OFF -P collect_sources.cmake
file(GLOB sources ${FOLDER}/*.${ENDING})
if(NOT sources)
  message(FATAL_ERROR "${FOLDER} has no .${ENDING}: say which LANGUAGE treeline_generate makes")
endif()
cmake_policy(SET CMP0057 NEW)  # IN_LIST
foreach(function IN LISTS FUNCTIONS)
  # ISO C forbids an empty translation unit.
  set(text "// The scene does not ask for ${function}.\n")
  if(ENDING STREQUAL "c")
    string(APPEND text "typedef int treeline_not_asked_for;\n")
  endif()
  if(EXISTS ${FOLDER}/${function}.${ENDING})
    set(text "#include \"${FOLDER}/${function}.${ENDING}\"\n")
  endif()
  file(CONFIGURE OUTPUT ${FOLDER}.sources/${function}.${ENDING} CONTENT "${text}" @ONLY)  # if it differs
endforeach()

# Options as the emitted CMakeLists.txt has them.
file(READ ${FOLDER}/CMakeLists.txt project)
set(flags "")
if(project MATCHES "option\\(TREELINE_TARGET_FLAGS\n[^\n]*\n +([^)]*)\\)")
  set(use "${CMAKE_MATCH_1}")
  if(use STREQUAL "\${CMAKE_CROSSCOMPILING}")
    set(use "${CROSSCOMPILING}")
  endif()
  if(NOT TARGET_FLAGS STREQUAL "")
    set(use "${TARGET_FLAGS}")
  endif()
  if(use AND project MATCHES "if\\(TREELINE_TARGET_FLAGS\\)\n *target_compile_options\\([^ ]+ PRIVATE ([^)]*)\\)")
    set(flags "${CMAKE_MATCH_1}")
  endif()
endif()
if(project MATCHES "same bits on every target\" OFF\\)")
  string(APPEND flags " -ffp-contract=off")
endif()
file(CONFIGURE OUTPUT ${FOLDER}.sources/target.flags CONTENT "${flags}\n" @ONLY)  # if it differs
if(OPTIMIZES)
  set(small "")
  if(project MATCHES "set_property\\(SOURCE\n([^)]*)APPEND PROPERTY COMPILE_OPTIONS ([^)]*)\\)")
    set(small_flags "${CMAKE_MATCH_2}")
    string(REGEX MATCHALL "[^ \n]+" small "${CMAKE_MATCH_1}")
  endif()
  foreach(function IN LISTS FUNCTIONS)
    set(flags "")
    if("${function}.${ENDING}" IN_LIST small)
      set(flags "${small_flags}")
    endif()
    file(CONFIGURE OUTPUT ${FOLDER}.sources/${function}.flags CONTENT "${flags}\n" @ONLY)
  endforeach()
endif()
