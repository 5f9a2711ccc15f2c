// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The documents that an editor has open, as it says that they are.
//
//   OpenDocument& document = documents.open(uri, version, text);
//   document.change(range, "1.5");
//   Analysis& read = document.analysis(project);

#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/lsp/document/analysis.h>
#include <rigor/lsp/document/line_index.h>
#include <rigor/lsp/document/moving_place.h>
#include <rigor/rules/environment.h>

namespace rigor::lsp {

struct TextRange {
  TextPosition begin;
  TextPosition end;
};

class OpenDocument {
 public:
  OpenDocument(std::string uri, std::int64_t version, std::string text, PositionEncoding encoding);

  const std::string& uri() const { return uri_; }
  const std::string& path() const { return path_; }
  std::int64_t version() const { return version_; }
  void set_version(std::int64_t version) { version_ = version; }
  const std::string& text() const { return text_; }
  const LineIndex& lines() const { return lines_; }

  /// Puts a text in the place of a range, or of everything; what differs.
  TextChange change(std::optional<TextRange> range, const std::string& text);

  /// Of the text as it is, well-formed or not.
  Analysis& analysis(const Environment& environment);

  /// For answers that nobody wants to wait for: of the text as it is, when that is known already, soon read, or all
  /// there is; else of the last text that could be read to its end, which `prepare` brings up to date when nobody types.
  Analysis& readable(const Environment& environment);

  /// The same of the text as it is wherever that can be read to its end: for answers that are places.
  Analysis& up_to_date(const Environment& environment);

  /// Makes what `readable` gives the text as it is, if that can be read to its end.
  void prepare(const Environment& environment);

  /// The place in the readable text of an offset in the text, and the other way: what both begin and end with
  /// is in the same place, and what is between is its begin.
  std::uint32_t to_readable(std::uint32_t offset) const;
  std::uint32_t from_readable(std::uint32_t offset) const;

  /// Forgets what was read with an environment.
  void forget();

 private:
  void keep_readable();
  /// Whether `readable` gives that of an earlier text.
  bool reads_earlier() const { return readable_ && !is_current_; }
  /// Whether to read it takes longer than a person should wait for an answer.
  bool takes_long() const;

  std::string uri_;
  std::string path_;
  std::int64_t version_;
  PositionEncoding encoding_;
  std::string text_;
  LineIndex lines_;
  std::optional<std::string> readable_text_;  // the last that could be read to its end
  std::unique_ptr<Analysis> analysis_;        // of the text as it is
  std::unique_ptr<Analysis> readable_;        // of `readable_text_`
  bool is_current_ = false;                   // whether `readable` gives that of the text as it is
};

}  // namespace rigor::lsp
