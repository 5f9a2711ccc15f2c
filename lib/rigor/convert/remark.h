// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A comment of the source on a part of the result: a link, a joint, an inertial, a visual, a collision.

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rigor::convert {

struct Remark {
  std::string text;  ///< what stands between `<!--` and `-->`
  /// Elements inside the part, by their names in the result: it stands before the first of them that is
  /// there, else before the part.
  std::vector<std::string> places = {};

  bool operator==(const Remark&) const = default;
};

/// The place before the part's end tag.
inline constexpr std::string_view kAtEnd = "/";

using Remarks = std::vector<Remark>;

inline bool is_at_end(const Remark& remark) {
  return !remark.places.empty() && remark.places.front() == kAtEnd;
}

}  // namespace rigor::convert
