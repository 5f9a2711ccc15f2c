// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A file's markup as a gapless row of tokens: joined, their spans are the file, byte for byte.

#pragma once

#include <cstdint>

namespace rigor::xml {

enum class TokenKind : std::uint8_t {
  kText,
  kCData,
  kStartTag,  ///< `<a b="c">`
  kEmptyTag,  ///< `<a b="c"/>`
  kEndTag,
  kComment,
  kDeclaration,  ///< `<?xml …?>`
  kInstruction,  ///< `<?other …?>`
  kDoctype,
  kByteOrderMark,
  kUnread,  ///< the rest of a file after a fatal fault
};

struct Token {
  TokenKind kind;
  std::uint32_t begin;
  std::uint32_t end;
};

}  // namespace rigor::xml
