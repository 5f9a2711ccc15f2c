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

  /// Puts a text in the place of a range, or of everything.
  void change(std::optional<TextRange> range, const std::string& text);

  /// Of the text as it is, well-formed or not.
  Analysis& analysis(const Environment& environment);

  /// Of the last text that could be read to its end; of the text as it is, when none could.
  Analysis& readable(const Environment& environment);

  /// The place in the readable text of an offset in the text, and the other way: what both begin and end with
  /// is in the same place, and what is between is its begin.
  std::uint32_t to_readable(std::uint32_t offset) const;
  std::uint32_t from_readable(std::uint32_t offset) const;

  /// Forgets what was read with an environment.
  void forget();

 private:
  void note_readable();

  std::string uri_;
  std::string path_;
  std::int64_t version_;
  PositionEncoding encoding_;
  std::string text_;
  LineIndex lines_;
  std::string readable_text_;  // empty where it is the text, or nothing could be read yet
  bool has_readable_ = false;
  std::unique_ptr<Analysis> analysis_;
  std::unique_ptr<Analysis> readable_;  // of `readable_text_`
};

}  // namespace rigor::lsp
