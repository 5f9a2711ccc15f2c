// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Changes to an XML file in its author's own style, as byte edits: indentation, line ends, quotes and
// the place of a bracket are taken from what stands around. What is not named keeps its bytes.
//
//   std::vector<Edit> edits = insert_child(document, link, pose, "<mass>1</mass>");
//   std::optional<std::string> changed = apply_edits(document.bytes(), edits);
//
// A document that was cut by a fatal fault is never edited: every function returns no edits then.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/text/edit.h>
#include <rigor/xml/document.h>

namespace rigor::xml {

/// New children of `parent` behind its child `after`; as its first when that is nothing. `xml` is an
/// element, or several, a line each at least: laid out with `"`, "/>", two spaces a level and '\n',
/// without one at the end. It takes the author's layout; children that stand in one line stay so. An
/// empty element `<a/>` gets an end tag. A comment behind `after`, or behind the start tag, on the
/// same line keeps its place.
std::vector<Edit> insert_child(const Document& document, Element parent,
                               std::optional<Element> after, std::string_view xml);

/// `xml`, as above, in the element's place.
std::vector<Edit> replace_element(const Document& document, Element element, std::string_view xml);

/// The element and, when nothing else stands on its lines, the lines. Comments stay. A root element
/// is never removed: a file needs one.
std::vector<Edit> remove_element(const Document& document, Element element);

/// What `Element::text()` reads, the white space around it kept; nothing to do when it reads so.
std::vector<Edit> set_text(const Document& document, Element element, std::string_view text);

struct NamedValue {
  std::string_view name;
  std::string value;  ///< not escaped
};

/// The values of attributes; new ones go behind the last, in this order, spaced as it is. Those that
/// read so already keep their bytes.
std::vector<Edit> set_attributes(const Document& document, Element element,
                                 const std::vector<NamedValue>& values);
std::vector<Edit> set_attribute(const Document& document, Element element, std::string_view name,
                                std::string_view value);

/// The attribute and the white space before it.
std::vector<Edit> remove_attribute(const Document& document, Attribute attribute);

/// In the start tag and in the end tag.
std::vector<Edit> rename_element(const Document& document, Element element, std::string_view name);

/// With `&`, `<`, `>` and both quotes as entities.
std::string escaped(std::string_view text);

}  // namespace rigor::xml
