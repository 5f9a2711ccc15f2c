// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Values that MuJoCo 3.14 rejects and the schema does not bound: limits that a class may give, texts, and attributes
// that exclude each other.

#include <algorithm>
#include <array>
#include <string>

#include <rigor/read/mjcf/mjcf_checks.h>

namespace rigor::read {
namespace {

using MjcfKind = MjcfFactKind;

/// `least` itself is taken where `taken` says so.
struct MjcfBound {
  enum class Least : std::uint8_t { kTaken, kAbove };
  std::string_view section, tag, attribute;
  double bound;
  Least least;
  std::string_view words;
};

/// An empty tag is any.
constexpr std::array kMjcfBounds{
    MjcfBound{"sensor", "", "cutoff", 0, MjcfBound::Least::kTaken, "is negative"},
    MjcfBound{"sensor", "", "noise", 0, MjcfBound::Least::kTaken, "is negative"},
    MjcfBound{"tendon", "spatial", "width", 0, MjcfBound::Least::kAbove, "is not above 0"},
};

MjcfValues values_of_section(const MjcfScope& scope, std::string_view section,
                             xml::Element element) {
  const std::size_t id = mjcf_class_of(scope, element, MjcfDefaults::kMain);
  if (section == "tendon") return scope.defaults.values(element, "tendon", id);
  if (section == "actuator") {
    return scope.defaults.values_of_any(element, {element.name(), "general"}, id);
  }
  return {element, {}};
}

std::string named(xml::Element element) {
  const std::string name = mjcf_name(element, "name").value;
  return name.empty() ? std::string() : std::string(element.name()) + ' ' + name;
}

void reject(const MjcfValues& values, std::string_view attribute, std::string detail,
            MjcfFacts& facts) {
  const auto text = values.text(attribute);
  facts.push_back({.kind = MjcfKind::kValueRejected,
                   .where = text ? text->span : values.element().tag_span(),
                   .subject = named(values.element()),
                   .name = std::string(attribute),
                   .detail = std::move(detail)});
}

void check_bounds(std::string_view section, const MjcfValues& values, MjcfFacts& facts) {
  for (const MjcfBound& one : kMjcfBounds) {
    if (one.section != section) continue;
    if (!one.tag.empty() && one.tag != values.element().name()) continue;
    const auto number = values.number(one.attribute, 1);
    const bool taken = number.value > one.bound ||
                       (one.least == MjcfBound::Least::kTaken && number.value == one.bound);
    if (!taken) reject(values, one.attribute, std::string(one.words), facts);
  }
}

void check_excludes(xml::Element element, MjcfFacts& facts) {
  constexpr std::array<std::array<std::string_view, 3>, 7> kExcludes{
      {{"position", "kv", "dampratio"},
       {"position", "ctrlrange", "inheritrange"},
       {"intvelocity", "actrange", "inheritrange"},
       {"connect", "site1", "body1"},
       {"connect", "site1", "anchor"},
       {"weld", "site1", "body1"},
       {"weld", "site1", "anchor"}}};
  for (const auto& [tag, first, second] : kExcludes) {
    if (element.name() != tag) continue;
    const auto one = element.attribute(first), other = element.attribute(second);
    if (!one || !other) continue;
    facts.push_back({.kind = MjcfKind::kExcludes,
                     .where = other->span(),
                     .subject = named(element),
                     .name = std::string(first),
                     .detail = std::string(second)});
  }
}

/// A slider crank has both sites and a rod.
void check_crank(const MjcfValues& values, MjcfFacts& facts) {
  const xml::Element element = values.element();
  if (!element.attribute("cranksite")) return;
  const auto lacks = [&](const char* what) {
    facts.push_back({.kind = MjcfKind::kAttributeMissing,
                     .where = element.tag_span(),
                     .name = std::string(element.name()),
                     .detail = what});
  };
  if (!element.attribute("slidersite")) return lacks("slidersite");
  const auto length = values.number("cranklength", 0);
  if (!length.written) return lacks("cranklength");
  if (length.value <= 0) reject(values, "cranklength", "is not above 0", facts);
}

void check_custom(xml::Element element, MjcfFacts& facts) {
  const MjcfValues values(element, {});
  if (element.name() == "text" && element.attribute("data") && values.string("data").value.empty())
    reject(values, "data", "is empty", facts);
  if (element.name() != "numeric") return;
  constexpr double kMost = 500;
  const auto size = values.number("size", kMost);
  const double most = std::min(size.value, kMost);
  const auto count = values.numbers("data").size();
  if (size.value < 1 || size.value > kMost) {
    reject(values, "size", "is not between 1 and 500", facts);
  } else if (static_cast<double>(count) > most) {
    reject(values, "data", "has " + std::to_string(count) + " numbers, more than its size", facts);
  }
}

void check_root_section(xml::Element section, MjcfFacts& facts) {
  const MjcfValues values(section, {});
  if (section.name() == "statistic" && values.number("extent", 1).value <= 0)
    reject(values, "extent", "is not above 0", facts);
  const auto sequence = values.string("eulerseq", "xyz");
  if (section.name() == "compiler" && sequence.value.size() != 3)
    reject(values, "eulerseq", "does not have 3 characters", facts);
}

}  // namespace

void check_mjcf_values(const MjcfScope& scope, MjcfFacts& facts) {
  for (const xml::Element section : scope.tree.children(scope.tree.root())) {
    check_root_section(section, facts);
  }
  for_each_mjcf_element(scope.tree, [&](std::string_view section, xml::Element element) {
    if (section == "default") {
      // MuJoCo rejects it where it stands, whether an actuator takes it or not.
      check_excludes(element, facts);
    }
    if (section == "worldbody" || section == "default") return;
    const MjcfValues values = values_of_section(scope, section, element);
    check_bounds(section, values, facts);
    if (section == "actuator") {
      check_excludes(element, facts);
      check_crank(values, facts);
    }
    if (section == "equality") check_excludes(element, facts);
    if (section == "custom") check_custom(element, facts);
    if (section == "sensor" &&
        element.attribute("reftype").has_value() != element.attribute("refname").has_value()) {
      facts.push_back({.kind = MjcfKind::kAttributeMissing,
                       .where = element.tag_span(),
                       .name = std::string(element.name()),
                       .detail = element.attribute("reftype") ? "refname" : "reftype"});
    }
  });
  for_each_in_bodies(scope, [&](xml::Element element, std::size_t class_id) {
    if (element.name() != "camera") return;
    const MjcfValues values = scope.defaults.values(element, "camera", class_id);
    constexpr double kHalfTurn = 180;  // degrees, whatever the compiler says
    if (values.number("fovy", 0).value >= kHalfTurn)
      reject(values, "fovy", "is not below 180 degrees", facts);
  });
}

}  // namespace rigor::read
