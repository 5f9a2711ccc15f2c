// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is known of the thing at the cursor: what the schema says of an element, what a link weighs, how a joint
// moves, what an expression gives.

#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <fmt/core.h>

#include <rigor/lsp/answer/answers.h>
#include <rigor/lsp/answer/mesh_hover.h>
#include <rigor/lsp/answer/name_lookup.h>
#include <rigor/lsp/answer/uri_at.h>
#include <rigor/lsp/document/schema_place.h>
#include <rigor/lsp/document/xacro_tags.h>
#include <rigor/mass/link_body.h>
#include <rigor/mass/proposal.h>
#include <rigor/mass/resolve.h>
#include <rigor/report/number.h>
#include <rigor/text/path.h>

namespace rigor::lsp {
namespace {

/// Values of an expression that are shown; a macro may be called a hundred times.
constexpr std::size_t kMaxValues = 5;

std::string vector_text(const model::Vector3& v) { return report::numbers(v, 4); }

bool has_limits(double lower, double upper) {
  return std::abs(lower) < 1e15 && std::abs(upper) < 1e15;  // past which consumers take no limit
}

std::string link_text(Analysis& analysis, const model::Link& link, model::Id<model::Link> id) {
  const model::Root& root = analysis.loaded().root;
  const mass::FindMesh no_meshes = [](const model::Mesh&) { return nullptr; };
  const mass::Resolved taken = mass::resolve(root, analysis.frames(), id, no_meshes);
  const mass::MassProperties& body = taken.body;
  std::string text = fmt::format("**link** `{}`: {} kg, center of mass ({}) m\n\n", link.name.value,
                                 report::number(body.mass, 4), vector_text(body.com));
  text += fmt::format("ixx {}, iyy {}, izz {} kg·m²", report::number(body.about_com.ixx, 4),
                      report::number(body.about_com.iyy, 4), report::number(body.about_com.izz, 4));
  if (!link.inertial.written) text += " (no inertial is written)";
  const mass::LinkBody shapes =
      mass::link_body(root, analysis.frames(), id, mass::From::kCollisions, no_meshes);
  if (!shapes.complete()) return text;
  const mass::MassProperties solid = mass::of_density(shapes, 1);
  if (solid.mass <= 0 || body.mass <= 0) return text;
  const mass::MassProperties same_mass = mass::with_mass(solid, body.mass);
  const double ratio = mass::trace(body.about_com) / mass::trace(same_mass.about_com);
  return text + fmt::format(
                    "\n\nIts collisions as a solid of that mass: center of mass ({}) m, density {} "
                    "kg/m³; the "
                    "moments here are {} times theirs",
                    vector_text(same_mass.com), report::number(body.mass / solid.mass, 4),
                    report::number(ratio, 3));
}

std::string joint_text(Analysis& analysis, const model::Joint& joint, model::Id<model::Joint> id) {
  std::string text = fmt::format("**joint** `{}`: {}, `{}` → `{}`", joint.name.value,
                                 joint.type_name.value, joint.parent.value, joint.child.value);
  const bool is_angle = joint.type == model::JointType::kRevolute ||
                        joint.type == model::JointType::kContinuous ||
                        joint.type == model::JointType::kRevolute2;
  for (std::size_t i = 0; i < joint.axes.size(); ++i) {
    const model::Axis& axis = joint.axes[i];
    if (joint.type == model::JointType::kFixed) break;
    text += fmt::format("\n\naxis ({})", vector_text(axis.xyz.value));
    if (const auto in_world = analysis.frames().axis(id, i))
      text += fmt::format(", ({}) in the frame of the model", vector_text(*in_world));
    if (!axis.limit_written || !has_limits(axis.lower.value, axis.upper.value)) continue;
    text += fmt::format("\n\nlimits {} to {} {}", report::number(axis.lower.value, 4),
                        report::number(axis.upper.value, 4), is_angle ? "rad" : "m");
    const double degrees = 180 / std::numbers::pi;
    if (is_angle)
      text += fmt::format(" ({}° to {}°)", report::number(axis.lower.value * degrees, 4),
                          report::number(axis.upper.value * degrees, 4));
  }
  return text;
}

/// Of a name, what it represents.
std::string entity_text(Analysis& analysis, const author::EntityId& id) {
  const author::NamedEntity& entity = analysis.names().entity(id);
  const read::File& file = analysis.names().file(id.path);
  const model::Root& root = analysis.loaded().root;
  // The same file may have been read twice, so names are compared by their places.
  const auto is_it = [&](const model::Site& site) {
    return site.span.source == file.source && site.span.begin == entity.element.begin;
  };
  for (std::uint32_t i = 0; i < root.links.size(); ++i) {
    if (is_it(root.links[i].site)) return link_text(analysis, root.links[i], {i});
  }
  for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
    if (is_it(root.joints[i].site)) return joint_text(analysis, root.joints[i], {i});
  }
  return fmt::format("**{}** `{}`", to_string(entity.kind), entity.name);
}

void collect_values(const xacro::Node& node, Span written, std::set<std::string>& values) {
  const auto overlaps = [written](const xacro::Place& place) {
    return place.span.source == written.source && place.span.begin <= written.begin &&
           written.end <= place.span.end;
  };
  for (const xacro::NodeAttribute& attribute : node.attributes) {
    if (overlaps(attribute.where)) values.emplace(attribute.value);
  }
  if (node.kind == xacro::NodeKind::kText && overlaps(node.where)) values.emplace(node.text);
  for (const xacro::Node* child = node.first; child != nullptr; child = child->next)
    collect_values(*child, written, values);
}

/// What the value at a place of a template becomes.
std::string expanded_text(Analysis& analysis, Span at) {
  const read::File& file = analysis.file();
  if (!file.expanded || file.expanded->expansion().root == nullptr) return {};
  const xacro::Expansion& expansion = file.expanded->expansion();
  if (expansion.files.empty()) return {};
  std::set<std::string> values;
  at.source = expansion.files.front().source;
  collect_values(*expansion.root, at, values);
  std::string text;
  std::size_t shown = 0;
  for (const std::string& value : values) {
    if (shown++ == kMaxValues) {
      text += fmt::format("\n\n… and {} more", values.size() - kMaxValues);
      break;
    }
    text += fmt::format("{}`{}`", shown == 1 ? "" : "\n\n", value);
  }
  return text;
}

std::string template_name_text(Analysis& analysis, const NameAt& name) {
  const auto& written = std::get<author::TemplateName>(name.name);
  std::string text = fmt::format("**{}** `{}`", to_string(written.kind), written.name);
  for (const NamePlace& place : places_of(analysis, name, {})) {
    if (!place.defines) continue;
    const Sources& sources = analysis.sources();
    const std::string_view bytes = sources.bytes(place.where.source);
    const xml::Document document = xml::parse_own(bytes, place.where.source);
    const auto element = document.element_at(place.where.begin);
    if (!element) continue;
    const std::string_view path = sources.path(place.where.source);
    if (normalize_path(path) != normalize_path(analysis.path()))
      text += fmt::format(", defined in {}", file_name(path));
    const Span tag = element->tag_span();
    text += fmt::format("\n\n```xml\n{}\n```", bytes.substr(tag.begin, tag.size()));
  }
  const std::string values = expanded_text(analysis, name.where);
  return values.empty() ? text : text + "\n\n" + values;
}

std::vector<std::string_view> path_to(xml::Element element) {
  std::vector<std::string_view> path{element.name()};
  for (auto parent = element.parent(); parent; parent = parent->parent())
    path.insert(path.begin(), parent->name());
  return path;
}

struct HoverText {
  std::string text;
  Span where;
};

std::optional<HoverText> schema_hover(Analysis& analysis, xml::Element element,
                                      std::uint32_t offset) {
  const auto root = analysis.written().root();
  const auto version = root ? root->attribute("version") : std::nullopt;
  const auto node =
      schema_place(analysis.environment(), path_to(element), version ? version->value() : "");
  if (!node) return std::nullopt;
  const auto holds = [offset](Span span) { return span.begin <= offset && offset <= span.end; };
  if (holds(element.name_span())) return HoverText{schema_text(*node), element.name_span()};
  for (const xml::Attribute attribute : element.attributes()) {
    const auto known = node->attribute(attribute.name());
    if (known && holds(attribute.name_span()))
      return HoverText{schema_text(*known), attribute.name_span()};
  }
  return std::nullopt;
}

/// Of the name in the start tag of an element that is xacro's: the macro that it calls, or what xacro does with it.
std::optional<HoverText> xacro_hover(Analysis& analysis, xml::Element element,
                                     std::uint32_t offset) {
  const Span where = element.name_span();
  if (offset < where.begin || where.end < offset) return std::nullopt;
  if (const std::string_view text = xacro_tag_text(element.name()); !text.empty())
    return HoverText{fmt::format("**{}**\n\n{}", element.name(), text), where};
  const auto macro = name_at(analysis, where.end);
  if (!macro || !std::holds_alternative<author::TemplateName>(macro->name)) return std::nullopt;
  return HoverText{template_name_text(analysis, *macro), where};
}

std::optional<HoverText> value_hover(Analysis& analysis, xml::Element element,
                                     std::uint32_t offset) {
  for (const xml::Attribute attribute : element.attributes()) {
    const Span where = attribute.value_span();
    if (where.begin > offset || offset > where.end ||
        attribute.value().find('$') == std::string_view::npos)
      continue;
    std::string text = expanded_text(analysis, where);
    if (!text.empty()) return HoverText{std::move(text), where};
  }
  return std::nullopt;
}

std::optional<HoverText> mesh_hover(const State& state, Analysis& analysis, std::uint32_t offset) {
  const auto reference = reference_at(state, analysis, offset);
  if (!reference || !is_mesh_path(reference->path)) return std::nullopt;
  return HoverText{mesh_text(state, reference->path), reference->where};
}

std::optional<HoverText> hover_at(const State& state, Analysis& analysis, std::uint32_t offset) {
  if (auto mesh = mesh_hover(state, analysis, offset)) return mesh;
  const auto element = analysis.written().element_at(offset);
  if (element && is_of_xacro(element->name())) {
    if (auto text = xacro_hover(analysis, *element, offset)) return text;
  } else if (element) {
    if (auto text = schema_hover(analysis, *element, offset)) {
      const bool has_entity = element->name() == "link" || element->name() == "joint";
      if (!has_entity || text->where.begin != element->name_span().begin || analysis.is_template())
        return text;
      if (const auto name = element->attribute("name")) {
        const auto entity = name_at(analysis, name->value_span().begin);
        if (entity && std::holds_alternative<author::EntityId>(entity->name))
          text->text = entity_text(analysis, std::get<author::EntityId>(entity->name)) +
                       "\n\n---\n\n" + text->text;
      }
      return text;
    }
  }
  if (const auto name = name_at(analysis, offset)) {
    return HoverText{std::holds_alternative<author::EntityId>(name->name)
                         ? entity_text(analysis, std::get<author::EntityId>(name->name))
                         : template_name_text(analysis, *name),
                     name->where};
  }
  return element && analysis.is_template() ? value_hover(analysis, *element, offset) : std::nullopt;
}

}  // namespace

Json hover(State& state, const Json& params) {
  OpenDocument& document = state.document(params);
  Analysis& analysis = document.readable(state.environment());
  const auto found = hover_at(
      state, analysis, document.to_readable(offset_in(document, member(params, "position"))));
  if (!found) return nullptr;
  const std::uint32_t begin = document.from_readable(found->where.begin);
  return {{"contents", {{"kind", "markdown"}, {"value", found->text}}},
          {"range", range_json(document.lines(), begin, begin + found->where.size())}};
}

}  // namespace rigor::lsp
