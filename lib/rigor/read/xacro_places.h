// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// From a place in what `xacro` made of a file back to the place in the file that it comes from.
//
//   const XacroPlaces places(expanded, source);       // two documents
//   Span where = places.of(finding.where);            // in the source, or nowhere
//
// xacro says nothing of where its lines come from, so places are found by names. An element whose tag and
// name stand in both texts once is the same; so is one whose name fits one `${prefix}_link` in the source
// and no other, unless the source includes files that nobody has read here. From there down it goes
// along children that are the only ones of their tag. Where that ends, the element reached is the place; a
// finding with no named element around it but the root has none.

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/text/diagnostic.h>
#include <rigor/text/span.h>
#include <rigor/xml/document.h>

namespace rigor::read {

/// Both documents outlive it.
class XacroPlaces {
 public:
  XacroPlaces(const xml::Document& expanded, const xml::Document& source);

  /// `where` is in the expanded text; nowhere when its origin cannot be told.
  Span of(Span where) const;

  /// A finding in the expanded text as one in the source, which is at `path`. Its fixes are gone: they
  /// would change what nobody wrote.
  Diagnostic in_source(Diagnostic diagnostic, const std::string& path) const;

 private:
  using Key = std::pair<std::string_view, std::string_view>;  // tag and name
  using Index = std::map<Key, std::optional<std::uint32_t>>;  // nothing when there are several

  static Index index_of(const xml::Document& document);
  std::optional<xml::Element> origin(const xml::Element& element) const;
  std::optional<xml::Element> fitting(const Key& key) const;

  const xml::Document& expanded_;
  const xml::Document& source_;
  Index in_expanded_;
  Index in_source_;
  std::vector<xml::Element> patterns_;  ///< of the source, named by an expression
};

/// Whether a name is what `${prefix}_link` may become: its plain parts, in their order.
bool fits_xacro_name(std::string_view pattern, std::string_view name);

}  // namespace rigor::read
