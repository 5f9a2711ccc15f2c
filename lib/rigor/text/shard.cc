// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/shard.h>

#include <charconv>

#include <rigor/text/digest.h>

namespace rigor {

bool Shard::has(std::string_view name) const {
  if (of == 1) return true;
  const Digest digest = digest_of(name);
  std::uint64_t hash = 0;
  for (std::size_t i = 0; i < sizeof hash; ++i) hash = hash << 8U | digest[i];
  return hash % of == index - 1;
}

std::optional<Shard> parse_shard(std::string_view text) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto index = std::from_chars(text.data(), end, shard.index);
  if (index.ec != std::errc() || index.ptr == end || *index.ptr != '/') return std::nullopt;
  const auto of = std::from_chars(index.ptr + 1, end, shard.of);
  if (of.ec != std::errc() || of.ptr != end) return std::nullopt;
  if (shard.of == 0 || shard.of > kMaxShards) return std::nullopt;
  if (shard.index == 0 || shard.index > shard.of) return std::nullopt;
  return shard;
}

}  // namespace rigor
