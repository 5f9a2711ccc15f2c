// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is wrong with a file as XML, as data. A rule turns each kind into words.
//
// `fatal()` faults end the reading: what follows them cannot be told. The others are kept beside a
// complete document.

#pragma once

#include <cstdint>
#include <string>

#include <rigor/text/span.h>

namespace rigor::xml {

enum class FaultKind : std::uint8_t {
  // Fatal: structure is lost from here on.
  kEmpty,               ///< no element at all
  kUtf16,               ///< UTF-16 or UTF-32 by its byte-order mark or its zero bytes
  kBadTag,              ///< `<` that starts no tag; `where` is the `<`
  kBadAttribute,        ///< name without `="value"`; `where` is the name
  kUnclosedValue,       ///< quote that never ends; `where` is the quote
  kUnclosedTag,         ///< tag without `>`; `where` is `<name`
  kUnclosedMarkup,      ///< comment, CDATA or instruction that never ends; `where` is its start
  kMismatchedEnd,       ///< `where` is the end tag, `related` the start tag it should close
  kUnexpectedEnd,       ///< end tag with nothing open
  kUnclosedElement,     ///< file ends inside an element; `related` is its start tag
  kTooDeep,             ///< nested past kMaxDepth
  kTooMany,             ///< more attributes in a tag, or elements in a file, than any model has
  kDuplicateAttribute,  ///< `where` the second name, `related` the first
  kRefused,             ///< tinyxml2 refuses the file although the scanner did not; see `detail`
  // Not fatal: consumers read on, a strict parser does not.
  kDeclarationNotFirst,  ///< `<?xml …?>` behind white space; behind more, tinyxml2 refuses it
  kBadDeclaration,       ///< `detail` says what is wrong, as the end of a sentence
  kSecondRoot,           ///< `related` is the first root's name
  kTextOutsideRoot,      ///< characters before or after the root element
  kUndefinedEntity,      ///< `&name;` that is none of XML's five; a lone `&`
  kNotUtf8,              ///< byte that is not part of UTF-8
  kControlCharacter,     ///< U+0000 to U+001F but tab, LF, CR
  kUnboundPrefix,        ///< `detail` is the prefix; reported once each
  kDoctype,              ///< `<!DOCTYPE …>`: its entities are never expanded
  kHyphensInComment,     ///< `--` inside a comment
  kAngleInValue,         ///< `<` inside an attribute value
  kNoSpaceBetween,       ///< attributes that touch
};

constexpr bool is_fatal(FaultKind kind) { return kind <= FaultKind::kRefused; }

struct Fault {
  FaultKind kind;
  Span where;
  Span related;
  std::string detail;
  /// How many of this kind the file has, on the first one when only the first few were kept.
  std::uint32_t count = 1;
};

/// Elements may nest this deep: tinyxml2 9.0, which libsdformat, Gazebo and urdfdom read with,
/// refuses a file at its 100th level.
inline constexpr int kMaxDepth = 99;

/// A tag may have this many attributes: finding one twice takes their square, here and in tinyxml2.
/// The most any known format defines is 13.
inline constexpr std::uint32_t kMaxAttributes = 256;

/// A file may have this many elements, some 300 bytes of memory each. A world of 3,000 models has
/// 80,000.
inline constexpr std::uint32_t kMaxElements = 2'000'000;

/// Of one kind this many faults are kept and the rest counted, so that a hostile file cannot turn
/// each of its bytes into a message.
inline constexpr std::uint32_t kMaxFaultsOfKind = 20;

/// How many faults of a kind are kept. Of bad characters one: a file that has one has thousands.
constexpr std::uint32_t max_kept(FaultKind kind) {
  const bool character = kind == FaultKind::kControlCharacter || kind == FaultKind::kNotUtf8;
  return character ? 1 : kMaxFaultsOfKind;
}

}  // namespace rigor::xml
