// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/inertial_block.h>

#include <utility>

#include <fmt/core.h>

#include <rigor/schema/value.h>

namespace rigor::author {

std::string inertial_block(const mass::MassProperties& body, InertialForm form) {
  const auto text = [](double value) { return schema::to_shortest(value + 0.0); };
  const std::string com =
      fmt::format("{} {} {}", text(body.com.x), text(body.com.y), text(body.com.z));
  const mass::Inertia& I = body.about_com;
  const std::pair<const char*, double> entries[] = {{"ixx", I.ixx}, {"ixy", I.ixy}, {"ixz", I.ixz},
                                                    {"iyy", I.iyy}, {"iyz", I.iyz}, {"izz", I.izz}};
  std::string tensor;
  if (form == InertialForm::kUrdf) {
    for (const auto& [name, value] : entries)
      tensor += fmt::format(" {}=\"{}\"", name, text(value));
    return fmt::format(
        "<inertial>\n  <origin xyz=\"{}\"/>\n  <mass value=\"{}\"/>\n  "
        "<inertia{}/>\n</inertial>",
        com, text(body.mass), tensor);
  }
  for (const auto& [name, value] : entries)
    tensor += fmt::format("    <{0}>{1}</{0}>\n", name, text(value));
  return fmt::format(
      "<inertial>\n  <pose>{} 0 0 0</pose>\n  <mass>{}</mass>\n  <inertia>\n{}  "
      "</inertia>\n</inertial>",
      com, text(body.mass), tensor);
}

std::string indented_by(const std::string& text, const std::string& by,
                           const std::string& line) {
  std::string result = by;
  for (const char c : text) {
    if (c == '\n') {
      result += line + by;
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace rigor::author
