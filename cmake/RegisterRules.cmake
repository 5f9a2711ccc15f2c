# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0

# register_rules(OUT FILE...): writes the source of registered_rules() from the rules' file names, so
# that adding a rule touches one file. A file `axis-zero.cc` defines rigor::rules::axis_zero::rule().
function(register_rules out)
  set(declarations "")
  set(calls "")
  foreach(file ${ARGN})
    cmake_path(GET file STEM stem)
    if(NOT stem MATCHES "-" AND NOT stem MATCHES "^[a-z0-9]+$")
      continue()  # snake_case: a helper of its folder, not a rule
    endif()
    string(REPLACE "-" "_" name ${stem})
    string(APPEND declarations "namespace ${name} { Rule rule(); }\n")
    string(APPEND calls "      ${name}::rule(),\n")
  endforeach()
  set(source ${CMAKE_CURRENT_BINARY_DIR}/registered_rules.cc)
  set(code "#include <rigor/rules/registered.h>\n\nnamespace rigor::rules {\n${declarations}\n\
std::vector<Rule> registered_rules() {\n  return {\n${calls}  };\n}\n\n}  // namespace rigor::rules\n")
  file(CONFIGURE OUTPUT ${source} CONTENT "@code@" @ONLY)
  set(${out} ${source} PARENT_SCOPE)
endfunction()
