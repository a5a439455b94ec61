# One source for every function that a scene may ask for, so that a build knows its sources before
# the scene is read: it includes the generated source, or is empty where there is none.
# The compiler's options for the scene's processor go to the file target.flags.
# cmake -DFOLDER=generated-folder -DFUNCTIONS=list -DENDING=cpp|c -DCROSSCOMPILING=ON|OFF
#   -DTARGET_FLAGS=ON|OFF|"" -P collect_sources.cmake
file(GLOB sources ${FOLDER}/*.${ENDING})
if(NOT sources)
  message(FATAL_ERROR "${FOLDER} has no .${ENDING}: say which LANGUAGE treeline_generate makes")
endif()
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

# As the emitted CMakeLists.txt has them.
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
