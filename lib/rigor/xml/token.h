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

/// What is among the bytes of a text or an attribute's value, noted as they are scanned.
enum ContentByte : std::uint8_t {
  kCodeByte = 1,    ///< `&` or a carriage return, for which a value is decoded
  kLineByte = 2,    ///< a line feed or a tab, which XML 1.0 makes a blank of in an attribute
  kDollarByte = 4,  ///< `$`
  kMarkByte = 8,    ///< of a text: anything but white space
};

struct Token {
  TokenKind kind;
  std::uint8_t content = 0;  ///< of a text: `ContentByte`s
  std::uint32_t begin;
  std::uint32_t end;
};

}  // namespace rigor::xml
