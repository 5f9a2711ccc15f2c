// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether the joints can be where a keyframe has them.

#include <cmath>
#include <string>
#include <vector>

#include <rigor/read/mjcf/mjcf_checks.h>

namespace rigor::read {
namespace {

/// rad or m: the digits that people write.
constexpr double kStateDigits = 1e-3;
/// Of the range: where a keyframe was taken from a simulation, a soft limit is pressed so far.
constexpr double kPressed = 0.05;

struct MjcfCoordinate {
  std::string joint;
  std::size_t numbers = 1;  ///< of a free joint 7, of a ball 4
  bool limited = false;
  double lower = 0, upper = 0;  ///< rad or m
};

/// Joints of a body come before those of bodies in it, wherever they are written.
class MjcfCoordinates {
 public:
  explicit MjcfCoordinates(const MjcfScope& scope) : scope_(scope) {
    for (const xml::Element section : scope.tree.children(scope.tree.root())) {
      if (section.name() == "worldbody") add_bodies(section, MjcfDefaults::kMain);
    }
  }

  const std::vector<MjcfCoordinate>& all() const { return all_; }

 private:
  std::size_t class_inside(xml::Element element, std::size_t around) const {
    return scope_.defaults.find(mjcf_name(element, "childclass").value).value_or(around);
  }

  void add_bodies(xml::Element parent, std::size_t class_id) {
    for (const xml::Element child : scope_.tree.children(parent)) {
      const std::size_t inside = class_inside(child, class_id);
      if (child.name() == "frame") add_bodies(child, inside);
      if (child.name() != "body") continue;
      add_joints(child, inside);
      add_bodies(child, inside);
    }
  }

  void add_joints(xml::Element parent, std::size_t class_id) {
    for (const xml::Element child : scope_.tree.children(parent)) {
      const std::string_view tag = child.name();
      if (tag == "frame") add_joints(child, class_inside(child, class_id));
      if (tag == "freejoint") all_.push_back({mjcf_name(child, "name").value, 7});
      if (tag != "joint") continue;
      add_joint(scope_.defaults.values(child, "joint", mjcf_class_of(scope_, child, class_id)));
    }
  }

  void add_joint(const MjcfValues& values) {
    MjcfCoordinate one{mjcf_name(values.element(), "name").value};
    const std::string type = values.string("type", "hinge").value;
    one.numbers = type == "free" ? 7 : type == "ball" ? 4 : 1;
    const std::vector<double> range = values.numbers("range");
    const std::string mode = values.string("limited", "auto").value;
    const bool on = mode == "true" || (mode == "auto" && scope_.settings.auto_limits);
    if (one.numbers == 1 && on && range.size() == 2 && range[0] < range[1]) {
      const auto in_radians = [&](double v) {
        return type == "hinge" ? scope_.settings.radians(v) : v;
      };
      one.limited = true;
      one.lower = in_radians(range[0]);
      one.upper = in_radians(range[1]);
    }
    all_.push_back(std::move(one));
  }

  const MjcfScope& scope_;
  std::vector<MjcfCoordinate> all_;
};

/// What is odd about the positions of a keyframe; empty when nothing is.
std::string odd_state(const std::vector<double>& qpos, const MjcfCoordinates& coordinates) {
  std::size_t at = 0;
  for (const MjcfCoordinate& one : coordinates.all()) {
    if (at + one.numbers > qpos.size()) return {};
    const std::string joint = one.joint.empty() ? "a joint" : "joint '" + one.joint + "'";
    const double slack = kStateDigits + kPressed * (one.upper - one.lower);
    if (one.limited && (qpos[at] < one.lower - slack || qpos[at] > one.upper + slack)) {
      return joint + " is at " + mjcf_digits(qpos[at]) + ", outside its range " +
             mjcf_digits(one.lower) + " to " + mjcf_digits(one.upper);
    }
    if (one.numbers >= 4) {
      const std::size_t q = at + one.numbers - 4;
      if (qpos[q] == 0 && qpos[q + 1] == 0 && qpos[q + 2] == 0 && qpos[q + 3] == 0)
        return "the quaternion of " + joint + " is zero";
    }
    at += one.numbers;
  }
  return {};
}

}  // namespace

void check_mjcf_states(const MjcfScope& scope, MjcfFacts& facts) {
  if (makes_names(scope)) return;  // their joints are not counted here
  const MjcfCoordinates coordinates(scope);
  for (const xml::Element key : scope.tree.in_sections("keyframe")) {
    const auto text = attribute_text(key, "qpos");
    const auto qpos = text ? mjcf_numbers(text->text) : std::nullopt;
    if (!qpos) continue;
    std::string odd = odd_state(*qpos, coordinates);
    if (odd.empty()) continue;
    const std::string name = mjcf_name(key, "name").value;
    facts.push_back({.kind = MjcfFactKind::kKeyframeState,
                     .where = text->span,
                     .subject = name.empty() ? name : "key " + name,
                     .detail = std::move(odd)});
  }
}

}  // namespace rigor::read
