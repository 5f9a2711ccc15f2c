// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/inertial_block.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/core.h>

#include <rigor/author/verbs/block.h>
#include <rigor/schema/value.h>
#include <rigor/write/numbers.h>
#include <rigor/xml/edit.h>

namespace rigor::author {
namespace {

/// Of what is taken from a number so many times as large, digits are left that rounding has not made: write::settled
/// keeps fewer than a proof compares behind more.
constexpr double kMaxCancellation = 100;

double size_of_sum(double result, double term) {
  return std::min(std::max(result, term), kMaxCancellation * result);
}

/// Without what rounding leaves of sums, where the tensor is that of a body then, too. Products and moments are sums of
/// numbers of the size of `size`, kg·m².
mass::Inertia settled_tensor(const mass::Inertia& I, double size) {
  const auto number = [size](double value) { return write::settled(value, 0, size); };
  const mass::Inertia candidate{number(I.ixx), number(I.ixy), number(I.ixz),
                                number(I.iyy), number(I.iyz), number(I.izz)};
  const auto margin = [](const mass::Inertia& tensor) {
    const auto [small, middle, large] = mass::principal_moments(tensor);
    return small + middle - large;
  };
  return margin(candidate) >= std::min(margin(I), 0.0) ? candidate : I;
}

double largest(const mass::Inertia& I) {
  return std::max({std::abs(I.ixx), std::abs(I.iyy), std::abs(I.izz)});
}

model::Vector3 settled_point(const model::Vector3& p, double size) {
  return {write::settled(p.x, 0, size), write::settled(p.y, 0, size), write::settled(p.z, 0, size)};
}

/// Where mass and tensor have elements, and nothing but those tells what they are.
bool can_be_set(const model::Inertial& inertial) {
  return inertial.mass.written && inertial.tensor_written && !inertial.automatic.value &&
         !inertial.pose.malformed;
}

}  // namespace

void set_inertial(Draft& draft, const EditedModel& edited, const model::Link& link,
                  const mass::MassProperties& body) {
  const xml::Element element = edited.element(link.site);
  const model::Inertial& inertial = link.inertial;
  const bool urdf = edited.is_urdf();
  const auto whole = [&] {
    return inertial_block(body, urdf ? InertialForm::kUrdf : InertialForm::kSdf);
  };
  const auto old = element.child("inertial");
  if (!old) return draft.insert(element, element.child("pose"), whole());
  if (!can_be_set(inertial))
    return draft.add(xml::replace_element(edited.document(), *old, whole()));
  draft.set_pose(inertial.pose, *old, {body.com, {}});
  draft.set(inertial.mass, write::settled(body.mass, inertial.mass.value,
                                          size_of_sum(body.mass, inertial.mass.value)));
  const mass::Inertia old_tensor{inertial.ixx.value, inertial.ixy.value, inertial.ixz.value,
                                 inertial.iyy.value, inertial.iyz.value, inertial.izz.value};
  const mass::Inertia I =
      settled_tensor(body.about_com, size_of_sum(largest(body.about_com), largest(old_tensor)));
  const xml::Element tensor = edited.element(inertial.tensor_site);
  const std::tuple<const char*, const model::Field<double>*, double> entries[] = {
      {"ixx", &inertial.ixx, I.ixx}, {"ixy", &inertial.ixy, I.ixy}, {"ixz", &inertial.ixz, I.ixz},
      {"iyy", &inertial.iyy, I.iyy}, {"iyz", &inertial.iyz, I.iyz}, {"izz", &inertial.izz, I.izz}};
  const double size = largest(I);
  std::string missing;
  for (const auto& [name, field, value] : entries) {
    if (field->written) {
      draft.set(*field, value);
      continue;
    }
    const double settled = size > 0 ? write::settled(value, field->value, size) : value;
    if (settled == field->value) continue;
    if (urdf) {
      draft.set_attribute(tensor, name, schema::to_shortest(settled));
    } else {
      missing += (missing.empty() ? "" : "\n") +
                 fmt::format("<{0}>{1}</{0}>", name, schema::to_shortest(settled));
    }
  }
  if (!missing.empty()) draft.insert(tensor, last_child_of(tensor), missing);
}

std::string inertial_block(const mass::MassProperties& body, InertialForm form,
                           const model::Pose& X_LB) {
  const auto text = [](double value) { return schema::to_shortest(value + 0.0); };
  const model::Vector3 com = settled_point(transform(X_LB, body.com),
                                           std::max(length(X_LB.translation), length(body.com)));
  const std::string xyz = fmt::format("{} {} {}", text(com.x), text(com.y), text(com.z));
  const std::string rpy = rpy_text(X_LB);
  const mass::Inertia I = settled_tensor(body.about_com, largest(body.about_com));
  const double mass = write::settled(body.mass, 0, body.mass);
  const std::pair<const char*, double> entries[] = {{"ixx", I.ixx}, {"ixy", I.ixy}, {"ixz", I.ixz},
                                                    {"iyy", I.iyy}, {"iyz", I.iyz}, {"izz", I.izz}};
  std::string tensor;
  if (form == InertialForm::kUrdf) {
    for (const auto& [name, value] : entries)
      tensor += fmt::format(" {}=\"{}\"", name, text(value));
    const std::string turn = rpy == "0 0 0" ? "" : fmt::format(" rpy=\"{}\"", rpy);
    return fmt::format(
        "<inertial>\n  <origin xyz=\"{}\"{}/>\n  <mass value=\"{}\"/>\n  "
        "<inertia{}/>\n</inertial>",
        xyz, turn, text(mass), tensor);
  }
  for (const auto& [name, value] : entries)
    tensor += fmt::format("    <{0}>{1}</{0}>\n", name, text(value));
  return fmt::format(
      "<inertial>\n  <pose>{} {}</pose>\n  <mass>{}</mass>\n  <inertia>\n{}  "
      "</inertia>\n</inertial>",
      xyz, rpy, text(mass), tensor);
}

std::string indented_by(const std::string& text, const std::string& by, const std::string& line) {
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
