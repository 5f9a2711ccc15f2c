// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A test over hundreds of files or programs takes a part of them where RIGOR_TEST_PART=N is set, as with
// sanitizers: one in N, the same ones each time. The tests of files that include this run over all of
// them in what is released.
//
//   for (const std::string& path : test::corpus_part()) {
//     …
//   }
//   EXPECT_GT(looked_at, test::part_of(700));

#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "support/corpus.h"

namespace rigor::test {

inline std::size_t parts() {
  const char* number = std::getenv("RIGOR_TEST_PART");
  const int parts = number == nullptr ? 1 : std::atoi(number);
  return parts < 1 ? 1 : static_cast<std::size_t>(parts);
}

/// By the FNV-1a digest of its name's end, which is the same wherever the corpus lies.
inline bool in_part(std::string_view name) {
  constexpr std::size_t kEnd = 40;
  if (name.size() > kEnd) name.remove_prefix(name.size() - kEnd);
  std::uint32_t digest = 2166136261U;
  for (const char c : name) digest = (digest ^ static_cast<unsigned char>(c)) * 16777619U;
  return (digest >> 8U) % parts() == 0;
}

/// At least so many of `count` are in the part: half of what is to be expected.
inline std::size_t part_of(std::size_t count) {
  return parts() == 1 ? count : count / (2 * parts());
}

/// The part of corpus_models().
inline std::vector<std::string> corpus_part() {
  std::vector<std::string> paths = corpus_models();
  std::erase_if(paths, [](const std::string& path) { return !in_part(path); });
  return paths;
}

}  // namespace rigor::test
