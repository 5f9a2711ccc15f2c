// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where something stands: a range of bytes in one source.
//
// Bytes are the truth. A span is twelve bytes, copied freely, and names its own source because a
// model is usually read from several files. Line and column are computed when somebody asks
// (see sources.h), never stored.
//
//   Span s{source, 10, 14};
//   sources.bytes(s);              // the four bytes
//   sources.position(s.source, s.begin);  // line 2, column 3

#pragma once

#include <cstdint>

namespace rigor {

/// Index of a file's bytes in `Sources`.
enum class SourceId : std::uint32_t {};

/// The source of a span that stands nowhere, such as that of a default.
inline constexpr SourceId kNoSource{0xffffffffU};

/// Half-open range of byte offsets. 32 bits each: sources over 4 GiB are refused when they are read.
struct Span {
  SourceId source = kNoSource;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;

  bool operator==(const Span&) const = default;
  std::uint32_t size() const { return end - begin; }
  bool nowhere() const { return source == kNoSource; }
};

/// 1-based; columns count code points. Byte 0 of any source is line 1, column 1.
struct Position {
  std::uint32_t line = 1;
  std::uint32_t column = 1;

  bool operator==(const Position&) const = default;
};

}  // namespace rigor
