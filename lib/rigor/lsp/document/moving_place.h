// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Places of an earlier text in the text that it became.
//
//   MovingPlace place{begin, end, link_begin, link_end};
//   for (const TextChange& change : changes) if (!place.follow(change)) forget(place);

#pragma once

#include <cstdint>

namespace rigor::lsp {

/// Bytes from `begin` to `end` became `size` others.
struct TextChange {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  std::uint32_t size = 0;
};

struct MovingPlace {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  /// What is said of the place holds as long as these bytes are as they were.
  std::uint32_t guard_begin = 0;
  std::uint32_t guard_end = 0;

  /// False when a guarded byte has changed. Bytes that are only next to the guarded ones may.
  bool follow(const TextChange& change) {
    if (change.begin >= guard_end) return true;
    if (change.end > guard_begin) return false;
    const std::uint32_t removed = change.end - change.begin;
    for (std::uint32_t* offset : {&begin, &end, &guard_begin, &guard_end})
      *offset = *offset - removed + change.size;
    return true;
  }
};

}  // namespace rigor::lsp
