// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>
#include <rigor/rules/xml/more.h>

namespace rigor::rules::xml_unbound_prefix {

void check(const xml::Fault& fault, Context& context) {
  if (fault.detail == "xacro") return;  // that is a larger mistake, and has its own rule
  context.report({.where = fault.where,
                  .message = "the prefix '" + fault.detail + "' is not declared" + and_more(fault),
                  .help = "declare it in the root element: xmlns:" + fault.detail + "=\"…\"",
                  .severity = context.is_sdf() ? std::optional(Severity::kInfo) : std::nullopt});
}

Rule rule() {
  return {
      .name = "xml-unbound-prefix",
      .severity = Severity::kWarning,
      .summary = "a namespace prefix is not declared",
      .why = "tinyxml2 (libsdformat, Gazebo, urdfdom 4) knows no namespaces and reads on; strict "
             "parsers, Python's among them, reject the file, and with them the ROS tools that are "
             "written in Python. Those read URDF: in SDF it is an info.",
      .what_to_do =
          "Declare the prefix in the root element, as xmlns:gz=\"http://gazebosim.org/schema\".",
      .checks = {on_xml({xml::FaultKind::kUnboundPrefix}, check)},
  };
}

}  // namespace rigor::rules::xml_unbound_prefix
