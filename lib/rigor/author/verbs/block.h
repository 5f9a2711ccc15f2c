// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Elements copied from one place to another with their bytes: comments and layout are the author's.
//
//   std::string text = part_after(document, begin, end, edits);   // of the copy
//   Edit edit = *block_at_end(document, holder, text);
//
// Private to the room.

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/author/verbs/edited_model.h>
#include <rigor/model/pose.h>
#include <rigor/text/edit.h>
#include <rigor/xml/document.h>

namespace rigor::author {

/// Where an element's end tag begins, or its line where nothing else stands there; nothing in `<a/>`.
std::optional<std::uint32_t> end_of_content(const xml::Document& document, xml::Element element);

/// The bytes from one offset to another, after those of the edits that lie in between.
std::string part_after(const xml::Document& document, std::uint32_t begin, std::uint32_t end,
                       std::vector<Edit> edits);

/// The text, whole lines with the indentation that it has and the line ends of the document, as the last content of an
/// element; nothing in `<a/>`.
std::optional<Edit> block_at_end(const xml::Document& document, xml::Element holder,
                                 std::string text);

/// The same, as the last content of the root of the file that a template is written in. Nothing where that has none, or
/// does not declare `xacro:`.
std::optional<Edit> block_in_template(const EditedModel& edited, std::string text);

/// With "\n" or "\r\n" as all of its line ends.
std::string with_line_ends(std::string_view text, std::string_view line);

/// A prefix and the URI that it is bound to.
using Namespace = std::pair<std::string, std::string>;

/// Those of elements and attributes from one offset to another, which are declared around them; what is declared in
/// between goes along with a copy. Sorted, each once.
std::vector<Namespace> namespaces_used(const xml::Document& document, std::uint32_t begin,
                                       std::uint32_t end);

/// Those that an element declares.
std::vector<Namespace> declared_namespaces(xml::Element element);

/// A line for each prefix that a copy from `from` has for another URI than `into`.
std::vector<std::string> namespace_conflicts(const std::vector<Namespace>& bound,
                                             std::string_view into,
                                             const std::vector<Namespace>& used,
                                             std::string_view from);

/// Declares at an element those that it does not, as edits. What it binds to another URI stays.
std::vector<Edit> declared(const xml::Document& document, xml::Element element,
                           const std::vector<Namespace>& namespaces);

/// What the children of an element begin with.
std::string child_indentation(const xml::Document& document, xml::Element holder);

/// Behind which something is inserted as the last; none of an element without children.
std::optional<xml::Element> last_child_of(xml::Element element);

/// Without white space at its end and empty lines at its beginning.
std::string trimmed_lines(std::string text);

/// Numbers of a pose, in m and rad: "x y z" and "roll pitch yaw".
std::string xyz_text(const model::Pose& X);
std::string rpy_text(const model::Pose& X);

}  // namespace rigor::author
