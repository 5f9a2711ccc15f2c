# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0

# embed_schemas(OUT): writes a source file that holds the texts of schemas/, so that the library needs
# no file at run time.
function(embed_schemas out)
  set(code "#include <rigor/schema/embedded.h>\n\nnamespace rigor::schema {\n")
  foreach(name sdf.schema urdf.schema mjcf.schema gazebo.materials gazebo.models dialects.table)
    set(file ${PROJECT_SOURCE_DIR}/schemas/${name})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    string(REPLACE "." "_" function ${name})
    string(APPEND code "\nstd::string_view ${function}_text() {\n"
                       "  return R\"SCHEMA(${text})SCHEMA\";\n}\n")
  endforeach()
  string(APPEND code "\n}  // namespace rigor::schema\n")
  set(source ${CMAKE_CURRENT_BINARY_DIR}/embedded_schemas.cc)
  file(CONFIGURE OUTPUT ${source} CONTENT "@code@" @ONLY)
  set(${out} ${source} PARENT_SCOPE)
endfunction()
