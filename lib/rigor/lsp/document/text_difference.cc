// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/document/text_difference.h>

#include <algorithm>
#include <cstring>

namespace rigor::lsp {
namespace {

/// Compared at once: memcmp is many times as fast as a loop over bytes.
constexpr std::size_t kBlockBytes = 4096;

bool equal(const char* a, const char* b, std::size_t size) { return std::memcmp(a, b, size) == 0; }

}  // namespace

TextChange difference(std::string_view before, std::string_view after) {
  const std::size_t shorter = std::min(before.size(), after.size());
  std::size_t begin = 0;
  while (shorter - begin >= kBlockBytes &&
         equal(before.data() + begin, after.data() + begin, kBlockBytes)) {
    begin += kBlockBytes;
  }
  while (begin < shorter && before[begin] == after[begin]) ++begin;
  const char* const before_end = before.data() + before.size();
  const char* const after_end = after.data() + after.size();
  std::size_t same = 0;
  while (shorter - begin - same >= kBlockBytes &&
         equal(before_end - same - kBlockBytes, after_end - same - kBlockBytes, kBlockBytes)) {
    same += kBlockBytes;
  }
  while (same < shorter - begin && *(before_end - same - 1) == *(after_end - same - 1)) ++same;
  return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(before.size() - same),
          static_cast<std::uint32_t>(after.size() - same - begin)};
}

}  // namespace rigor::lsp
