// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/patched_text.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace rigor::author {
namespace {

/// As `apply_edits` does them: by place, the same one once.
std::vector<Edit> in_order(std::vector<Edit> edits) {
  std::stable_sort(edits.begin(), edits.end(), [](const Edit& a, const Edit& b) {
    return std::pair(a.span.begin, a.span.end) < std::pair(b.span.begin, b.span.end);
  });
  edits.erase(std::unique(edits.begin(), edits.end()), edits.end());
  return edits;
}

}  // namespace

PatchedText::Piece PatchedText::Piece::part(std::uint32_t from, std::uint32_t to) const {
  if (written) return {0, 0, written->substr(from, to - from)};
  return {begin + from, begin + to};
}

PatchedText::PatchedText(std::string original)
    : original_(std::move(original)),
      text_(original_),
      pieces_{{0, static_cast<std::uint32_t>(original_.size())}} {}

bool PatchedText::apply(std::vector<Edit> edits) {
  std::optional<std::string> text = apply_edits(text_, edits);
  if (!text) return false;
  edits = in_order(std::move(edits));
  std::vector<Piece> pieces;
  std::uint32_t begin = 0;  // of the piece, in the text before the edits
  std::uint32_t done = 0;   // of that text
  auto edit = edits.begin();
  for (const Piece& piece : std::exchange(pieces_, {})) {
    const std::uint32_t end = begin + piece.size();
    for (; edit != edits.end() && edit->span.begin < end; ++edit) {
      const std::uint32_t kept_from = std::max(done, begin);
      if (kept_from < edit->span.begin) {
        pieces.push_back(piece.part(kept_from - begin, edit->span.begin - begin));
      }
      pieces.push_back({0, 0, edit->text});
      done = edit->span.end;
    }
    if (std::max(done, begin) < end)
      pieces.push_back(piece.part(std::max(done, begin) - begin, end - begin));
    begin = end;
  }
  for (; edit != edits.end(); ++edit) pieces.push_back({0, 0, edit->text});  // behind the last byte
  pieces_ = std::move(pieces);
  text_ = std::move(*text);
  return true;
}

std::vector<Edit> PatchedText::edits(SourceId source) const {
  std::vector<Edit> edits;
  std::uint32_t at = 0;  // in the original
  std::string written;
  const auto replace_up_to = [&](std::uint32_t end) {
    const std::string_view old = std::string_view(original_).substr(at, end - at);
    if (old != written) edits.push_back({{source, at, end}, written});
    written.clear();
  };
  for (const Piece& piece : pieces_) {
    if (piece.written) {
      written += *piece.written;
      continue;
    }
    // What was split at an edit of nothing is one piece still.
    if (piece.begin != at || !written.empty()) replace_up_to(piece.begin);
    at = piece.end;
  }
  replace_up_to(static_cast<std::uint32_t>(original_.size()));
  return edits;
}

PlacesBefore::PlacesBefore(std::vector<Edit> edits) {
  std::uint32_t end = 0;      // of the last edit
  std::uint32_t new_end = 0;  // of its text
  for (const Edit& edit : in_order(std::move(edits))) {
    const std::uint32_t new_begin = new_end + (edit.span.begin - end);
    end = edit.span.end;
    new_end = new_begin + static_cast<std::uint32_t>(edit.text.size());
    changes_.push_back({edit.span.begin, end, new_begin, new_end});
  }
}

Span PlacesBefore::of(Span after) const {
  // The first change that ends behind a place: the place is in it, or before
  // it.
  const auto change_at = [this](std::uint32_t place) {
    return std::upper_bound(
        changes_.begin(), changes_.end(), place,
        [](std::uint32_t at, const Change& change) { return at < change.new_end; });
  };
  const auto unmoved = [this](auto change, std::uint32_t place) {
    if (change == changes_.begin()) return place;
    const Change& last = *(change - 1);
    return last.end + (place - last.new_end);
  };
  const auto first = change_at(after.begin);
  const bool begins_inside = first != changes_.end() && first->new_begin <= after.begin;
  Span before = after;
  before.begin = begins_inside ? first->begin : unmoved(first, after.begin);
  if (after.size() == 0) {
    before.end = before.begin;
    return before;
  }
  // The end is that of the last byte.
  const auto last = change_at(after.end - 1);
  const bool ends_inside = last != changes_.end() && last->new_begin < after.end;
  before.end = ends_inside ? last->end : unmoved(last, after.end - 1) + 1;
  return before;
}

}  // namespace rigor::author
