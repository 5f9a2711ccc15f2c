// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Typed indices into the vectors of a `Root`: an `Id<Link>` cannot index joints.

#pragma once

#include <compare>
#include <cstdint>

namespace rigor::model {

template <class T>
struct Id {
  static constexpr std::uint32_t kNone = 0xffffffffU;
  std::uint32_t value = kNone;

  explicit operator bool() const { return value != kNone; }
  auto operator<=>(const Id&) const = default;
};

/// Of what will be added to the list next.
template <class List>
Id<typename List::value_type> next_id(const List& list) {
  return {static_cast<std::uint32_t>(list.size())};
}

}  // namespace rigor::model
