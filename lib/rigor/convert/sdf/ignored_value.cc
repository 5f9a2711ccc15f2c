// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/sdf/ignored_value.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>

#include <rigor/read/values.h>
#include <rigor/schema/embedded.h>
#include <rigor/schema/schema.h>

namespace rigor::convert {
namespace {

constexpr std::string_view kIgnoredAttribute = "value";

/// Of the target: the source's own is that of URDF. Few files need it.
const schema::Schema& schema_of_blocks() {
  static const auto parsed = schema::Schema::parse(schema::sdf_schema_text());
  return std::get<schema::Schema>(parsed);
}

bool stands_inside(xml::Element element, xml::Element outer) {
  return element.span().begin >= outer.span().begin && element.span().end <= outer.span().end;
}

std::optional<schema::Node> node_in(std::string_view parent, std::string_view name,
                                    schema::Version version) {
  const schema::Schema& sdf = schema_of_blocks();
  auto node = sdf.root("sdf", sdf.nearest(version));
  if (node) node = node->child("model");
  if (node && parent != "model") node = node->child(parent);
  return node ? node->child(name) : std::nullopt;
}

bool has_value_attribute(xml::Element element) {
  if (element.attribute(kIgnoredAttribute)) return true;
  for (const xml::Element child : element.children()) {
    if (has_value_attribute(child)) return true;
  }
  return false;
}

class IgnoredValueFinder {
 public:
  /// Whether nothing of the element is left. Elements are as deep as the file, at most xml::kMaxDepth.
  bool find(xml::Element element, const schema::Node& node) {
    const auto value = element.attribute(kIgnoredAttribute);
    const bool ignored = value && !node.attribute(kIgnoredAttribute) && !node.open();
    if (ignored) found.owners.push_back(element);
    std::vector<xml::Element> emptied;
    std::size_t count = 0;
    if (!node.open()) {
      for (const xml::Element child : element.children()) {
        ++count;
        const auto inner = node.child(child.name());
        if (inner && find(child, *inner)) emptied.push_back(child);
      }
    }
    const bool has_others = element.attribute_count() > (ignored ? 1U : 0U) ||
                            !read::trimmed(element.text()).empty() || emptied.size() < count;
    if (!has_others && (ignored || count > 0)) return true;
    if (ignored) found.attributes.push_back(*value);
    found.elements.insert(found.elements.end(), emptied.begin(), emptied.end());
    return false;
  }

  IgnoredValues found;
};

/// `sensor/camera/image/width` from a child of the block down.
std::string path_in_block(xml::Element element) {
  std::string path(element.name());
  for (auto at = element.parent(); at && at->name() != "gazebo"; at = at->parent()) {
    path = std::string(at->name()) + '/' + path;
  }
  return path;
}

}  // namespace

bool IgnoredValues::has(xml::Element element) const {
  return std::find(elements.begin(), elements.end(), element) != elements.end();
}

bool IgnoredValues::has(xml::Attribute attribute) const {
  return std::any_of(attributes.begin(), attributes.end(), [&](const xml::Attribute& one) {
    return one.span().begin == attribute.span().begin;
  });
}

void IgnoredValues::lose(Ledger& ledger, const std::string& subject) const {
  std::vector<Note> notes;
  for (const xml::Element owner : owners) {
    const xml::Attribute value = *owner.attribute(kIgnoredAttribute);
    const bool stays = has(value);
    if (!stays) ledger.take(owner, Outcome::kLost);
    ledger.take_value(value.value_span(), Outcome::kLost);
    notes.push_back({.kind = NoteKind::kUnknown,
                     .where = value.span(),
                     .subject = subject,
                     .written = path_in_block(owner) + ", whose attribute value=\"" +
                                std::string(value.value()) + "\" libsdformat ignores,",
                     .count = stays ? 1U : 2U});
  }
  for (const xml::Element element : elements) {
    const std::size_t around = ledger.take_all(element, Outcome::kLost);
    const auto first = std::find_if(owners.begin(), owners.end(), [&](xml::Element owner) {
      return stands_inside(owner, element);
    });
    notes[static_cast<std::size_t>(first - owners.begin())].count += around;
  }
  for (Note& note : notes) ledger.note(std::move(note));
}

void IgnoredValues::leave_out(const xml::Document& document, LayoutChanges& changes) const {
  for (const xml::Element element : elements) changes.removed.push_back(element.span());
  for (const xml::Attribute attribute : attributes) {
    Span with_space = attribute.span();
    const auto is_space = [&](std::uint32_t at) {
      return read::trimmed(document.bytes().substr(at, 1)).empty();
    };
    while (with_space.begin > 0 && is_space(with_space.begin - 1)) --with_space.begin;
    changes.replacements.push_back({with_space, {}});
  }
}

IgnoredValues ignored_values(xml::Element element, std::string_view parent,
                             schema::Version version) {
  if (!has_value_attribute(element)) return {};
  const auto node = node_in(parent, element.name(), version);
  if (!node) return {};
  IgnoredValueFinder finder;
  if (finder.find(element, *node)) finder.found.elements.push_back(element);
  return std::move(finder.found);
}

}  // namespace rigor::convert
