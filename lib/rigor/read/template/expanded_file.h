// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a template became, and the way from a place in it back to where somebody wrote it.
//
//   const ExpandedFile& made = *file.expanded;
//   Origin origin = made.origin(*file.document, finding.where, sources);
//   Diagnostic told = made.in_source(*file.document, finding, sources);
//
// The expanded document's elements are the expansion's nodes, in their order; each node knows the tag,
// attribute or text that it was made of, and the macro calls that brought it.

#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <rigor/text/diagnostic.h>
#include <rigor/text/sources.h>
#include <rigor/text/span.h>
#include <rigor/xacro/expand.h>
#include <rigor/xacro/fact.h>
#include <rigor/xacro/node.h>
#include <rigor/xml/document.h>

namespace rigor::read {

/// Where a part of an expanded document was written.
struct Origin {
  Span where;               ///< in the template or a file that it includes
  std::uint32_t frame = 0;  ///< index in the expansion's frames
  Span from = {};           ///< where a property or argument in it is set; else nowhere
  bool literal = false;     ///< whether the same bytes are written there
};

class ExpandedFile {
 public:
  explicit ExpandedFile(xacro::Expansion expansion);

  const xacro::Expansion& expansion() const { return expansion_; }
  bool ok() const { return expansion_.ok(); }
  bool is_known() const { return expansion_.is_known(); }

  /// Of `expanded`, the document that was made of the expansion's text, the links that lack nothing, whatever
  /// errors there were elsewhere.
  std::vector<Span> whole_links(const xml::Document& expanded) const;

  /// `expanded` is the document that was made of the expansion's text.
  Origin origin(const xml::Document& expanded, Span where, const Sources& sources) const;

  /// A finding in the expanded document as one in what its author wrote, with the calls that lead there.
  /// A fix stays when all that it changes is written as it is in the expansion, in one file: the template or
  /// one that it includes.
  Diagnostic in_source(const xml::Document& expanded, Diagnostic diagnostic,
                       const Sources& sources) const;

 private:
  Origin of_attribute(const xml::Attribute& attribute, const xacro::Node& node, Span where,
                      const Sources& sources) const;
  Origin of_part(const xacro::NodeAttribute& made, std::uint32_t frame, std::uint32_t offset,
                 const Sources& sources) const;
  Origin of_text(const xml::Element& element, const xacro::Node& node, Span where,
                 const Sources& sources) const;
  /// Of stray text behind a child, which no element has for its value; nothing when no text of the element has it.
  static std::optional<Origin> of_text_between(const xacro::Node& node, Span where,
                                               const Sources& sources);

  /// Where the same bytes are written, in the template or an included file; else nowhere.
  Span literal_span(const xml::Document& expanded, Span where, const Sources& sources) const;

  xacro::Expansion expansion_;
  std::vector<const xacro::Node*> elements_;  // in document order
};

/// Where the value that a finding is about is set, as `in_source` has added it; else nowhere.
Span where_set(const Diagnostic& diagnostic);

/// The macro calls of a stack, innermost first.
std::vector<MacroCall> macro_calls(const std::vector<xacro::FactFrame>& stack);

}  // namespace rigor::read
