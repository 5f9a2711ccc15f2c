// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/document/open_documents.h>

#include <algorithm>
#include <utility>

#include <rigor/lsp/protocol/uri.h>

namespace rigor::lsp {
namespace {

/// An offset of one text in another that begins and ends like it.
std::uint32_t moved(std::uint32_t offset, std::string_view from, std::string_view to) {
  const std::size_t shorter = std::min(from.size(), to.size());
  const auto begin = static_cast<std::size_t>(
      std::mismatch(from.begin(), from.begin() + static_cast<std::ptrdiff_t>(shorter), to.begin())
          .first -
      from.begin());
  if (offset <= begin) return offset;
  std::size_t end = 0;
  while (end < shorter - begin && from[from.size() - 1 - end] == to[to.size() - 1 - end]) ++end;
  if (offset >= from.size() - end)
    return static_cast<std::uint32_t>(offset + to.size() - from.size());
  return static_cast<std::uint32_t>(begin);
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

void OpenDocument::note_readable() {
  if (!analysis_ || !analysis_->written().complete()) return;
  readable_text_ = text_;
  has_readable_ = true;
  readable_.reset();
}

void OpenDocument::change(std::optional<TextRange> range, const std::string& text) {
  note_readable();
  analysis_.reset();
  if (range) {
    const std::uint32_t begin = lines_.offset(range->begin);
    const std::uint32_t end = std::max(begin, lines_.offset(range->end));
    text_.replace(begin, end - begin, text);
  } else {
    text_ = text;
  }
  lines_ = LineIndex(text_, encoding_);
}

Analysis& OpenDocument::analysis(const Environment& environment) {
  if (!analysis_) analysis_ = std::make_unique<Analysis>(environment, path_, text_);
  return *analysis_;
}

Analysis& OpenDocument::readable(const Environment& environment) {
  Analysis& current = analysis(environment);
  if (current.written().complete() || !has_readable_) return current;
  if (!readable_) readable_ = std::make_unique<Analysis>(environment, path_, readable_text_);
  return *readable_;
}

std::uint32_t OpenDocument::to_readable(std::uint32_t offset) const {
  return readable_ ? moved(offset, text_, readable_text_) : offset;
}

std::uint32_t OpenDocument::from_readable(std::uint32_t offset) const {
  return readable_ ? moved(offset, readable_text_, text_) : offset;
}

void OpenDocument::forget() {
  note_readable();
  analysis_.reset();
  readable_.reset();
}

}  // namespace rigor::lsp
