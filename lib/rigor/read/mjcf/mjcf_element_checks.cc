// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What an element outside the bodies needs and the schema cannot say: one of several attributes, a path that leads
// somewhere, a range. Each is what MuJoCo 3.14 rejects.

#include <algorithm>
#include <array>
#include <string>

#include <rigor/read/mjcf/mjcf_checks.h>

namespace rigor::read {
namespace {

using MjcfKind = MjcfFactKind;
using Attributes = std::array<std::string_view, 2>;

/// An element needs all of the attributes of one way or of the other.
struct MjcfNeed {
  std::string_view section, tag;
  Attributes first, second;
};

constexpr std::array kMjcfNeeds{
    MjcfNeed{"sensor", "rangefinder", {"site"}, {"camera"}},
    MjcfNeed{"sensor", "distance", {"geom1"}, {"body1"}},
    MjcfNeed{"sensor", "distance", {"geom2"}, {"body2"}},
    MjcfNeed{"sensor", "normal", {"geom1"}, {"body1"}},
    MjcfNeed{"sensor", "normal", {"geom2"}, {"body2"}},
    MjcfNeed{"sensor", "fromto", {"geom1"}, {"body1"}},
    MjcfNeed{"sensor", "fromto", {"geom2"}, {"body2"}},
    MjcfNeed{"sensor", "plugin", {"plugin"}, {"instance"}},
    MjcfNeed{"equality", "connect", {"site1", "site2"}, {"body1", "anchor"}},
    MjcfNeed{"equality", "weld", {"site1", "site2"}, {"body1"}},
    MjcfNeed{"custom", "numeric", {"data"}, {"size"}},
    MjcfNeed{"asset", "hfield", {"name"}, {"file"}},
};

bool has_all(xml::Element element, const Attributes& attributes) {
  return std::all_of(attributes.begin(), attributes.end(), [&](std::string_view name) {
    return name.empty() || element.attribute(name);
  });
}

std::string in_words(const Attributes& attributes) {
  const auto& [first, second] = attributes;
  return std::string(first) + (second.empty() ? "" : " and " + std::string(second));
}

void check_needs(std::string_view section, xml::Element element, MjcfFacts& facts) {
  for (const MjcfNeed& need : kMjcfNeeds) {
    if (need.section != section || need.tag != element.name()) continue;
    if (has_all(element, need.first) || has_all(element, need.second)) continue;
    facts.push_back({.kind = MjcfKind::kAttributeMissing,
                     .where = element.tag_span(),
                     .name = std::string(element.name()),
                     .detail = in_words(need.first) + " or " + in_words(need.second)});
  }
}

/// A texture is named after its file, and is made where there is none. A sky needs no name.
void check_texture(xml::Element texture, MjcfFacts& facts) {
  for (const xml::Attribute attribute : texture.attributes()) {
    if (attribute.name().starts_with("file")) return;
  }
  const MjcfValues values(texture, {});
  const std::string type = values.string("type", "cube").value;
  const auto lacks = [&](const char* what) {
    facts.push_back({.kind = MjcfKind::kAttributeMissing,
                     .where = texture.tag_span(),
                     .name = "texture",
                     .detail = what});
  };
  if (values.string("builtin", "none").value == "none") return lacks("file or builtin");
  if (type != "skybox" && !texture.attribute("name")) lacks("name");
  if (!texture.attribute("width")) return lacks("width");
  if (type == "2d" && !texture.attribute("height")) lacks("height");
}

void check_hfield(xml::Element hfield, MjcfFacts& facts) {
  const MjcfValues values(hfield, {});
  const std::vector<double> size = values.numbers("size");
  const bool positive = std::all_of(size.begin(), size.end(), [](double s) { return s > 0; });
  if (positive) return;
  facts.push_back({.kind = MjcfKind::kSizeMissing,
                   .where = values.text("size")->span,
                   .name = "hfield",
                   .detail = "4 positive sizes"});
}

/// Why a spatial tendon cannot be; empty when it can. The path is of sites, geoms and pulleys.
std::string path_fault(const std::vector<xml::Element>& path) {
  const auto is = [&](std::size_t i, std::string_view tag) {
    return i < path.size() && path[i].name() == tag;
  };
  const auto name_at = [&](std::size_t i) { return mjcf_name(path[i], path[i].name()).value; };
  if (path.empty()) return "its path is empty";
  if (path.size() < 2) return "its path has one object, and needs two";
  if (is(path.size() - 1, "pulley")) return "its path ends with a pulley";
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool after_site = i > 0 && is(i - 1, "site");
    if (is(i, "geom") && (!after_site || !is(i + 1, "site"))) {
      return "geom '" + name_at(i) + "' is not between two sites";
    }
    if (!is(i, "site")) continue;
    if (after_site && name_at(i) == name_at(i - 1)) {
      return "site '" + name_at(i) + "' is repeated";
    }
    const bool alone = (i == 0 || is(i - 1, "pulley")) && is(i + 1, "pulley");
    if (alone) return "site '" + name_at(i) + "' is alone between pulleys";
  }
  return {};
}

void check_tendon(const MjcfTree& tree, xml::Element tendon, MjcfFacts& facts) {
  const bool spatial = tendon.name() == "spatial";
  if (!spatial && tendon.name() != "fixed") return;
  std::vector<xml::Element> path;
  for (const xml::Element part : tree.children(tendon)) {
    const std::string_view tag = part.name();
    if (tag == "site" || tag == "geom" || tag == "pulley" || tag == "joint") path.push_back(part);
  }
  const std::string why = spatial        ? path_fault(path)
                          : path.empty() ? "it combines no joints"
                                         : std::string();
  if (why.empty()) return;
  facts.push_back({.kind = MjcfKind::kTendonPath,
                   .where = tendon.tag_span(),
                   .name = mjcf_name(tendon, "name").value,
                   .detail = why});
}

/// Adhesion and dampers have a control range, and no control below 0.
void check_control_range(const MjcfScope& scope, xml::Element actuator, MjcfFacts& facts) {
  const std::string_view tag = actuator.name();
  if (tag != "adhesion" && tag != "damper") return;
  const MjcfValues values = scope.defaults.values_of_any(
      actuator, {tag, "general"}, mjcf_class_of(scope, actuator, MjcfDefaults::kMain));
  const auto text = values.text("ctrlrange");
  const std::vector<double> range = values.numbers("ctrlrange");
  if (range.size() == 2 && range[0] >= 0 && range[0] < range[1]) return;
  facts.push_back({.kind = MjcfKind::kControlRange,
                   .where = text ? text->span : actuator.tag_span(),
                   .name = std::string(tag)});
}

}  // namespace

void check_mjcf_elements(const MjcfScope& scope, MjcfFacts& facts) {
  for_each_mjcf_element(scope.tree, [&](std::string_view section, xml::Element element) {
    check_needs(section, element, facts);
    if (section == "asset" && element.name() == "texture") check_texture(element, facts);
    if (section == "asset" && element.name() == "hfield") check_hfield(element, facts);
    if (section == "tendon") check_tendon(scope.tree, element, facts);
    if (section == "actuator") check_control_range(scope, element, facts);
  });
}

}  // namespace rigor::read
