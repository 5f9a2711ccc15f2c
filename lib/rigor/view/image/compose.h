// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures put together: side by side with captions, and what differs between
// two.
//
//   const Picture review = sheet({{before, "before"}, {after, "after"},
//   {difference(before, after), ""}}, 3);

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <rigor/view/image/picture.h>

namespace rigor::view {

struct Tile {
  Picture picture;
  std::string caption;  ///< what is no ASCII shows as '?'; empty for none
};

/// In rows of `columns`, each place as large as the largest picture, on white;
/// a line of captions below each row that has one. Empty when it would be over
/// kMaxPixels.
Picture sheet(const std::vector<Tile>& tiles, std::size_t columns);

/// So many that the sheet of `count` tiles of this shape is about as wide as it
/// is high.
std::size_t columns_for(std::size_t count, std::uint32_t width, std::uint32_t height);

/// Two pictures of each of two drawings: in color, and with all surfaces gray, which shows shapes alone.
struct Compared {
  const Picture& before;
  const Picture& after;
  const Picture& gray_before;
  const Picture& gray_after;
};

/// Where the shapes differ, red; where only the colors do, blue; the rest pale and gray. Of different sizes: what
/// only one has differs.
Picture difference(const Compared& pictures);

/// How many pixels differ visibly.
std::size_t count_differences(const Picture& before, const Picture& after);

}  // namespace rigor::view
