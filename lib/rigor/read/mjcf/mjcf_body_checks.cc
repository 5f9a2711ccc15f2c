// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <rigor/read/mjcf/mjcf_checks.h>

namespace rigor::read {
namespace {

using MjcfKind = MjcfFactKind;

/// MuJoCo's smallest mass and moment of what moves: mjMINVAL.
constexpr double kSmallest = 1e-15;

std::string subject_of_mjcf(xml::Element element) {
  const std::string name = mjcf_name(element, "name").value;
  return name.empty() ? std::string() : std::string(element.name()) + ' ' + name;
}

/// Whether x and y axis have a length, and y one across x.
bool span_a_plane(const std::vector<double>& n) {
  const model::Vector3 x{n[0], n[1], n[2]}, y{n[3], n[4], n[5]};
  constexpr double kParallel = 1e-14;  // of their lengths: rounding
  const double across = length(cross(x, y));
  return length(x) > 0 && length(y) > 0 && across > kParallel * length(x) * length(y);
}

void check_orientation(xml::Element element, MjcfFacts& facts) {
  std::size_t ways = 0;
  Span second;
  for (const char* way : {"quat", "axisangle", "xyaxes", "zaxis", "euler"}) {
    const auto attribute = element.attribute(way);
    if (!attribute) continue;
    if (++ways == 2) second = attribute->span();
    const auto numbers = mjcf_numbers(attribute->value());
    if (!numbers || numbers->size() < 3) continue;
    if (std::string_view(way) == "xyaxes") {
      if (numbers->size() == 6 && !span_a_plane(*numbers)) {
        facts.push_back(
            {MjcfKind::kOrientationZero, attribute->value_span(), subject_of_mjcf(element), way});
      }
      continue;
    }
    const std::size_t count = std::string_view(way) == "quat" ? 4 : 3;
    const bool has_length = std::string_view(way) != "euler";
    double size = 0;
    for (std::size_t i = 0; i < count && i < numbers->size(); ++i) {
      size = std::max(size, std::abs((*numbers)[i]));
    }
    if (has_length && size == 0) {
      facts.push_back(
          {MjcfKind::kOrientationZero, attribute->value_span(), subject_of_mjcf(element), way});
    }
  }
  if (ways > 1) facts.push_back({MjcfKind::kOrientationTwice, second, subject_of_mjcf(element)});
}

void check_light(const MjcfValues& values, MjcfFacts& facts) {
  const auto direction = values.vector("dir", {0, 0, -1});
  if (!direction.written || length(direction.value) > 0) return;
  facts.push_back(
      {MjcfKind::kOrientationZero, direction.span, subject_of_mjcf(values.element()), "dir"});
}

void check_joint(const MjcfScope& scope, const MjcfValues& values, MjcfFacts& facts) {
  const std::string type = values.string("type", "hinge").value;
  if (type == "ball") {
    // One that is limited without a range is taken.
    if (values.text("range")) check_mjcf_range(values, scope.settings, "range", "limited", facts);
    const auto range = values.numbers("range");
    if (range.size() == 2 && range[0] != 0 && range[0] < range[1]) {
      facts.push_back({.kind = MjcfKind::kValueRejected,
                       .where = values.text("range")->span,
                       .subject = subject_of_mjcf(values.element()),
                       .name = "range",
                       .detail = "of a ball has 0 for its first number"});
    }
  }
  if (type != "hinge" && type != "slide") return;
  const auto axis = values.vector("axis", {0, 0, 1});
  if (axis.written && length(axis.value) < 1e-10) {
    facts.push_back({MjcfKind::kAxisZero, axis.span, subject_of_mjcf(values.element())});
  }
  check_mjcf_range(values, scope.settings, "range", "limited", facts);
  check_mjcf_range(values, scope.settings, "actuatorfrcrange", "actuatorfrclimited", facts);
}

/// How many sizes a shape needs, and how many with `fromto`.
std::array<std::size_t, 2> sizes_of(std::string_view type) {
  if (type == "sphere") return {1, 1};
  if (type == "capsule" || type == "cylinder") return {2, 1};
  if (type == "box" || type == "ellipsoid") return {3, 1};
  return {0, 0};
}

std::string positive_sizes(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " positive size" : " positive sizes");
}

void check_geom(const MjcfValues& values, MjcfFacts& facts) {
  const std::string type(trimmed(values.string("type", "sphere").value));
  const xml::Element element = values.element();
  const bool of_mesh = type == "mesh" || type == "sdf";
  if (of_mesh && values.own("shellinertia") && values.is_true("shellinertia")) {
    facts.push_back({.kind = MjcfKind::kShapeRejected,
                     .where = values.text("shellinertia")->span,
                     .subject = subject_of_mjcf(element),
                     .detail = "shellinertia of a mesh, where the asset has inertia=\"shell\""});
  }
  if ((of_mesh && values.string("mesh").value.empty()) ||
      (type == "hfield" && values.string("hfield").value.empty())) {
    facts.push_back(
        {MjcfKind::kMeshMissingName, element.tag_span(), subject_of_mjcf(element), type});
    return;
  }
  if (values.text("mesh")) return;
  const std::vector<double> size = values.numbers("size");
  const auto text = values.text("size");
  MjcfFact fact{MjcfKind::kSizeMissing, text ? text->span : element.tag_span(),
                subject_of_mjcf(element), "geom of type " + type};
  if (type == "plane" && (size.size() < 3 || size[2] <= 0)) {
    fact.detail = "a positive third size, the spacing of its grid";
    facts.push_back(std::move(fact));
    return;
  }
  const std::size_t needed = sizes_of(type)[values.text("fromto") ? 1 : 0];
  const std::size_t positive = static_cast<std::size_t>(
      std::find_if(size.begin(), size.end(), [](double s) { return !(s > 0); }) - size.begin());
  if (positive >= needed) return;
  fact.detail = positive_sizes(needed);
  facts.push_back(std::move(fact));
}

/// Why a geom or site cannot have its type; empty when it can.
std::string why_not_possible(const MjcfValues& values, const std::string& type) {
  const bool is_site = values.element().name() == "site";
  if (is_site && (type == "plane" || type == "hfield")) return "a site of type " + type;
  const std::vector<double> ends = values.numbers("fromto");
  if (ends.size() != 6) return {};
  if (sizes_of(type)[0] < 2) return "fromto and the type " + type;
  const model::Vector3 pos = values.vector("pos", {}).value;
  if (length(pos) > 0) return "pos beside fromto, which places it";
  const bool apart = ends[0] != ends[3] || ends[1] != ends[4] || ends[2] != ends[5];
  return apart ? "" : "the ends of fromto in one place";
}

void check_shape(const MjcfValues& values, MjcfFacts& facts) {
  const std::string type(trimmed(values.string("type", "sphere").value));
  const std::string why = why_not_possible(values, type);
  if (why.empty()) return;
  facts.push_back({MjcfKind::kShapeRejected,
                   values.element().tag_span(),
                   subject_of_mjcf(values.element()),
                   {},
                   why});
}

/// A site has 0.005 for each size that is not written.
void check_site(const MjcfValues& values, MjcfFacts& facts) {
  const std::string type(trimmed(values.string("type", "sphere").value));
  if (type == "mesh" && values.string("mesh").value.empty()) {
    facts.push_back({MjcfKind::kMeshMissingName, values.element().tag_span(),
                     subject_of_mjcf(values.element()), type});
  }
  const std::size_t needed = sizes_of(type)[values.text("fromto") ? 1 : 0];
  const std::vector<double> size = values.numbers("size");
  for (std::size_t i = 0; i < std::min(needed, size.size()); ++i) {
    if (size[i] > 0) continue;
    facts.push_back({MjcfKind::kSizeMissing, values.text("size")->span,
                     subject_of_mjcf(values.element()), "site of type " + type,
                     positive_sizes(needed)});
    return;
  }
}

/// MuJoCo's tests: positive definite, and two moments together no less than the third.
std::string why_rejected(const std::vector<double>& d, const MjcfSettings& settings) {
  if (d.size() == 3) {
    if (d[0] < 0 || d[1] < 0 || d[2] < 0) return "a moment is negative";
    const bool triangle = d[0] + d[1] >= d[2] && d[0] + d[2] >= d[1] && d[1] + d[2] >= d[0];
    if (!triangle && !settings.masses.balance_inertia) {
      return "two moments together are less than the third";
    }
    return {};
  }
  if (d.size() != 6) return {};
  const double minor = d[0] * d[1] - d[3] * d[3];
  const double determinant = d[0] * (d[1] * d[2] - d[5] * d[5]) -
                             d[3] * (d[3] * d[2] - d[5] * d[4]) +
                             d[4] * (d[3] * d[5] - d[1] * d[4]);
  if (d[0] <= 0 || minor <= 0 || determinant <= 0) return "the tensor is not positive definite";
  const bool triangle = d[0] + d[1] >= d[2] && d[0] + d[2] >= d[1] && d[1] + d[2] >= d[0];
  if (!triangle && !settings.masses.balance_inertia) {
    return "two moments together are less than the third";
  }
  return {};
}

void check_inertial(const MjcfScope& scope, xml::Element element, MjcfFacts& facts) {
  const MjcfValues values(element, {});
  const std::vector<double> full = values.numbers("fullinertia");
  const std::vector<double> diagonal = values.numbers("diaginertia");
  const bool both = !full.empty() && !diagonal.empty();
  const bool rotated = element.attribute("quat") || element.attribute("euler") ||
                       element.attribute("axisangle") || element.attribute("xyaxes") ||
                       element.attribute("zaxis");
  if (both || (!full.empty() && rotated)) {
    facts.push_back({MjcfKind::kInertialIncomplete,
                     element.tag_span(),
                     {},
                     {},
                     both ? "fullinertia and diaginertia are both written"
                          : "fullinertia and an orientation are both written"});
    return;
  }
  const std::vector<double>& given = full.empty() ? diagonal : full;
  const std::string why = why_rejected(given, scope.settings);
  if (!why.empty()) {
    const char* name = full.empty() ? "diaginertia" : "fullinertia";
    facts.push_back({MjcfKind::kInertiaRejected, values.text(name)->span, {}, name, why});
  }
  const auto mass = values.number("mass", 0);
  if (mass.written && mass.value < 0) {
    facts.push_back({MjcfKind::kInertiaRejected, mass.span, {}, "mass", "the mass is negative"});
  }
}

struct Degrees {
  std::size_t of_body = 0, joints = 0;
  bool free = false;
  Span free_at;
};

Degrees degrees_of_freedom(const MjcfScope& scope, xml::Element body, std::size_t class_id) {
  Degrees found;
  for (const xml::Element child : scope.tree.children(body)) {
    const std::string_view tag = child.name();
    if (tag != "joint" && tag != "freejoint") continue;
    const MjcfValues values =
        scope.defaults.values(child, "joint", mjcf_class_of(scope, child, class_id));
    const auto field = values.string("type", "hinge");
    const std::string_view type = trimmed(field.value);
    const bool is_free = tag == "freejoint" || type == "free";
    ++found.joints;
    found.of_body += is_free ? 6 : type == "ball" ? 3 : 1;
    if (is_free) {
      found.free = true;
      found.free_at = child.tag_span();
    }
  }
  return found;
}

/// Where the geoms give the body its mass, none may be negative.
void check_weights(const MjcfScope& scope, xml::Element body, std::size_t class_id,
                   MjcfFacts& facts) {
  using From = MjcfSettings::InertiaFromGeom;
  if (scope.settings.inertia_from_geom == From::kFalse) return;
  const std::vector<xml::Element> parts = scope.tree.children(body);
  const bool given = std::any_of(parts.begin(), parts.end(),
                                 [](xml::Element part) { return part.name() == "inertial"; });
  if (given && scope.settings.inertia_from_geom == From::kAuto) return;
  for (const xml::Element part : parts) {
    if (part.name() != "geom") continue;
    const MjcfValues values =
        scope.defaults.values(part, "geom", mjcf_class_of(scope, part, class_id));
    for (const char* name : {"mass", "density"}) {
      const auto weight = values.number(name, 0);
      if (weight.value >= 0) continue;
      facts.push_back({MjcfKind::kInertiaRejected, weight.span, subject_of_mjcf(part), name,
                       std::string("the ") + name + " is negative"});
    }
  }
}

/// Whether anything may give the body mass: an inertial, or a geom that weighs.
bool may_weigh(const MjcfScope& scope, xml::Element body, std::size_t class_id) {
  using From = MjcfSettings::InertiaFromGeom;
  for (const xml::Element child : scope.tree.children(body)) {
    const std::string_view tag = child.name();
    if (tag == "frame" || tag == "replicate" || tag == "attach" || tag == "composite" ||
        tag == "flexcomp" || tag == "plugin") {
      return true;
    }
    if (tag == "inertial" && scope.settings.inertia_from_geom != From::kTrue) {
      const MjcfValues values(child, {});
      const std::vector<double> moments = values.numbers("diaginertia");
      const bool turns =
          !values.numbers("fullinertia").empty() ||
          (moments.size() == 3 && *std::min_element(moments.begin(), moments.end()) >= kSmallest);
      return values.number("mass", 0).value >= kSmallest && turns;
    }
  }
  if (scope.settings.inertia_from_geom == From::kFalse) return false;
  for (const xml::Element child : scope.tree.children(body)) {
    if (child.name() != "geom") continue;
    const MjcfValues values =
        scope.defaults.values(child, "geom", mjcf_class_of(scope, child, class_id));
    const std::string type = values.string("type", "sphere").value;
    if (type == "plane" || type == "hfield") continue;
    const double group = values.number("group", 0).value;
    const auto& [first, last] = scope.settings.inertia_groups;
    if (group < first || group > last) continue;
    const auto mass = values.number("mass", 0);
    if (mass.written ? mass.value > 0 : values.number("density", 1000).value > 0) return true;
  }
  return false;
}

bool has_child_with_mass(const MjcfScope& scope, xml::Element body, std::size_t class_id) {
  for (const xml::Element child : scope.tree.children(body)) {
    const std::string_view tag = child.name();
    if (tag == "frame" || tag == "replicate" || tag == "attach") return true;
    if (tag != "body") continue;
    std::size_t inside = class_id;
    const auto childclass = mjcf_name(child, "childclass");
    if (childclass.written) inside = scope.defaults.find(childclass.value).value_or(class_id);
    if (degrees_of_freedom(scope, child, inside).joints > 0) continue;  // it moves by itself
    if (may_weigh(scope, child, inside) || has_child_with_mass(scope, child, inside)) return true;
  }
  return false;
}

void check_body(const MjcfScope& scope, xml::Element body, std::size_t class_id, MjcfFacts& facts) {
  std::size_t inside = class_id;
  const auto childclass = mjcf_name(body, "childclass");
  if (childclass.written) inside = scope.defaults.find(childclass.value).value_or(class_id);
  check_weights(scope, body, inside, facts);
  const Degrees found = degrees_of_freedom(scope, body, inside);
  auto above = body.parent();
  while (above && (above->name() == "frame" || above->name() == "replicate"))
    above = above->parent();
  const bool nested = above && above->name() == "body";
  const std::string subject = subject_of_mjcf(body);
  if (found.free && nested) facts.push_back({MjcfKind::kFreeJointNested, found.free_at, subject});
  if (found.free && found.joints > 1)
    facts.push_back({MjcfKind::kFreeJointNotAlone, found.free_at, subject});
  if (!found.free && found.of_body > 6) {
    facts.push_back(
        {MjcfKind::kTooManyJoints, body.tag_span(), subject, {}, std::to_string(found.of_body)});
  }
  const auto mocap = attribute_text(body, "mocap");
  if (mocap && trimmed(mocap->text) == "true" && (nested || found.joints > 0)) {
    facts.push_back({MjcfKind::kMocapNotStatic,
                     mocap->span,
                     subject,
                     {},
                     nested ? "it is not a child of the world" : "it has a joint"});
  }
  const bool bounded =
      scope.settings.masses.bound_mass > 0 && scope.settings.masses.bound_inertia > 0;
  if (found.joints > 0 && !bounded && !may_weigh(scope, body, inside) &&
      !has_child_with_mass(scope, body, inside)) {
    facts.push_back({MjcfKind::kMassMissing, body.tag_span(), subject});
  }
}

}  // namespace

