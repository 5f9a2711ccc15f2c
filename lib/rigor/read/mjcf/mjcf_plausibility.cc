// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Values that MuJoCo takes and nobody means: gravity that points up, degrees where radians are read, colors from 0 to
// 255, negative damping.

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <tuple>

#include <rigor/read/mjcf/mjcf_checks.h>

namespace rigor::read {
namespace {

using MjcfKind = MjcfFactKind;

/// m/s²: Jupiter has 24.8, and a factor of ten makes 98.1.
constexpr double kMaxGravity = 30;
/// s: MuJoCo's own is 0.002; at 0.02 contacts of robots are unstable.
constexpr double kMaxTimestep = 0.02;
constexpr double kTurn = 2 * std::numbers::pi;

/// Angles that people limit joints by, and no number of turns: those of winches are round (10, 100).
bool limits_in_degrees(double most) {
  constexpr double kTurns = 4 * kTurn;
  constexpr double kMost = 720;  // larger ones represent "no limit"
  if (most <= kTurn || most > kMost || most != std::round(most)) return false;
  const bool usual = std::fmod(most, 15) == 0 || most == 170 || most == 350;
  return usual || (most > kTurns && std::fmod(most, 50) != 0);
}

std::string subject_of(xml::Element element) {
  const std::string name = mjcf_name(element, "name").value;
  return name.empty() ? std::string() : std::string(element.name()) + ' ' + name;
}

class MjcfPlausibility {
 public:
  MjcfPlausibility(const MjcfScope& scope, MjcfFacts& facts) : scope_(scope), facts_(facts) {
    for (const xml::Element section : scope.tree.children(scope.tree.root())) {
      if (section.name() != "option") continue;
      timestep_ = MjcfValues(section, {}).number("timestep", timestep_).value;
    }
  }

  void check() {
    for (const xml::Element section : scope_.tree.children(scope_.tree.root())) {
      if (section.name() == "option") check_option(MjcfValues(section, {}));
    }
    for_each_mjcf_element(scope_.tree, [&](std::string_view section, xml::Element element) {
      if (section == "worldbody" || section == "default") return;
      check_in_section(section, element);
    });
    for_each_in_bodies(scope_, [&](xml::Element element, std::size_t class_id) {
      const std::string_view tag = element.name();
      const MjcfValues values = scope_.defaults.values(element, tag, class_id);
      if (tag == "joint") check_joint(values);
      if (tag == "geom") {
        check_negative(values, "friction");
        check_solver(values, "solref", "solimp");
      }
      if (tag == "geom" || tag == "site") check_color(values);
      if (tag != "joint" && tag != "freejoint" && tag != "inertial") check_angles(values);
    });
  }

 private:
  void report(MjcfKind kind, const MjcfValues& values, std::string_view attribute,
              std::string detail) {
    const auto text = values.text(attribute);
    // What a class gives is one mistake, however many elements take it.
    if (!text || !reported_.insert({text->span.source, text->span.begin, kind}).second) return;
    facts_.push_back({.kind = kind,
                      .where = text->span,
                      .subject = values.own(attribute) ? subject_of(values.element()) : "",
                      .name = std::string(attribute),
                      .detail = std::move(detail)});
  }

  void check_option(const MjcfValues& option) {
    const auto gravity = option.vector("gravity", {});
    const model::Vector3& g = gravity.value;
    const double size = length(g);
    if (size > kMaxGravity) {
      report(MjcfKind::kGravity, option, "gravity",
             "is " + mjcf_digits(size) + " m/s²; Earth has 9.81");
    } else if (g.z > 0) {
      report(MjcfKind::kGravity, option, "gravity", "points up");
    } else if (std::max(std::abs(g.x), std::abs(g.y)) > std::abs(g.z)) {
      report(MjcfKind::kGravity, option, "gravity", "points sideways: z is up in MuJoCo");
    }
    const auto timestep = option.number("timestep", 1e-3);
    if (timestep.value <= 0) {
      report(MjcfKind::kTimestep, option, "timestep", "is not above 0");
    } else if (timestep.value > kMaxTimestep) {
      report(MjcfKind::kTimestep, option, "timestep",
             "is " + mjcf_digits(timestep.value) + " s, over " + mjcf_digits(kMaxTimestep) + " s");
    }
    check_solver(option, "o_solref", "o_solimp");
  }

  void check_in_section(std::string_view section, xml::Element element) {
    const std::string_view tag = element.name();
    const std::size_t id = mjcf_class_of(scope_, element, MjcfDefaults::kMain);
    if (section == "asset" && tag == "material")
      check_color(scope_.defaults.values(element, tag, id));
    if (section == "contact" && tag == "pair") {
      const MjcfValues values = scope_.defaults.values(element, "pair", id);
      check_negative(values, "friction");
      check_solver(values, "solref", "solimp");
    }
    if (section == "equality") {
      check_solver(scope_.defaults.values(element, "equality", id), "solref", "solimp");
    }
    if (section == "tendon" && (tag == "spatial" || tag == "fixed")) {
      const MjcfValues values = scope_.defaults.values(element, "tendon", id);
      for (const char* name : {"damping", "stiffness", "frictionloss", "armature"})
        check_negative(values, name);
      check_color(values);
      check_solver(values, "solreflimit", "solimplimit");
    }
    if (section == "actuator") {
      const MjcfValues values = scope_.defaults.values_of_any(element, {tag, "general"}, id);
      const bool servo = tag == "position" || tag == "intvelocity";
      if (servo) check_negative(values, "kp");
      if (tag == "velocity") check_negative(values, "kv");
    }
  }

