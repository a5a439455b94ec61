# One source for every function that a scene may ask for, so that a build knows its sources before
# the scene is read: it includes the generated source, or is empty where there is none.
# cmake -DFOLDER=generated-folder -DFUNCTIONS=list -DENDING=cpp|c -P collect_sources.cmake
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
