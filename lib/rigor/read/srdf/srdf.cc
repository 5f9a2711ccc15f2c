// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/srdf/srdf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <variant>

#include <rigor/schema/value.h>

namespace rigor::read {
namespace {

/// What an attribute names, by its element and the element around that.
struct SrdfNaming {
  std::string_view parent, element, attribute;
  SrdfNameKind kind;
};

constexpr std::array kSrdfNamings{
    SrdfNaming{"group", "chain", "base_link", SrdfNameKind::kLink},
    SrdfNaming{"group", "chain", "tip_link", SrdfNameKind::kLink},
    SrdfNaming{"group", "link", "name", SrdfNameKind::kLink},
    SrdfNaming{"group", "joint", "name", SrdfNameKind::kJoint},
    SrdfNaming{"group", "group", "name", SrdfNameKind::kGroup},
    SrdfNaming{"robot", "group_state", "group", SrdfNameKind::kGroup},
    SrdfNaming{"group_state", "joint", "name", SrdfNameKind::kJoint},
    SrdfNaming{"robot", "end_effector", "parent_link", SrdfNameKind::kLink},
    SrdfNaming{"robot", "end_effector", "group", SrdfNameKind::kGroup},
    SrdfNaming{"robot", "end_effector", "parent_group", SrdfNameKind::kGroup},
    SrdfNaming{"robot", "virtual_joint", "child_link", SrdfNameKind::kLink},
    SrdfNaming{"robot", "passive_joint", "name", SrdfNameKind::kJoint},
    SrdfNaming{"robot", "joint_property", "joint_name", SrdfNameKind::kJoint},
    SrdfNaming{"robot", "disable_collisions", "link1", SrdfNameKind::kLink},
    SrdfNaming{"robot", "disable_collisions", "link2", SrdfNameKind::kLink},
    SrdfNaming{"robot", "enable_collisions", "link1", SrdfNameKind::kLink},
    SrdfNaming{"robot", "enable_collisions", "link2", SrdfNameKind::kLink},
    SrdfNaming{"robot", "disable_default_collisions", "link", SrdfNameKind::kLink},
    SrdfNaming{"robot", "link_sphere_approximation", "link", SrdfNameKind::kLink},
};

SrdfName srdf_name(xml::Element element, std::string_view attribute) {
  const auto found = element.attribute(attribute);
  return found ? SrdfName{std::string(found->value()), found->value_span()} : SrdfName{};
}

std::optional<double> single_position(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(kBlank);
  if (begin == std::string_view::npos) return std::nullopt;
  text = text.substr(begin, text.find_last_not_of(kBlank) + 1 - begin);
  const auto parsed = schema::parse_double(text);
  const double* number = std::get_if<double>(&parsed);
  if (number == nullptr || !std::isfinite(*number)) return std::nullopt;
  return *number;
}

void read_srdf_element(xml::Element element, std::string_view parent, Srdf& srdf) {
  const std::string_view kind = element.name();
  for (const xml::Attribute attribute : element.attributes()) {
    const auto naming =
        std::find_if(kSrdfNamings.begin(), kSrdfNamings.end(), [&](const SrdfNaming& each) {
          return each.parent == parent && each.element == kind &&
                 each.attribute == attribute.name();
        });
    if (naming == kSrdfNamings.end()) continue;
    srdf.references.push_back(
        {naming->kind, {std::string(attribute.value()), attribute.value_span()}});
  }
  if (parent == "robot" && kind == "group") srdf.groups.insert(srdf_name(element, "name").text);
  if (kind == "virtual_joint") srdf.virtual_joints.insert(srdf_name(element, "name").text);
  if (parent == "group" && kind == "chain")
    srdf.chains.push_back({srdf_name(element, "base_link"), srdf_name(element, "tip_link")});
  if (parent == "group_state" && kind == "joint") {
    const SrdfName value = srdf_name(element, "value");
    if (const auto position = single_position(value.text))
      srdf.positions.push_back({srdf_name(element, "name"), *position, value.where,
                                srdf_name(*element.parent(), "name").text});
  }
  if (kind == "disable_collisions") {
    std::string a = srdf_name(element, "link1").text, b = srdf_name(element, "link2").text;
    if (b < a) std::swap(a, b);
    srdf.disabled.emplace(std::move(a), std::move(b));
  }
  if (kind == "disable_default_collisions")
    srdf.disabled_by_default.insert(srdf_name(element, "link").text);
}

}  // namespace

Srdf read_srdf(xml::Element root) {
  Srdf srdf{.robot = srdf_name(root, "name")};
  for (const xml::Element child : root.children()) {
    read_srdf_element(child, "robot", srdf);
    for (const xml::Element inner : child.children()) {
      read_srdf_element(inner, child.name(), srdf);
    }
  }
  return srdf;
}

}  // namespace rigor::read
