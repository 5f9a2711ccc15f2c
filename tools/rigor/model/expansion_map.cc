// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "model/expansion_map.h"

#include <charconv>
#include <utility>
#include <vector>

#include <rigor/report/terminal/printable.h>

namespace rigor::tool {
namespace {

std::string_view frame_verb(xacro::FactFrame::Kind kind) {
  switch (kind) {
    case xacro::FactFrame::Kind::kMacro: return "called at ";
    case xacro::FactFrame::Kind::kInclude: return "included at ";
    default: return "at ";
  }
}

/// One step of a path: `link`, `link[base]`, `link[2]`.
struct TraceStep {
  std::string_view tag;
  std::string_view name;
  std::size_t number = 1;
};

TraceStep trace_step(std::string_view text) {
  TraceStep step{text.substr(0, text.find('[')), {}};
  if (step.tag.size() == text.size()) return step;
  const std::string_view inside =
      text.substr(step.tag.size() + 1, text.rfind(']') - step.tag.size() - 1);
  const auto [end, error] =
      std::from_chars(inside.data(), inside.data() + inside.size(), step.number);
  if (error != std::errc() || end != inside.data() + inside.size()) {
    step.name = inside;
    step.number = 1;
  }
  return step;
}

const xacro::Node* child_at(const xacro::Node& parent, const TraceStep& step) {
  std::size_t seen = 0;
  for (const xacro::Node* node = parent.first_element(); node != nullptr;
       node = node->next_element()) {
    if (node->name != step.tag) continue;
    if (!step.name.empty()) {
      const xacro::NodeAttribute* name = node->attribute("name");
      if (name == nullptr || name->value != step.name) continue;
    }
    if (++seen == step.number) return node;
  }
  return nullptr;
}

}  // namespace

void place_in_source(std::vector<robot::Difference>& differences, const read::File& a,
                     const read::File& b, const Sources& sources) {
  const auto place = [&](const read::File& file, Span& where) {
    if (file.expanded && !where.nowhere() && where.source == file.document->source())
      where = file.expanded->origin(*file.document, where, sources).where;
  };
  for (robot::Difference& each : differences) {
    place(a, each.span_a);
    place(b, each.span_b);
  }
}

std::string described(const xacro::Fact& fact, const Sources& sources, const Reach& reach) {
  const bool out =
      !fact.where.nowhere() && !reach.holds(std::string(sources.path(fact.where.source)));
  if (out) return "an error outside of what was named, which is not quoted";
  return xacro::describe(fact);
}

std::string shown_place(const Sources& sources, Span where) {
  if (where.nowhere()) return "?";
  const Position at = sources.position(where.source, where.begin);
  return report::printable(sources.path(where.source)) + ':' + std::to_string(at.line) + ':' +
         std::to_string(at.column);
}

std::string shown_stack(const Sources& sources, const std::vector<xacro::FactFrame>& stack) {
  std::string text;
  for (const xacro::FactFrame& frame : stack) {
    text +=
        "  in " + std::string(name_of(frame.kind)) + " '" + report::printable(frame.name, 80) + "'";
    for (std::size_t i = 0; i < frame.parameters.size(); ++i) {
      text += (i == 0 ? " (" : ", ") + report::printable(frame.parameters[i].name) + "='" +
              report::printable(frame.parameters[i].value, 40) + "'";
    }
    if (!frame.parameters.empty()) text += ')';
    text += ", " + std::string(frame_verb(frame.kind)) + shown_place(sources, frame.where) + '\n';
  }
  return text;
}

std::optional<std::string> trace(const xacro::Expansion& expansion, const Sources& sources,
                                 std::string_view path) {
  const std::size_t at = std::min(path.find('@'), path.size());
  std::string_view steps = path.substr(0, at);
  const std::string_view wanted = at < path.size() ? path.substr(at + 1) : std::string_view{};
  if (steps.starts_with('/')) steps.remove_prefix(1);
  const xacro::Node* node = expansion.document;
  while (node != nullptr && !steps.empty()) {
    // A name may hold a slash.
    const std::size_t bracket = steps.find('[');
    const std::size_t close = bracket < steps.find('/') ? steps.find(']', bracket) : 0;
    const std::size_t end =
        std::min(steps.find('/', close == std::string_view::npos ? 0 : close), steps.size());
    node = child_at(*node, trace_step(steps.substr(0, end)));
    steps.remove_prefix(std::min(end + 1, steps.size()));
  }
  if (node == nullptr || node == expansion.document) return std::nullopt;
  std::string text =
      shown_place(sources, node->where.span) + ": <" + std::string(node->name) + ">\n";
  if (!wanted.empty()) {
    const xacro::NodeAttribute* attribute = node->attribute(wanted);
    if (attribute == nullptr) return std::nullopt;
    text = shown_place(sources, attribute->where.span) + ": " + std::string(wanted) + "=\"" +
           report::printable(attribute->value) + "\", written " +
           report::printable(sources.bytes(attribute->where.span)) + '\n';
    if (!attribute->from.nowhere()) {
      text += shown_place(sources, attribute->from) + ": the value " +
              report::printable(sources.bytes(attribute->from)) + '\n';
    }
  }
  return text + shown_stack(sources, expansion.stack_of(node->frame));
}

}  // namespace rigor::tool
