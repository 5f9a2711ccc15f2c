# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0

# register_rules(OUT FILE...): writes the source of registered_rules() from the rules' file names, so
# that adding a rule touches one file. A file `kinematics/axis-zero.cc` defines rigor::rules::axis_zero::
# rule(); one that ends in `_rules.cc`, as `convert/convert_rules.cc`, a function of that name, which
# returns several. The folder is their category.
function(register_rules out)
  set(declarations "")
  set(calls "")
  foreach(file ${ARGN})
    cmake_path(GET file STEM stem)
    cmake_path(GET file PARENT_PATH folder)
    cmake_path(GET folder FILENAME folder)
    string(REGEX MATCH "^(.)(.*)$" folder ${folder})
    string(TOUPPER ${CMAKE_MATCH_1} initial)
    set(category Category::k${initial}${CMAKE_MATCH_2})
    if(stem MATCHES "_rules$")
      string(APPEND declarations "std::vector<Rule> ${stem}();\n")
      string(APPEND calls "  for (Rule& rule : ${stem}()) add(${category}, std::move(rule));\n")
    elseif(NOT stem MATCHES "_")  # snake_case: a helper of its folder, not a rule
      string(REPLACE "-" "_" name ${stem})
      string(APPEND declarations "namespace ${name} { Rule rule(); }\n")
      string(APPEND calls "  add(${category}, ${name}::rule());\n")
    endif()
  endforeach()
  set(source ${CMAKE_CURRENT_BINARY_DIR}/registered_rules.cc)
  set(code "#include <rigor/rules/registered.h>

#include <utility>

namespace rigor::rules {
${declarations}
std::vector<Rule> registered_rules() {
  std::vector<Rule> rules;
  const auto add = [&rules](Category category, Rule rule) {
    rule.category = category;
    rules.push_back(std::move(rule));
  };
${calls}  return rules;
}

}  // namespace rigor::rules
")
  file(CONFIGURE OUTPUT ${source} CONTENT "@code@" @ONLY)
  set(${out} ${source} PARENT_SCOPE)
endfunction()
