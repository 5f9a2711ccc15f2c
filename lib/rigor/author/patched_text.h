// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A text that is edited again and again, and remembers which of its bytes are
// still the original's: so that what several rounds of edits did can be told as
// one list of edits of the original, and a place in the new text is found in
// the old one.
//
//   PatchedText patched(bytes);
//   patched.apply(first);                         // edits of `bytes`
//   patched.apply(second);                        // edits of what that gave
//   apply_edits(bytes, patched.edits(source));    // patched.text()

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <rigor/text/edit.h>
#include <rigor/text/span.h>

namespace rigor::author {

class PatchedText {
 public:
  explicit PatchedText(std::string original);

  const std::string& original() const { return original_; }
  const std::string& text() const { return text_; }

  /// Edits the text; whose source the spans name does not matter. False, and
  /// nothing is done, when `apply_edits` refuses them.
  bool apply(std::vector<Edit> edits);

  /// What makes the text of the original: sorted, none touches another, none
  /// leaves its bytes as they were.
  std::vector<Edit> edits(SourceId source) const;

 private:
  /// Bytes of the original from `begin` to `end`; or, when `written` is set,
  /// new ones.
  struct Piece {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    std::optional<std::string> written = std::nullopt;

    std::uint32_t size() const {
      return written ? static_cast<std::uint32_t>(written->size()) : end - begin;
    }
    Piece part(std::uint32_t from, std::uint32_t to) const;
  };

  std::string original_;
  std::string text_;
  std::vector<Piece> pieces_;
};

/// Where the places of an edited text are in the text before.
class PlacesBefore {
 public:
  /// `edits` as `apply_edits` takes them.
  explicit PlacesBefore(std::vector<Edit> edits);

  /// What begins or ends inside of a replacement, does so where the replaced
  /// bytes did.
  Span of(Span after) const;

 private:
  struct Change {
    std::uint32_t begin;  // of the edit
    std::uint32_t end;
    std::uint32_t new_begin;  // of its text
    std::uint32_t new_end;
  };
  std::vector<Change> changes_;
};

}  // namespace rigor::author
