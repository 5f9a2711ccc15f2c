// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Patterns of paths, as .gitignore has them: `*`, `?` and `[a-z]` within a part of a path, `**` over
// parts. What a pattern costs is bounded by its length times the path's, whatever it holds.
//
//   const Glob glob("meshes/**/*.stl");
//   glob.matches("meshes/arm/base.stl");             // all of the path
//
// A list of them that leaves out files is `gitignore.h`'s.

#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// Longer than any path is (PATH_MAX), so a longer pattern is nobody's.
inline constexpr std::size_t kMaxPatternBytes = 4096;

/// A pattern for a whole path, relative and with '/' between its parts. It works on bytes: `?` is one of
/// them. What it means is what git's wildmatch makes of it: `\` takes the next byte as it is, `[!a]` is
/// any byte but that, `[[:digit:]]` a class; none of them, nor `*`, represents a '/'. A `**` that is a
/// whole part of the path represents any number of parts, before a '/' for none as well.
class Glob {
 public:
  explicit Glob(std::string_view pattern);

  /// False when the pattern can match nothing: a `[` without its `]`, a `\` at the end, too long.
  bool usable() const { return usable_; }

  bool matches(std::string_view path) const;

 private:
  enum class Kind : std::uint8_t {
    kByte,
    kAny,      ///< one byte
    kSet,      ///< one byte of a set
    kStar,     ///< any number of bytes within a part
    kFolders,  ///< begins `**/`: nothing, or what kWithin takes
    kWithin,   ///< any number of bytes, and a '/'
    kRest,     ///< any number of bytes
  };
  struct Token {
    Kind kind = Kind::kByte;
    char byte = 0;
    std::uint32_t set = 0;  ///< index of kSet
  };
  using Set = std::bitset<256>;

  void add_stars(std::string_view pattern, std::size_t& at);
  void add_set(std::string_view pattern, std::size_t& at);
  bool takes(const Token& token, char byte) const;
  void skip(std::string& reached) const;

  std::vector<Token> tokens_;
  std::vector<Set> sets_;
  std::size_t literal_ = 0;  ///< tokens that a path must begin with byte by byte
  bool usable_ = true;
};

}  // namespace rigor
