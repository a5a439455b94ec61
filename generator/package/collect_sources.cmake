# One source for every function that a scene may ask for, so that a build knows its sources before
# the scene is read: it includes the generated source, or is empty where there is none.
# cmake -DFOLDER=generated-folder -DFUNCTIONS=list -P collect_sources.cmake
foreach(function IN LISTS FUNCTIONS)
  set(text "// The scene does not ask for ${function}.\n")
  if(EXISTS ${FOLDER}/${function}.cpp)
    set(text "#include \"${FOLDER}/${function}.cpp\"\n")
  endif()
  file(CONFIGURE OUTPUT ${FOLDER}.sources/${function}.cpp CONTENT "${text}" @ONLY)  # if it differs
endforeach()
