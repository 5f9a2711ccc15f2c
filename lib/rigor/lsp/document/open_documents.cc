// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/document/open_documents.h>

#include <algorithm>
#include <utility>

#include <rigor/lsp/protocol/uri.h>
#include <rigor/read/template/template_expander.h>

namespace rigor::lsp {
namespace {

/// A text of this size is read in 3 ms; what a template expands to may be any number of times as long.
constexpr std::size_t kReadAtOnceBytes = std::size_t{64} << 10U;

/// Bytes that two texts begin and end with; they do not overlap in either.
struct Affixes {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

Affixes common_affixes(std::string_view a, std::string_view b) {
  const std::size_t shorter = std::min(a.size(), b.size());
  const auto begin = static_cast<std::size_t>(
      std::mismatch(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(shorter), b.begin()).first -
      a.begin());
  std::size_t end = 0;
  while (end < shorter - begin && a[a.size() - 1 - end] == b[b.size() - 1 - end]) ++end;
  // A new line before "  <link" may as well be one behind "  <": whole lines are what people insert.
  std::size_t line = begin;
  std::size_t rest = end;
  while (line > 0 && a[line - 1] != '\n' && rest < shorter &&
         a[a.size() - 1 - rest] == b[b.size() - 1 - rest]) {
    --line;
    ++rest;
  }
  const bool at_line = line == 0 || a[line - 1] == '\n';
  return at_line ? Affixes{static_cast<std::uint32_t>(line), static_cast<std::uint32_t>(rest)}
                 : Affixes{static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

/// An offset of one text in another that begins and ends like it.
std::uint32_t moved(std::uint32_t offset, std::string_view from, std::string_view to) {
  const Affixes same = common_affixes(from, to);
  if (offset <= same.begin) return offset;
  if (offset >= from.size() - same.end)
    return static_cast<std::uint32_t>(offset + to.size() - from.size());
  return same.begin;
}

}  // namespace

OpenDocument::OpenDocument(std::string uri, std::int64_t version, std::string text,
                           PositionEncoding encoding)
    : uri_(std::move(uri)),
      path_(path_of_uri(uri_)),
      version_(version),
      encoding_(encoding),
      text_(std::move(text)),
      lines_(text_, encoding) {}

void OpenDocument::keep_readable() {
  if (!analysis_ || !analysis_->written().complete()) return;
  if (readable_ && takes_long() && !is_current_) return;  // it knows more than the tags
  readable_ = std::move(analysis_);
  readable_text_ = std::string(readable_->text());
}

TextChange OpenDocument::change(std::optional<TextRange> range, const std::string& text) {
  keep_readable();
  analysis_.reset();
  is_current_ = false;
  TextChange change{0, static_cast<std::uint32_t>(text_.size()),
                    static_cast<std::uint32_t>(text.size())};
  if (range) {
    change.begin = lines_.offset(range->begin);
    change.end = std::max(change.begin, lines_.offset(range->end));
    text_.replace(change.begin, change.end - change.begin, text);
  } else {
    const Affixes same = common_affixes(text_, text);
    change = {same.begin, change.end - same.end, change.size - same.begin - same.end};
    text_ = text;
  }
  lines_ = LineIndex(text_, encoding_);
  return change;
}

Analysis& OpenDocument::analysis(const Environment& environment) {
  if (!analysis_) analysis_ = std::make_unique<Analysis>(environment, path_, text_);
  return *analysis_;
}

bool OpenDocument::takes_long() const {
  return text_.size() > kReadAtOnceBytes || read::is_template(path_);
}

Analysis& OpenDocument::readable(const Environment& environment) {
  if (readable_ && takes_long() && !is_current_) return *readable_;
  return up_to_date(environment);
}

Analysis& OpenDocument::up_to_date(const Environment& environment) {
  Analysis& current = analysis(environment);
  is_current_ = current.written().complete();
  if (is_current_ || !readable_text_) return current;
  if (!readable_) readable_ = std::make_unique<Analysis>(environment, path_, *readable_text_);
  return *readable_;
}

void OpenDocument::prepare(const Environment& environment) {
  Analysis& current = analysis(environment);
  if (!current.written().complete()) return;
  readable_.reset();
  is_current_ = true;
  current.loaded();
  current.frames();
  current.names().uses(path_);
}

std::uint32_t OpenDocument::to_readable(std::uint32_t offset) const {
  return reads_earlier() ? moved(offset, text_, *readable_text_) : offset;
}

std::uint32_t OpenDocument::from_readable(std::uint32_t offset) const {
  return reads_earlier() ? moved(offset, *readable_text_, text_) : offset;
}

void OpenDocument::forget() {
  keep_readable();
  analysis_.reset();
  readable_.reset();
  is_current_ = false;
}

}  // namespace rigor::lsp
