# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0

# embed_templates(OUT FOLDER): writes a source file that holds the files of the templates in FOLDER, so that
# the library needs none at run time.
function(embed_templates out folder)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS RELATIVE ${folder} ${folder}/*)
  list(SORT files)
  set(code "#include <rigor/author/embedded_templates.h>\n\nnamespace rigor::author {\n")
  string(APPEND code "\nstd::vector<EmbeddedFile> embedded_templates() {\n  return {\n")
  foreach(name IN LISTS files)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${folder}/${name})
    file(READ ${folder}/${name} text)
    string(APPEND code "      {\"${name}\", R\"TEMPLATE(${text})TEMPLATE\"},\n")
  endforeach()
  string(APPEND code "  };\n}\n\n}  // namespace rigor::author\n")
  set(source ${CMAKE_CURRENT_BINARY_DIR}/embedded_templates.cc)
  file(CONFIGURE OUTPUT ${source} CONTENT "@code@" @ONLY)
  set(${out} ${source} PARENT_SCOPE)
endfunction()
