# embed_files(OUTPUT.cpp HEADER NAMESPACE NAME FILE [NAME FILE]...): writes a source that defines each
# `extern const std::string_view kNAME` of HEADER as the text of FILE; follows changes of the files.
function(embed_files output header namespace)
  set(text "#include \"${header}\"\n\nnamespace ${namespace} {\n\n")
  while(ARGN)
    list(POP_FRONT ARGN name file)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} content)
    string(APPEND text "const std::string_view k${name} = R\"__(${content})__\";\n\n")
  endwhile()
  file(CONFIGURE OUTPUT ${output} CONTENT "${text}}  // namespace ${namespace}\n" @ONLY)
endfunction()
