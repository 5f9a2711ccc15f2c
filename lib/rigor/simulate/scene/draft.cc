// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/scene/draft.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <variant>

#include <rigor/schema/value.h>

namespace rigor::simulate {
namespace {

bool holds_span(const Span& outer, const Span& inner) {
  return outer.source == inner.source && outer.begin <= inner.begin && inner.end <= outer.end;
}

}  // namespace

bool GazeboBlocks::Less::operator()(const Key& a, const Key& b) const {
  return std::tie(a.first.source, a.first.begin, a.second) <
         std::tie(b.first.source, b.first.begin, b.second);
}

GazeboBlocks::GazeboBlocks(const model::Root& root) {
  std::vector<Span> robots;
  for (const model::Model& model : root.models) {
    if (model.format == model::Format::kUrdf) robots.push_back(model.site.span);
  }
  std::vector<Span> seen;  // a robot that is included twice brings its blocks twice
  for (const model::GazeboBlock& block : root.gazebo_blocks) {
    const Span span = block.site.span;
    if (std::find(seen.begin(), seen.end(), span) != seen.end()) continue;
    if (robots.size() > 1) seen.push_back(span);
    const auto robot = std::find_if(robots.begin(), robots.end(),
                                    [&](const Span& whole) { return holds_span(whole, span); });
    if (robot == robots.end()) continue;
    blocks_[{*robot, block.reference.value}].push_back(&block);
  }
}

std::vector<const model::Parameter*> GazeboBlocks::find(
    const model::Model& robot, const std::string& reference,
    std::initializer_list<std::string_view> names) const {
  std::vector<const model::Parameter*> found;
  if (robot.format != model::Format::kUrdf) return found;
  const auto blocks = blocks_.find({robot.site.span, reference});
  if (blocks == blocks_.end()) return found;
  for (const model::GazeboBlock* block : blocks->second) {
    for (const model::Parameter& child : block->content) {
      if (std::find(names.begin(), names.end(), child.name) != names.end()) {
        found.push_back(&child);
      }
    }
  }
  return found;
}

SceneDraft::SceneDraft(const SceneInput& from, const SceneOptions& how)
    : input(from),
      options(how),
      root(from.root),
      blocks(from.root),
      model_of(root.models.size(), kWorld),
      link_of(root.links.size(), kWorld),
      joint_of(root.joints.size(), kWorld),
      is_static(root.models.size()) {}

std::optional<double> SceneDraft::parsed_number(std::string_view text) {
  const auto parsed = schema::parse_double(text);
  const double* value = std::get_if<double>(&parsed);
  if (value == nullptr || !std::isfinite(*value)) return std::nullopt;
  return *value;
}

std::optional<xml::Element> element_at(xml::Element from,
                                       std::initializer_list<std::string_view> path) {
  std::optional<xml::Element> at = from;
  for (const std::string_view name : path) {
    if (at) at = at->child(name);
  }
  return at;
}

}  // namespace rigor::simulate
