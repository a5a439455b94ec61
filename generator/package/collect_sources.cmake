# One source for every function that a scene may ask for, so that a build knows its sources before
# the scene is read: it includes the generated source, or is empty where there is none.
# The compiler's options for the scene's processor go to the file target.flags, those of a single
# source to a file such as gravity.flags.
# cmake -DFOLDER=generated-folder -DFUNCTIONS=list -DENDING=cpp|c -DCROSSCOMPILING=ON|OFF
#   -DTARGET_FLAGS=ON|OFF|"" -DCOMPILER=GNU|Clang|... -P collect_sources.cmake
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
string(REGEX MATCHALL "set_property\\(SOURCE\n[^)]*\\)" properties "${project}")
foreach(property IN LISTS properties)
  string(REGEX MATCH "SOURCE\n([^)]*)APPEND PROPERTY COMPILE_OPTIONS ([^)]*)\\)" matched "${property}")
  set(named "${CMAKE_MATCH_1}")
  set(options "${CMAKE_MATCH_2}")
  if(options MATCHES "^-fno-live-range" AND NOT COMPILER STREQUAL "GNU")
    continue()
  endif()
  string(REGEX MATCHALL "[^ \n]+" named "${named}")
  foreach(source IN LISTS named)
    string(APPEND flags_of_${source} " ${options}")
  endforeach()
endforeach()
foreach(function IN LISTS FUNCTIONS)
  file(CONFIGURE OUTPUT ${FOLDER}.sources/${function}.flags
    CONTENT "${flags_of_${function}.${ENDING}}\n" @ONLY)
endforeach()
