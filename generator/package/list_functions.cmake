# Writes FILE, which sets TREELINE_FUNCTIONS to every function that a scene may ask for: the names in
# the rows of `kFunctions` in TABLE, functions/function_rows.hpp, but for those that are never named.
function(treeline_list_functions table file)
  file(READ ${table} text)
  string(REGEX MATCHALL
    "{Function::[a-z_]+,[ \n]*\"[a-z_]+\",[ \n]*FunctionGroup::[a-z_]+,[ \n]*Emitted::[a-z_]+"
    rows "${text}")
  list(FILTER rows EXCLUDE REGEX "Emitted::with_damping")
  list(TRANSFORM rows REPLACE "^[^\"]*\"([a-z_]+)\".*$" "\\1" OUTPUT_VARIABLE names)
  list(LENGTH names count)
  if(count LESS 23)
    message(FATAL_ERROR "${table} lists ${count} functions only: its rows have another form")
  endif()
  list(JOIN names " " names)
  file(CONFIGURE OUTPUT ${file} CONTENT "set(TREELINE_FUNCTIONS ${names} CACHE INTERNAL \"\")\n" @ONLY)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${table})
endfunction()
