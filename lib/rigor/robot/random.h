// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers that look random and are the same for a seed on every machine: SplitMix64 (Steele, Lea and Flood 2014).
//
//   Random random(seed);
//   const double q = random.between(axis.lower, axis.upper);

#pragma once

#include <cstdint>

namespace rigor::robot {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }

  /// Uniform from `low` up to `high`.
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(next() >> 11U) * 0x1p-53);
  }

 private:
  std::uint64_t state_;
};

}  // namespace rigor::robot
