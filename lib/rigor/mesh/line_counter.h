// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The lines of places in a text that is read from front to back, each byte examined once, however
// many places there are.
//
//   LineCounter lines(bytes);
//   use(lines.at(cursor.offset()));

#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include <rigor/mesh/text_cursor.h>

namespace rigor::mesh {

class LineCounter {
 public:
  explicit LineCounter(std::string_view bytes) : bytes_(bytes) {}

  /// 1-based. No offset may be before the last one.
  std::uint64_t at(std::size_t offset) {
    line_ += line_at(bytes_.substr(counted_), offset - counted_) - 1;
    counted_ = offset;
    return line_;
  }

 private:
  std::string_view bytes_;
  std::size_t counted_ = 0;
  std::uint64_t line_ = 1;
};

}  // namespace rigor::mesh
