// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The elements of a Collada file by their ids, as its urls (`#id`) name them, and small readings of
// elements that all readers of Collada share.
//
//   const ColladaIndex index(document);
//   if (auto geometry = index.find(value(instance, "url"), "geometry")) read(*geometry);

#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/xml/document.h>

namespace rigor::mesh {

/// The value of an attribute without white space around it; empty without one.
std::string_view value(xml::Element element, std::string_view attribute);

/// The whole number that an attribute holds; nothing when it holds anything else.
std::optional<std::uint64_t> count_of(xml::Element element, std::string_view attribute);

/// The element's text without white space around it.
std::string_view trimmed_text(xml::Element element);

/// The element down a path of first children.
std::optional<xml::Element> descend(xml::Element from,
                                    std::initializer_list<std::string_view> names);

/// Exactly `count` numbers, or nothing when the text is anything else.
std::optional<std::vector<double>> numbers(xml::Element element, std::size_t count);

class ColladaIndex {
 public:
  /// The document must outlive the index.
  explicit ColladaIndex(const xml::Document& document);

  const xml::Document& document() const { return document_; }

  /// What `#id` names, if that is an element called `name`. Of two with one id the first counts;
  /// other files are never examined.
  std::optional<xml::Element> find(std::string_view url, std::string_view name) const;

  /// Without the `#`, as images are named.
  std::optional<xml::Element> find_id(std::string_view id, std::string_view name) const;

  /// 1-based, of the element's tag.
  std::uint64_t line(xml::Element element) const;

 private:
  const xml::Document& document_;
  std::vector<std::pair<std::string_view, std::uint32_t>> elements_;  ///< by id, then place
  std::vector<std::uint32_t> line_ends_;
};

}  // namespace rigor::mesh
