// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A part of a document as a document of its own: a model of a world, a link of a robot, with the start and end tags
// of the elements around it, and the comments before them.
//
//   std::optional<Excerpt> part = Excerpt::around(document, change);   // of the text before the change
//   check(part->after(change).text(changed_text));
//
// In the tags and the comments, and in nothing else, `core` is what differs from the document.

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/lsp/document/moving_place.h>
#include <rigor/text/span.h>
#include <rigor/xml/document.h>

namespace rigor::lsp {

class Excerpt {
 public:
  /// The largest element of at most `kMaxPartBytes` that a change of the document is within; where that is
  /// between two of them, both. Nothing when there is none, or the document has no end.
  static std::optional<Excerpt> around(const xml::Document& document, const TextChange& change);

  /// A check of so much takes some 3 ms.
  static constexpr std::uint32_t kMaxPartBytes = std::uint32_t{32} << 10U;

  /// The same part when the change that it is around was made.
  Excerpt after(const TextChange& change) const;

  /// Of the document's text.
  std::string text(std::string_view document) const;

  /// Places in `text` as offsets in the document.
  std::uint32_t begin_in_document(std::uint32_t begin) const;
  std::uint32_t end_in_document(std::uint32_t end) const;

  /// Whether bytes of the document are in the part itself, not in a tag around it.
  bool core_has(std::uint32_t begin, std::uint32_t end) const;

  bool operator==(const Excerpt&) const = default;

 private:
  struct Piece {
    std::uint32_t begin;
    std::uint32_t end;
    bool operator==(const Piece&) const = default;
  };

  std::vector<Piece> pieces_;  // of the document, in its order
  std::size_t changed_ = 0;    // the one that the change is in
  Piece core_{};
};

}  // namespace rigor::lsp
