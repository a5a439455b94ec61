# Files as constants of a library: HEADER, as its sources include it, is written to the build with the texts beside it. It
# follows changes of the files, and new ones.

# Sets RESULT to the contents of FILE as a literal of C++.
function(quote_file file result)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(READ ${file} content)
  set(${result} "R\"__(${content})__\"" PARENT_SCOPE)
endfunction()

function(write_embedded target header namespace includes declarations definitions)
  set(place ${PROJECT_BINARY_DIR}/embedded)
  string(REGEX REPLACE "[.]hpp$" ".cpp" source ${header})
  file(CONFIGURE OUTPUT ${place}/${header} @ONLY
    CONTENT "#pragma once\n\n${includes}\nnamespace ${namespace} {\n\n${declarations}\n}  // namespace ${namespace}\n")
  file(CONFIGURE OUTPUT ${place}/${source} @ONLY
    CONTENT "#include \"${header}\"\n\nnamespace ${namespace} {\n\n${definitions}\n}  // namespace ${namespace}\n")
  target_sources(${target} PRIVATE ${place}/${source})
  target_include_directories(${target} PUBLIC ${place})
endfunction()

# embed_files(TARGET HEADER NAMESPACE GLOB...): each file is `extern const std::string_view kNAME`, of the words of its
# path behind what precedes the star of GLOB, up to a dot: packages/fmu/wrapper2.c.in of packages/*/* is kFmuWrapper2.
function(embed_files target header namespace)
  foreach(glob IN LISTS ARGN)
    string(REGEX MATCH "^[^*]*/" base ${glob})
    file(GLOB files RELATIVE ${base} CONFIGURE_DEPENDS ${glob})
    foreach(file IN LISTS files)
      string(REGEX REPLACE "[.].*" "" stem ${file})
      string(REGEX MATCHALL "[A-Za-z0-9]+" words ${stem})
      set(name k)
      foreach(word IN LISTS words)
        string(SUBSTRING ${word} 0 1 first)
        string(TOUPPER ${first} first)
        string(SUBSTRING ${word} 1 -1 rest)
        string(APPEND name ${first}${rest})
      endforeach()
      quote_file(${base}${file} text)
      string(APPEND declarations "extern const std::string_view ${name};\n")
      string(APPEND definitions "const std::string_view ${name} = ${text};\n\n")
    endforeach()
  endforeach()
  write_embedded(${target} ${header} ${namespace} "#include <string_view>\n" "${declarations}" "${definitions}")
endfunction()

# embed_included(TARGET HEADER NAMESPACE FOLDER FILE): names and texts of FILE and of what it includes below FOLDER are
# the pairs of `kIncluded`.
function(embed_included target header namespace folder file)
  set(next ${file})
  while(next)
    list(POP_FRONT next file)
    list(APPEND seen ${file})
    quote_file(${folder}/${file} text)
    string(APPEND pairs "    {\"${file}\", ${text}},\n")
    file(STRINGS ${folder}/${file} includes REGEX "^#include \"")
    list(TRANSFORM includes REPLACE "^#include \"([^\"]*)\".*" "\\1")
    get_filename_component(place ${file} DIRECTORY)
    list(TRANSFORM includes PREPEND ${place}/ REGEX "^[^/]+$")
    list(APPEND next ${includes})
    list(REMOVE_DUPLICATES next)
    list(REMOVE_ITEM next ${seen})
  endwhile()
  set(type "const std::vector<std::pair<std::string_view, std::string_view>> kIncluded")
  write_embedded(${target} ${header} ${namespace} "#include <string_view>\n#include <utility>\n#include <vector>\n"
    "extern ${type};\n" "${type} = {\n${pairs}};\n")
endfunction()
