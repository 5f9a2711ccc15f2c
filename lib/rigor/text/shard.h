// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which part of a long list of work is this run's: `--shard 2/5`. By a hash of each item's name, so that
// an item stays where it is when others come or go.
//
//   if (auto shard = parse_shard("2/5"); shard && shard->has("models/arm.sdf")) check(…);

#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace rigor {

struct Shard {
  unsigned index = 1;  ///< from 1
  unsigned of = 1;

  bool has(std::string_view name) const;
};

/// Runs are not divided further: nobody has as many machines.
inline constexpr unsigned kMaxShards = 10'000;

/// "2/5"; nothing when the text is something else, or 6/5.
std::optional<Shard> parse_shard(std::string_view text);

}  // namespace rigor
