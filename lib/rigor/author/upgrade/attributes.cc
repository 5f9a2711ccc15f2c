// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// SDF 1.0 wrote most values as attributes; 1.2 has elements for them, mostly of the same name. Which,
// the schema's tables say; what goes by another name stands here.

#include <array>
#include <string>

#include <rigor/author/upgrade/step.h>
#include <rigor/xml/edit.h>
#include <rigor/xml/style.h>

namespace rigor::author {
namespace {

using schema::Node;
using schema::Version;

struct RenamedAttribute {
  std::string_view element;
  std::string_view attribute;
  std::string_view name;
};
constexpr std::array<RenamedAttribute, 6> kNewNames{{{"fog", "rgba", "color"},
                                                     {"heightmap", "origin", "pos"},
                                                     {"mesh", "filename", "uri"},
                                                     {"image", "filename", "uri"},
                                                     {"heightmap", "filename", "uri"},
                                                     {"include", "filename", "uri"}}};

std::string_view new_name(std::string_view element, std::string_view attribute) {
  for (const RenamedAttribute& each : kNewNames) {
    if (each.element == element && each.attribute == attribute) return each.name;
  }
  return attribute;
}

/// Where Gazebo looked for the scripts that SDF 1.0 named without a place.
constexpr std::string_view kScripts = "file://media/materials/scripts/gazebo.material";

/// The attribute's value as an element of that name.
std::string value_element(std::string_view name, xml::Attribute attribute) {
  const std::string value = xml::escaped(attribute.value());
  const std::string tag(name);
  if (name == "script") {
    return "<script>\n  <uri>" + std::string(kScripts) + "</uri>\n  <name>" + value +
           "</name>\n</script>";
  }
  return '<' + tag + '>' + value + "</" + tag + '>';
}

/// `<origin pose="1"/>` becomes `<pose>1</pose>`.
std::vector<Edit> attribute_to_text(const xml::Document& document, xml::Element element,
                                    xml::Attribute attribute, std::string_view name) {
  std::vector<Edit> edits = xml::remove_attribute(document, attribute);
  if (!xml::is_empty_tag(document, element)) {
    append(edits, xml::rename_element(document, element, name));
    append(edits, xml::set_text(document, element, attribute.value()));
    return edits;
  }
  if (element.name() != name) edits.push_back({element.name_span(), std::string(name)});
  const Span tag = element.tag_span();
  const std::string_view bytes = document.bytes();
  std::uint32_t end = tag.end - 2;  // of what stands before "/>"
  while (xml::kBlanks.find(bytes[end - 1]) != std::string_view::npos || bytes[end - 1] == '\n' ||
         bytes[end - 1] == '\r') {
    --end;
  }
  edits.push_back({{tag.source, end, tag.end},
                   '>' + xml::escaped(attribute.value()) + "</" + std::string(name) + '>'});
  return edits;
}

class AttributeMove {
 public:
  explicit AttributeMove(UpgradeStep& step)
      : step_(step),
        document_(step.document()),
        newer_(schema_nodes(document_, step.schema(), Version{2})) {}

  void move(xml::Element element) {
    move_origin(element);
    if (element.name() == "origin") return;
    const auto damping = element.name() == "link" ? element.child("damping") : std::nullopt;
    if (damping) step_.edit(xml::rename_element(document_, *damping, "velocity_decay"));
    const auto& newer = newer_[element.index()];
    if (!newer) return;
    std::string children;
    for (const xml::Attribute attribute : element.attributes()) {
      const std::string_view name = new_name(element.name(), attribute.name());
      if (newer->attribute(attribute.name())) continue;
      if (newer->child(name) && !element.child(name)) {
        if (!children.empty()) children += '\n';
        children += value_element(name, attribute);
        step_.edit(xml::remove_attribute(document_, attribute));
      } else if (is_the_value(element, attribute, *newer)) {
        step_.edit(attribute_to_text(document_, element, attribute, element.name()));
      }
    }
    if (!children.empty()) {
      step_.edit(xml::insert_child(document_, element, std::nullopt, children));
    }
  }

 private:
  void move_origin(xml::Element parent) {
    const auto origin = parent.child("origin");
    const auto pose = origin ? origin->attribute("pose") : std::nullopt;
    if (!pose || parent.child("pose") || !step_.node(*origin)) return;
    step_.edit(attribute_to_text(document_, *origin, *pose, "pose"));
  }

  /// Whether an element that had the attribute alone has a text instead.
  bool is_the_value(xml::Element element, xml::Attribute attribute, const Node& newer) const {
    const auto older = step_.node(element);
    return older && older->attribute(attribute.name()) && older->type() == schema::Type::kNone &&
           newer.type() != schema::Type::kNone;
  }

  UpgradeStep& step_;
  const xml::Document& document_;
  std::vector<std::optional<Node>> newer_;
};

}  // namespace

void upgrade_attributes(UpgradeStep& step) {
  AttributeMove moves(step);
  step.for_each([&](xml::Element element) { moves.move(element); });
}

void upgrade_file_names(UpgradeStep& step) {
  step.for_each("geometry", "mesh", [&](xml::Element mesh) {
    const auto name = mesh.child("filename");
    if (!name || mesh.child("uri")) return;
    step.edit(xml::rename_element(step.document(), *name, "uri"));
  });
}

}  // namespace rigor::author
