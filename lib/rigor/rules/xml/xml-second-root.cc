// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/rule.h>
#include <rigor/rules/xml/more.h>

namespace rigor::rules::xml_second_root {

void check(const xml::Fault& fault, Context& context) {
  context.report({.where = fault.where,
                  .message = "<" + std::string(context.bytes(fault.where)) +
                             "> is a second root element: nobody reads it" + and_more(fault),
                  .related = {{fault.related, "the first one"}}});
}

Rule rule() {
  return {
      .name = "xml-second-root",
      .severity = Severity::kWarning,
      .summary = "the file has a second root element",
      .why = "libsdformat, Gazebo and urdfdom take the first one of the name they look for and "
             "pass over the rest without a word; strict parsers refuse the file.",
      .what_to_do =
          "Put what belongs together into one root element, and the rest into files of its own.",
      .checks = {on_xml({xml::FaultKind::kSecondRoot}, check)},
  };
}

}  // namespace rigor::rules::xml_second_root