void check_mjcf_range(const MjcfValues& values, const MjcfSettings& settings,
                      std::string_view range, std::string_view limited, MjcfFacts& facts) {
  const auto text = values.text(range);
  const std::vector<double> n = values.numbers(range);
  const auto mode = values.text(limited);
  const std::string_view value = mode ? trimmed(mode->text) : "auto";
  const std::string subject = subject_of_mjcf(values.element());
  const bool zero = n.size() == 2 && n[0] == 0 && n[1] == 0;  // MuJoCo's word for none
  const bool on = value == "true" || (value == "auto" && settings.auto_limits && text && !zero);
  if (value == "true" && !text) {
    facts.push_back({MjcfKind::kLimitedWithoutRange, mode->span, subject, std::string(range)});
  }
  if (!text || n.size() != 2) return;
  const bool of_axis = values.element().name() == "joint" && values.string("type").value != "ball";
  if (on && n[0] >= n[1] && (of_axis || value == "true")) {
    facts.push_back({MjcfKind::kRangeInverted, text->span, subject, std::string(range),
                     std::string(trimmed(values.text(range)->text))});
  } else if (on && n[0] >= n[1]) {
    facts.push_back({MjcfKind::kRangeIgnored, text->span, subject, std::string(range),
                     "its first number is not below the second"});
  } else if (!on && !zero && value != "false") {
    facts.push_back(
        {MjcfKind::kRangeUnlimited, text->span, subject, std::string(range), std::string(limited)});
  } else if (!on && values.own(range) && !zero) {
    facts.push_back({MjcfKind::kRangeIgnored, text->span, subject, std::string(range),
                     std::string(limited) + "=\"false\""});
  }
}

