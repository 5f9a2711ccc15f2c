// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/document/excerpt.h>

#include <algorithm>

namespace rigor::lsp {
namespace {

bool is_small(xml::Element element) { return element.span().size() <= Excerpt::kMaxPartBytes; }

/// Whether the change is between an element's brackets, all of it.
bool encloses(xml::Element element, const TextChange& change) {
  const Span span = element.span();
  return span.begin < change.begin && change.end < span.end;
}

/// Where an element's end tag begins, which it has.
std::uint32_t end_tag_begin(const xml::Document& document, xml::Element element) {
  return static_cast<std::uint32_t>(document.bytes().rfind("</", element.span().end - 1));
}

/// Children of an element, next to each other, that a change is within.
struct Run {
  std::uint32_t begin;  // behind what is before them
  std::uint32_t first;  // of the first, or where the first would be
  std::uint32_t end;
};

Run run_around(const xml::Document& document, xml::Element parent, const TextChange& change) {
  Run run{parent.tag_span().end, parent.tag_span().end, end_tag_begin(document, parent)};
  std::uint32_t before = run.begin;
  for (const xml::Element child : parent.children()) {
    const Span span = child.span();
    if (span.begin < change.begin) {
      run.begin = before;
      run.first = span.begin;
    }
    before = span.end;
    if (span.end > change.end) {
      run.end = span.end;
      break;
    }
  }
  return run;
}

/// Behind what is before an element in its parent.
std::uint32_t begin_with_comments(xml::Element element) {
  const auto parent = element.parent();
  if (!parent) return 0;
  std::uint32_t begin = parent->tag_span().end;
  for (const xml::Element sibling : parent->children()) {
    if (sibling == element) break;
    begin = sibling.span().end;
  }
  return begin;
}

}  // namespace

std::optional<Excerpt> Excerpt::around(const xml::Document& document, const TextChange& change) {
  if (!document.complete() || change.begin == 0) return std::nullopt;
  std::optional<xml::Element> parent = document.element_at(change.begin);
  while (parent && (!encloses(*parent, change) || is_small(*parent))) parent = parent->parent();
  if (!parent || change.begin < parent->tag_span().end) return std::nullopt;
  if (change.end > end_tag_begin(document, *parent)) return std::nullopt;
  const Run run = run_around(document, *parent, change);
  if (run.end - run.begin > 2 * kMaxPartBytes) return std::nullopt;
  Excerpt excerpt;
  excerpt.core_ = {run.first, run.end};
  std::vector<xml::Element> around;
  for (auto each = parent; each; each = each->parent()) around.push_back(*each);
  for (auto each = around.rbegin(); each != around.rend(); ++each)
    excerpt.pieces_.push_back({begin_with_comments(*each), each->tag_span().end});
  excerpt.changed_ = excerpt.pieces_.size();
  excerpt.pieces_.push_back({run.begin, run.end});
  for (const xml::Element each : around)
    excerpt.pieces_.push_back({end_tag_begin(document, each), each.span().end});
  return excerpt;
}

Excerpt Excerpt::after(const TextChange& change) const {
  Excerpt changed = *this;
  const std::uint32_t removed = change.end - change.begin;
  for (std::size_t i = changed_; i < pieces_.size(); ++i) {
    std::uint32_t& end = changed.pieces_[i].end;
    end = end - removed + change.size;
    if (i == changed_) continue;
    std::uint32_t& begin = changed.pieces_[i].begin;
    begin = begin - removed + change.size;
  }
  changed.core_.end = core_.end - removed + change.size;
  return changed;
}

std::string Excerpt::text(std::string_view document) const {
  std::string text;
  for (const Piece& piece : pieces_) text += document.substr(piece.begin, piece.end - piece.begin);
  return text;
}

std::uint32_t Excerpt::begin_in_document(std::uint32_t begin) const {
  for (const Piece& piece : pieces_) {
    if (begin < piece.end - piece.begin) return piece.begin + begin;
    begin -= piece.end - piece.begin;
  }
  return pieces_.back().end;
}

std::uint32_t Excerpt::end_in_document(std::uint32_t end) const {
  for (const Piece& piece : pieces_) {
    if (end <= piece.end - piece.begin) return piece.begin + end;
    end -= piece.end - piece.begin;
  }
  return pieces_.back().end;
}

bool Excerpt::core_has(std::uint32_t begin, std::uint32_t end) const {
  return core_.begin <= begin && end <= core_.end;
}

}  // namespace rigor::lsp
