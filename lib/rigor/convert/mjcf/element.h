// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// An MJCF file as a tree of elements, in the order in which it is written; and numbers as MJCF has them.
//
//   MjcfElement geom{"geom", {{"type", "box"}, {"size", mjcf_numbers({0.1, 0.2, 0.3})}}};
//   body.children.push_back(std::move(geom));
//   write(mjcf_text(model));

#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/model/pose.h>

namespace rigor::convert {

struct MjcfElement {
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes = {};  ///< values are not escaped
  std::vector<MjcfElement> children = {};
  std::vector<std::string> comments = {};  ///< before it, without `<!--`

  void set(std::string_view attribute, std::string value) {
    attributes.emplace_back(attribute, std::move(value));
  }
  MjcfElement& add(MjcfElement child) { return children.emplace_back(std::move(child)); }
};

/// Two spaces a level; sections are separated by blank lines.
std::string mjcf_text(const MjcfElement& root);

/// The shortest text that reads back the same, never "-0".
std::string mjcf_number(double value);
std::string mjcf_numbers(std::initializer_list<double> values);

/// w x y z with w ≥ 0. A component that is rounding of a right angle, below 1e-16, is 0.
std::string mjcf_quaternion(const model::Quaternion& q);

/// `pos` and `quat` where they are not the defaults; `pos` is the text that is given.
void set_placement(MjcfElement& element, std::string pos, const model::Quaternion& rotation);
void set_placement(MjcfElement& element, const model::Pose& X);

}  // namespace rigor::convert