void check_mjcf_bodies(const MjcfScope& scope, MjcfFacts& facts) {
  if (!scope.settings.global_coordinates.nowhere()) {
    facts.push_back({MjcfKind::kGlobalCoordinates, scope.settings.global_coordinates});
  }
  for_each_in_bodies(scope, [&](xml::Element element, std::size_t class_id) {
    const std::string_view tag = element.name();
    const auto values = [&] { return scope.defaults.values(element, tag, class_id); };
    if (tag == "joint") check_joint(scope, values(), facts);
    if (tag == "geom" || tag == "site") check_shape(values(), facts);
    if (tag == "geom") check_geom(values(), facts);
    if (tag == "site") check_site(values(), facts);
    if (tag == "inertial") check_inertial(scope, element, facts);
    if (tag == "body") check_body(scope, element, class_id, facts);
    if (tag == "body" || tag == "geom" || tag == "site" || tag == "camera" || tag == "frame") {
      check_orientation(element, facts);
    }
    if (tag == "light") check_light(values(), facts);
    if (tag == "replicate") {
      const auto count = MjcfValues(element, {}).number("count", 0);
      if (count.written && count.value < 1) {
        facts.push_back({MjcfKind::kReplicateCount, count.span});
      }
    }
  });
}

}  // namespace rigor::read
