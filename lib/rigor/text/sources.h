// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Owns the bytes of every file of a run, so that spans stay small and views stay valid.
//
// A source never changes and never moves once added: a string_view into it lives as long as the
// `Sources`. Adding and reading are safe from several threads at once.
//
//   Sources sources;
//   SourceId id = sources.add("robot.sdf", bytes);
//   std::string_view all = sources.bytes(id);

#pragma once

#include <deque>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/text/span.h>

namespace rigor {

class Sources {
 public:
  /// Takes `bytes` (less than 4 GiB) under the name that messages show: the path as the user wrote
  /// it, or `<stdin>`.
  SourceId add(std::string path, std::string bytes);

  std::string_view path(SourceId id) const;
  std::string_view bytes(SourceId id) const;
  std::string_view bytes(Span span) const;  ///< empty for a span that stands nowhere

  std::size_t total_bytes() const;  ///< of all of them

  /// Line and column of a byte offset. A byte-order mark has no column. Linear in the offset: when
  /// many positions of one source are wanted, make one `LineTable`.
  Position position(SourceId id, std::uint32_t offset) const;

 private:
  struct Source {
    std::string path;
    std::string bytes;
  };
  const Source& at(SourceId id) const;

  mutable std::mutex mutex_;
  std::deque<Source> sources_;
};

/// The starts of a text's lines. A line ends with LF, CRLF or a lone CR, as editors see it.
class LineTable {
 public:
  explicit LineTable(std::string_view bytes);

  Position position(std::uint32_t offset) const;
  std::uint32_t line_count() const { return static_cast<std::uint32_t>(starts_.size()); }

  /// The text of a 1-based line without its ending. Lines past the end are empty.
  std::string_view line(std::uint32_t number) const;

 private:
  std::string_view bytes_;
  std::vector<std::uint32_t> starts_;
};

/// Number of code points in valid UTF-8; each byte that is not part of valid UTF-8 counts as one.
std::uint32_t count_code_points(std::string_view utf8);

}  // namespace rigor
