// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <rigor/report/number.h>
#include <rigor/report/places.h>
#include <rigor/report/robot_diff/robot_diff.h>
#include <rigor/report/terminal/printable.h>

namespace rigor::report {
namespace {

using robot::Difference;
using robot::DifferenceKind;
using robot::DifferenceValue;

/// Longer lists (the outline of a polyline) are cut.
constexpr std::size_t kMaxNumbers = 12;
constexpr std::size_t kPoseNumbers = 7;

std::string number_in_words(double value, int digits) {
  if (std::isinf(value)) return value > 0 ? "unlimited" : "-unlimited";
  return number(value, digits);
}

std::string list_in_words(const std::vector<double>& all, int digits) {
  std::string text;
  for (std::size_t i = 0; i < std::min(all.size(), kMaxNumbers); ++i) {
    text += (i > 0 ? " " : "") + number_in_words(all[i], digits);
  }
  return all.size() > kMaxNumbers ? text + " …" : text;
}

/// With as many digits as it takes to tell them apart.
std::string change_in_words(const std::vector<double>& from, const std::vector<double>& to) {
  for (const int digits : {6, 9, 12, 17}) {
    const std::string a = list_in_words(from, digits), b = list_in_words(to, digits);
    if (a != b || digits == 17) return a + " → " + b;
  }
  return {};
}

std::string with_unit(std::string text, std::string_view unit) {
  return unit.empty() ? text : text + ' ' + std::string(unit);
}

std::string distance_in_words(double distance) {
  constexpr double kMillimeters = 1;  // from here on meters are easier to read
  constexpr double kTiny = 1e-6;
  if (distance >= kTiny && distance < kMillimeters) return number(1000 * distance) + " mm";
  return number(distance) + " m";
}

std::string apart_in_words(const Difference& d) {
  // What is a millionth of the other is rounding of it.
  constexpr double kShare = 1e-6;
  std::string text;
  if (d.distance > kShare * d.angle || d.angle == 0) {
    text = "moved by " + distance_in_words(d.distance);
  }
  if (d.angle > kShare * d.distance) {
    text += (text.empty() ? "rotated by " : ", rotated by ") + number(d.angle) + " rad";
  }
  return text;
}

std::string pose_change(const Difference& d) {
  if (d.from.numbers.size() != kPoseNumbers || d.to.numbers.size() != kPoseNumbers) return {};
  const auto split = [](const std::vector<double>& n) {
    const model::Vector3 rpy = to_rpy({n[3], n[4], n[5], n[6]});
    return std::pair{std::vector<double>{n[0], n[1], n[2]},
                     std::vector<double>{rpy.x, rpy.y, rpy.z}};
  };
  const auto [xyz_a, rpy_a] = split(d.from.numbers);
  const auto [xyz_b, rpy_b] = split(d.to.numbers);
  std::string text;
  if (xyz_a != xyz_b && d.distance > 0) text = "xyz " + change_in_words(xyz_a, xyz_b) + " m";
  if (rpy_a != rpy_b && d.angle > 0) {
    text += (text.empty() ? "rpy " : ", rpy ") + change_in_words(rpy_a, rpy_b) + " rad";
  }
  return text.empty() ? "" : ": " + text;
}

std::string moved_in_words(const Difference& d) {
  std::string text = d.from.text != d.to.text ? "is fixed to " + d.from.text + " → " + d.to.text
                                              : apart_in_words(d) + pose_change(d);
  if (d.configuration > 0)
    text += " (at random joint positions " + std::to_string(d.configuration) + "; at rest less)";
  return text;
}

std::string inertia_in_words(const Difference& d) {
  constexpr std::string_view kNames[] = {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"};
  std::string text = "inertia";
  for (std::size_t i = 0; i < std::size(kNames); ++i) {
    if (d.from.numbers[i] == d.to.numbers[i]) continue;
    text += (text == "inertia" ? " " : ", ") + std::string(kNames[i]) + ' ' +
            change_in_words({d.from.numbers[i]}, {d.to.numbers[i]});
  }
  return with_unit(text, d.unit);
}

std::string shape_in_words(const DifferenceValue& shape, std::string_view unit) {
  if (shape.numbers.empty()) return shape.text;
  return shape.text + " (" + with_unit(list_in_words(shape.numbers, 6), unit) + ")";
}

std::string mimic_in_words(const DifferenceValue& value) {
  if (value.text.empty()) return "nothing";
  return fmt::format("{} × {} + {}", value.text, number(value.numbers[0]),
                     number(value.numbers[1]));
}

std::string value_in_words(std::string_view name, const Difference& d) {
  const bool one = d.from.numbers.size() == 1 && d.to.numbers.size() == 1;
  if (one && (std::isinf(d.from.numbers[0]) || std::isinf(d.to.numbers[0]))) {
    const auto side = [&d](double value) {
      return std::isinf(value) ? number_in_words(value, 6) : with_unit(number(value), d.unit);
    };
    return fmt::format("{} {} → {}", name, side(d.from.numbers[0]), side(d.to.numbers[0]));
  }
  const std::string text =
      fmt::format("{} {}", name, with_unit(change_in_words(d.from.numbers, d.to.numbers), d.unit));
  const bool mass = d.kind == DifferenceKind::kMass || d.kind == DifferenceKind::kTotalMass;
  const double share = one ? d.to.numbers[0] / d.from.numbers[0] - 1 : 0;
  if (!mass || !std::isfinite(share)) return text;
  return text + fmt::format(" ({}{} %)", share > 0 ? "+" : "", number(100 * share, 3));
}

std::string only_in_words(std::string_view change, const DifferenceValue& value,
                          std::string_view unit) {
  if (value.text.empty() && value.numbers.empty()) return std::string(change);
  if (!value.text.empty()) return fmt::format("{}: {}", change, shape_in_words(value, unit));
  return fmt::format("{}: {}", change, with_unit(list_in_words(value.numbers, 6), unit));
}

/// What is not written is what the format takes without it.
std::string setting_in_words(const Difference& d) {
  const auto side = [](const std::string& text) { return text.empty() ? "default" : text; };
  return fmt::format("{} {} → {}", d.what, side(d.from.text), side(d.to.text));
}

std::string color_in_words(const Difference& d) {
  if (!d.from.numbers.empty() && !d.to.numbers.empty()) return value_in_words("color", d);
  const bool removed = d.to.numbers.empty();
  return fmt::format("color {}: {}", removed ? "removed" : "added",
                     list_in_words(removed ? d.from.numbers : d.to.numbers, 6));
}

}  // namespace

std::string in_words(const Difference& d) {
  switch (d.kind) {
    case DifferenceKind::kLinkOnlyInA:
    case DifferenceKind::kJointOnlyInA:
    case DifferenceKind::kFrameOnlyInA:
    case DifferenceKind::kCollisionOnlyInA:
    case DifferenceKind::kAttachmentOnlyInA:
    case DifferenceKind::kVisualOnlyInA: return only_in_words("removed", d.from, d.unit);
    case DifferenceKind::kLinkOnlyInB:
    case DifferenceKind::kJointOnlyInB:
    case DifferenceKind::kFrameOnlyInB:
    case DifferenceKind::kCollisionOnlyInB:
    case DifferenceKind::kAttachmentOnlyInB:
    case DifferenceKind::kVisualOnlyInB: return only_in_words("added", d.to, d.unit);
    case DifferenceKind::kLinkRenamed:
    case DifferenceKind::kJointRenamed:
    case DifferenceKind::kPartRenamed: return "renamed to " + d.b.substr(d.b.find(' ') + 1);
    case DifferenceKind::kJointMoved:
    case DifferenceKind::kLinkMoved:
    case DifferenceKind::kCollisionMoved:
    case DifferenceKind::kVisualMoved:
    case DifferenceKind::kFrameMoved: return moved_in_words(d);
    case DifferenceKind::kJointMotion: return "moves its child otherwise: " + moved_in_words(d);
    case DifferenceKind::kWorldPose: return "elsewhere: " + moved_in_words(d);
    case DifferenceKind::kModelPose: return "model " + moved_in_words(d);
    case DifferenceKind::kRootPose: return "in the model " + moved_in_words(d);
    case DifferenceKind::kJointType: return "type " + d.from.text + " → " + d.to.text;
    case DifferenceKind::kJointParent: return "parent " + d.from.text + " → " + d.to.text;
    case DifferenceKind::kJointChild: return "child " + d.from.text + " → " + d.to.text;
    case DifferenceKind::kJointAxis: return value_in_words("axis", d);
    case DifferenceKind::kLower: return value_in_words("lower limit", d);
    case DifferenceKind::kUpper: return value_in_words("upper limit", d);
    case DifferenceKind::kEffort: return value_in_words("effort", d);
    case DifferenceKind::kVelocity: return value_in_words("velocity", d);
    case DifferenceKind::kDamping: return value_in_words("damping", d);
    case DifferenceKind::kFriction: return value_in_words("friction", d);
    case DifferenceKind::kSpringReference: return value_in_words("spring reference", d);
    case DifferenceKind::kSpringStiffness: return value_in_words("spring stiffness", d);
    case DifferenceKind::kMimic:
      return "follows " + mimic_in_words(d.from) + " → " + mimic_in_words(d.to);
    case DifferenceKind::kMass: return value_in_words("mass", d);
    case DifferenceKind::kCenterOfMass:
      return value_in_words("center of mass", d) + ", by " + distance_in_words(d.distance);
    case DifferenceKind::kInertia: return inertia_in_words(d);
    case DifferenceKind::kShape:
      return "shape " + shape_in_words(d.from, d.unit) + " → " + shape_in_words(d.to, d.unit);
    case DifferenceKind::kSize:
      return value_in_words(d.from.text == "mesh" ? "scale of mesh" : "size of " + d.from.text, d);
    case DifferenceKind::kMesh: return "mesh " + d.from.text + " → " + d.to.text;
    case DifferenceKind::kColor: return color_in_words(d);
    case DifferenceKind::kTotalMass: return value_in_words("total mass", d);
    case DifferenceKind::kTotalFirst: return value_in_words("total first moment of mass", d);
    case DifferenceKind::kTotalSecond: return value_in_words("total moment of inertia", d);
    case DifferenceKind::kStatic: return d.from.text + " → " + d.to.text;
    case DifferenceKind::kSetting: return setting_in_words(d);
  }
  return "differs";
}

std::string robot_diff_text(const RobotDiff& diff) {
  Places places(diff.sources);
  std::string text;
  for (const Difference& d : diff.differences) {
    const Span where = d.span_b.nowhere() ? d.span_a : d.span_b;
    if (!where.nowhere()) {
      text += printable(places.path(where)) + ':' + std::to_string(places.begin(where).line) + ": ";
    }
    text += printable((d.a.empty() ? d.b : d.a) + ": " + in_words(d)) + '\n';
  }
  return text;
}

}  // namespace rigor::report
