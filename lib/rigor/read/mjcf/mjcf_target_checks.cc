// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// References to elements that exist, and are not of the kind that MuJoCo needs there: the position of a ball joint, a
// tendon around a box, a joint that is equal to itself.

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include <rigor/read/mjcf/mjcf_checks.h>

namespace rigor::read {
namespace {

using MjcfKind = MjcfFactKind;

/// Whether a limit holds, and whether a range is written at all.
struct MjcfLimit {
  bool limited = false, range = false;
};

MjcfLimit limit_of(const MjcfValues& values, const MjcfSettings& settings) {
  const std::vector<double> n = values.numbers("range");
  const std::string mode = values.string("limited", "auto").value;
  const bool has_range = n.size() == 2 && (n[0] != 0 || n[1] != 0);
  const bool by_range = settings.auto_limits && n.size() == 2 && n[0] < n[1];
  return {mode == "true" || (mode == "auto" && by_range), has_range};
}

/// What may be referred to, by name: elements of copies and of attached models have other names.
struct MjcfTargets {
  struct Joint {
    std::string type;
    MjcfLimit limit;
  };
  std::map<std::string, Joint, std::less<>> joints;
  std::map<std::string, std::string, std::less<>> geom_types;
  std::map<std::string, MjcfLimit, std::less<>> tendons;

  explicit MjcfTargets(const MjcfScope& scope) {
    for_each_in_bodies(scope, [&](xml::Element element, std::size_t class_id) {
      const std::string_view tag = element.name();
      if (tag != "joint" && tag != "freejoint" && tag != "geom") return;
      const std::string name = mjcf_name(element, "name").value;
      if (name.empty()) return;
      if (tag == "freejoint") {
        joints.try_emplace(name, Joint{"free", {}});
        return;
      }
      const MjcfValues values = scope.defaults.values(element, tag, class_id);
      if (tag == "geom") {
        // With a mesh it is fitted to, the type is that of what is fitted.
        geom_types.try_emplace(name, values.string("type", "sphere").value);
      } else {
        joints.try_emplace(
            name, Joint{values.string("type", "hinge").value, limit_of(values, scope.settings)});
      }
    });
    for (const xml::Element tendon : scope.tree.in_sections("tendon")) {
      const std::size_t id = mjcf_class_of(scope, tendon, MjcfDefaults::kMain);
      const MjcfValues values = scope.defaults.values(tendon, "tendon", id);
      tendons.try_emplace(mjcf_name(tendon, "name").value, limit_of(values, scope.settings));
    }
  }
};

class MjcfTargetCheck {
 public:
  MjcfTargetCheck(const MjcfScope& scope, MjcfFacts& facts)
      : scope_(scope), facts_(facts), targets_(scope) {}

  void check(std::string_view section, xml::Element element) {
    const std::string_view tag = element.name();
    if (section == "sensor") check_sensor(element);
    if (section == "equality") check_equality(element);
    if (section == "tendon" && tag == "geom") check_wrap(element);
    if (section == "tendon" && (tag == "spatial" || tag == "fixed")) check_limits(element);
    if (section == "actuator") check_range(element);
  }

 private:
  void reject(xml::Element element, std::string_view attribute, std::string detail) {
    const auto written = element.attribute(attribute);
    const std::string name = mjcf_name(element, "name").value;
    facts_.push_back({.kind = MjcfKind::kTargetRejected,
                      .where = written ? written->value_span() : element.tag_span(),
                      .subject = name.empty() ? name : std::string(element.name()) + ' ' + name,
                      .detail = std::move(detail)});
  }

  const MjcfTargets::Joint* joint_of(xml::Element element, std::string_view attribute) const {
    const auto found = targets_.joints.find(mjcf_name(element, attribute).value);
    return found == targets_.joints.end() ? nullptr : &found->second;
  }

  static bool is_scalar(const MjcfTargets::Joint& joint) {
    return joint.type == "hinge" || joint.type == "slide";
  }

