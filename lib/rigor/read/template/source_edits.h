// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Edits of an expanded document that add, remove or rename, as edits of what the template's author wrote.
//
// What an edit does is recognized by making it anew: if removing that attribute of the expanded document is
// that edit, then removing the attribute that was written is its like. So the author's own layout is kept.
//
//   const SourceEdits edits(made, *file.document, sources);
//   std::vector<Edit> written = edits.of(fix.edits);   // empty when there are none of the kind

#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <rigor/text/edit.h>
#include <rigor/text/sources.h>
#include <rigor/xacro/node.h>
#include <rigor/xml/document.h>

namespace rigor::read {

class SourceEdits {
 public:
  /// `elements` are the nodes that the elements of `expanded` were made of, in document order. All outlive
  /// this.
  SourceEdits(const std::vector<const xacro::Node*>& elements, const xml::Document& expanded,
              const Sources& sources)
      : elements_(elements), expanded_(expanded), sources_(sources) {}

  /// All of a fix, in one file; empty where a part is not written as it is in the expansion.
  std::vector<Edit> of(const std::vector<Edit>& edits) const;

 private:
  /// An element of the expanded document, and the one that was written for it.
  struct Pair {
    xml::Element shown;
    xml::Document file;
    xml::Element written() const { return file.element(index); }
    std::uint32_t index;
  };

  std::optional<Pair> pair_of(xml::Element shown) const;
  std::vector<Edit> of_attribute(const Pair& pair, const Edit& edit) const;
  std::vector<Edit> of_removed(const Pair& pair, const std::vector<Edit>& edits) const;
  std::vector<Edit> of_renamed(const Pair& pair, const std::vector<Edit>& edits) const;
  std::vector<Edit> of_inserted(const Edit& edit) const;
  std::vector<Edit> of_inserted(xml::Element parent, std::optional<xml::Element> after,
                                const Edit& edit) const;

  const std::vector<const xacro::Node*>& elements_;
  const xml::Document& expanded_;
  const Sources& sources_;
};

}  // namespace rigor::read