  void check_joint(const MjcfValues& joint) {
    for (const char* name : {"damping", "frictionloss", "armature", "stiffness"})
      check_negative(joint, name);
    check_solver(joint, "solreflimit", "solimplimit");
    check_solver(joint, "solreffriction", "solimpfriction");
    const std::string type = joint.string("type", "hinge").value;
    if (type != "hinge" && type != "slide") return;
    const auto ref = joint.number("ref", 0);
    const std::vector<double> range = joint.numbers("range");
    const bool limited = joint.string("limited", "auto").value != "false" && range.size() == 2 &&
                         range[0] < range[1];
    if (limited && ref.written && (ref.value < range[0] || ref.value > range[1])) {
      report(MjcfKind::kRefOutside, joint, "ref",
             mjcf_digits(ref.value) + " is outside the range " + mjcf_digits(range[0]) + " to " +
                 mjcf_digits(range[1]));
    }
    if (type != "hinge" || scope_.settings.degrees || !limited) return;
    const double most = std::max(std::abs(range[0]), std::abs(range[1]));
    if (limits_in_degrees(most)) report_degrees(joint, "range");
  }

  void check_angles(const MjcfValues& values) {
    if (scope_.settings.degrees) return;
    const MjcfValues own(values.element(), {});
    const std::vector<double> euler = own.numbers("euler");
    const std::vector<double> turn = own.numbers("axisangle");
    if (look_like_degrees(euler)) report_degrees(own, "euler");
    if (turn.size() == 4 && look_like_degrees({turn[3]})) report_degrees(own, "axisangle");
  }

  /// Whole numbers, one of them more than a turn in radians.
  static bool look_like_degrees(const std::vector<double>& angles) {
    double most = 0;
    for (const double angle : angles) {
      if (angle != std::round(angle)) return false;
      most = std::max(most, std::abs(angle));
    }
    return most > kTurn;
  }

  void report_degrees(const MjcfValues& values, std::string_view attribute) {
    report(MjcfKind::kDegrees, values, attribute,
           std::string(trimmed(values.text(attribute)->text)));
  }

  /// Of damping and stiffness the first number: what follows are coefficients of a polynomial.
  void check_negative(const MjcfValues& values, std::string_view attribute) {
    const double number = values.number(attribute, 0).value;
    if (number < 0) report(MjcfKind::kNegative, values, attribute, mjcf_digits(number));
  }

  void check_color(const MjcfValues& values) {
    const std::vector<double> rgba = values.numbers("rgba");
    constexpr double kRounding = 1e-6;
    if (std::any_of(rgba.begin(), rgba.end(), [](double c) { return c > 1 + kRounding; })) {
      report(MjcfKind::kColor, values, "rgba", std::string(trimmed(values.text("rgba")->text)));
    }
  }

  /// A stiffness and damping where both are negative, else a time constant and a damping ratio.
  void check_solver(const MjcfValues& values, std::string_view ref, std::string_view imp) {
    const std::vector<double> r = values.numbers(ref);
    if (r.size() == 2 && (r[0] > 0) != (r[1] > 0)) {
      report(MjcfKind::kSolver, values, ref,
             "mixes a positive and a negative number: MuJoCo takes its own default");
    } else if (!r.empty() && r[0] > 0 && timestep_ > 0 && r[0] < 2 * timestep_) {
      report(MjcfKind::kSolver, values, ref,
             "has a time constant of " + mjcf_digits(r[0]) +
                 " s: MuJoCo raises it to two time steps, " + mjcf_digits(2 * timestep_) + " s");
    }
    const std::vector<double> d = values.numbers(imp);
    const auto is_odd = [](double v) { return v < 0 || v > 1; };
    if ((!d.empty() && is_odd(d[0])) || (d.size() > 1 && is_odd(d[1]))) {
      report(MjcfKind::kSolver, values, imp, "has an impedance outside 0 to 1: MuJoCo clamps it");
    } else if (d.size() > 1 && d[0] > d[1]) {
      report(MjcfKind::kSolver, values, imp,
             "is " + mjcf_digits(d[0]) + " at contact and " + mjcf_digits(d[1]) +
                 " when deep: it softens with depth");
    }
  }

  const MjcfScope& scope_;
  MjcfFacts& facts_;
  double timestep_ = 0.002;
  std::set<std::tuple<SourceId, std::uint32_t, MjcfKind>> reported_;
};

}  // namespace

std::string mjcf_digits(double value, int digits) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::general, digits)
                       .ptr;
  return {text.data(), end};
}

void check_mjcf_plausibility(const MjcfScope& scope, MjcfFacts& facts) {
  MjcfPlausibility(scope, facts).check();
}

}  // namespace rigor::read