  void check_sensor(xml::Element element) {
    const std::string tag(element.name());
    const auto* joint = joint_of(element, "joint");
    if (joint != nullptr) {
      const std::string it_is = ", and joint '" + mjcf_name(element, "joint").value + "' is ";
      const bool scalar = tag == "jointpos" || tag == "jointvel" || tag == "jointactuatorfrc";
      const bool of_ball = tag == "ballquat" || tag == "ballangvel";
      if (scalar && !is_scalar(*joint)) {
        reject(element, "joint", tag + " is of a hinge or slide" + it_is + joint->type);
      } else if (of_ball && joint->type != "ball") {
        reject(element, "joint", tag + " is of a ball" + it_is + "a " + joint->type);
      } else if (tag.starts_with("jointlimit") && !joint->limit.limited) {
        reject(element, "joint", tag + " is of a joint with limits" + it_is + "unlimited");
      }
    }
    if (!tag.starts_with("tendonlimit")) return;
    const std::string name = mjcf_name(element, "tendon").value;
    const auto tendon = targets_.tendons.find(name);
    if (tendon == targets_.tendons.end() || tendon->second.limited) return;
    reject(element, "tendon",
           tag + " is of a tendon with limits, and tendon '" + name + "' is unlimited");
  }

  void check_equality(xml::Element element) {
    for (const auto& [first, second] : {std::pair{"joint1", "joint2"},
                                        {"tendon1", "tendon2"},
                                        {"body1", "body2"},
                                        {"site1", "site2"}}) {
      const auto one = mjcf_name(element, first);
      auto other = mjcf_name(element, second);
      const bool of_bodies = one.written && std::string_view(first) == "body1";
      if (of_bodies && other.value.empty()) other.value = "world";
      if (one.written && !one.value.empty() && one.value == other.value) {
        reject(element, other.written ? second : first,
               "both sides of the constraint are '" + one.value + "'");
      }
    }
    if (element.name() != "joint") return;
    for (const char* side : {"joint1", "joint2"}) {
      const auto* joint = joint_of(element, side);
      if (joint == nullptr || is_scalar(*joint)) continue;
      reject(element, side,
             "the constraint is of hinges and slides, and joint '" +
                 mjcf_name(element, side).value + "' is " + joint->type);
    }
  }

  void check_wrap(xml::Element element) {
    const std::string name = mjcf_name(element, "geom").value;
    const auto type = targets_.geom_types.find(name);
    if (type == targets_.geom_types.end()) return;
    if (type->second == "sphere" || type->second == "cylinder") return;
    reject(element, "geom",
           "a tendon wraps around spheres and cylinders, and geom '" + name + "' is a " +
               type->second);
  }

  /// Of a tendon, as of a joint.
  void check_limits(xml::Element tendon) {
    const std::size_t id = mjcf_class_of(scope_, tendon, MjcfDefaults::kMain);
    check_mjcf_range(scope_.defaults.values(tendon, "tendon", id), scope_.settings, "range",
                     "limited", facts_);
    check_mjcf_range(scope_.defaults.values(tendon, "tendon", id), scope_.settings,
                     "actuatorfrcrange", "actuatorfrclimited", facts_);
  }

  /// `inheritrange` takes the range of what the actuator drives.
  void check_range(xml::Element element) {
    const std::string_view tag = element.name();
    if (tag != "position" && tag != "intvelocity") return;
    const MjcfValues values = scope_.defaults.values_of_any(
        element, {tag, "general"}, mjcf_class_of(scope_, element, MjcfDefaults::kMain));
    if (!(values.number("inheritrange", 0).value > 0)) return;
    if (element.attribute("site") || element.attribute("body") || element.attribute("cranksite")) {
      return reject(element, "inheritrange", "inheritrange is of a joint or tendon");
    }
    const auto* joint = joint_of(element, "joint");
    const std::string name = mjcf_name(element, "tendon").value;
    const auto tendon = targets_.tendons.find(name);
    const bool of_tendon = !name.empty() && tendon != targets_.tendons.end();
    const bool has_range =
        (joint == nullptr || joint->limit.range) && (!of_tendon || tendon->second.range);
    const char* const limited = tag == "position" ? "ctrllimited" : "actlimited";
    if (has_range && !scope_.settings.auto_limits && !values.text(limited)) {
      facts_.push_back({.kind = MjcfKind::kRangeUnlimited,
                        .where = values.text("inheritrange")->span,
                        .name = "inheritrange",
                        .detail = limited});
    }
    if (has_range) return;
    reject(element, "inheritrange", "inheritrange is used, and its target has no range");
  }

  const MjcfScope& scope_;
  MjcfFacts& facts_;
  MjcfTargets targets_;
};

}  // namespace

void check_mjcf_targets(const MjcfScope& scope, MjcfFacts& facts) {
  MjcfTargetCheck check(scope, facts);
  for_each_mjcf_element(scope.tree, [&](std::string_view section, xml::Element element) {
    check.check(section, element);
  });
}

}  // namespace rigor::read
