// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Rows found by a text, in one flat table: names and expressions are looked for all the time, and are short.

#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

namespace rigor::xacro {

inline std::uint32_t short_hash(std::string_view text) {
  // Eight bytes at a time, multiplied by an odd number whose bits are without a pattern.
  constexpr std::uint64_t kMultiplier = 0x9e3779b97f4a7c15U;
  const auto word_at = [&text](std::size_t at) {
    std::uint64_t word = 0;
    std::memcpy(&word, text.data() + at, sizeof word);
    return word;
  };
  std::uint64_t hash = text.size();
  const auto mix = [&hash](std::uint64_t word) {
    hash = (hash ^ word) * kMultiplier;
    hash ^= hash >> 32U;
  };
  if (text.size() >= 8) {
    for (std::size_t at = 0; at + 8 < text.size(); at += 8) mix(word_at(at));
    mix(word_at(text.size() - 8));
  } else {
    std::uint64_t word = 0;
    for (const char c : text) word = word << 8U | static_cast<unsigned char>(c);
    mix(word);
  }
  return static_cast<std::uint32_t>(hash);
}

class TextIndex {
 public:
  static constexpr std::uint32_t kNoRow = 0xffffffffU;

  /// The row that was added with this hash and that `is_same` accepts; kNoRow where there is none.
  template <class IsSame>
  std::uint32_t find(std::uint32_t hash, IsSame is_same) const {
    const std::size_t last = slots_.size() - 1;
    for (std::size_t slot = hash & last; slots_[slot].row != kNoRow; slot = (slot + 1) & last) {
      if (slots_[slot].hash == hash && is_same(slots_[slot].row)) return slots_[slot].row;
    }
    return kNoRow;
  }

  void add(std::uint32_t hash, std::uint32_t row) {
    if (2 * ++count_ > slots_.size()) grow();
    place({hash, row});
  }

 private:
  struct Slot {
    std::uint32_t hash = 0;
    std::uint32_t row = kNoRow;
  };

  void place(Slot added) {
    const std::size_t last = slots_.size() - 1;
    std::size_t slot = added.hash & last;
    while (slots_[slot].row != kNoRow) slot = (slot + 1) & last;
    slots_[slot] = added;
  }
  void grow() {
    std::vector<Slot> before(2 * slots_.size());
    before.swap(slots_);
    for (const Slot& slot : before) {
      if (slot.row != kNoRow) place(slot);
    }
  }

  static constexpr std::size_t kFirstSlots = 128;
  std::vector<Slot> slots_ = std::vector<Slot>(kFirstSlots);  ///< a power of two, at most half full
  std::size_t count_ = 0;
};

}  // namespace rigor::xacro
