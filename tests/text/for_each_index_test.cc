// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/for_each_index.h>

#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace rigor {
namespace {

TEST(ForEachIndex, CallsWithEachOnceForAnyNumberOfThreads) {
  for (const unsigned threads : {0U, 1U, 3U, 64U}) {
    for (const std::size_t count : {0U, 1U, 7U, 100U}) {
      std::vector<int> calls(count, 0);
      Turns turns(threads);
      for_each_index(count, turns, 2, [&](std::size_t i) { ++calls[i]; });
      EXPECT_EQ(calls, std::vector<int>(count, 1)) << threads;
    }
  }
}

TEST(ForEachIndex, TheOthersAreDoneWhenOneThrows) {
  std::vector<int> calls(50, 0);
  const auto work = [&](std::size_t i) {
    ++calls[i];
    if (i == 7) throw std::runtime_error("seven");
  };
  Turns turns(4);
  EXPECT_THROW(for_each_index(calls.size(), turns, 1, work), std::runtime_error);
  EXPECT_EQ(calls, std::vector<int>(50, 1));
}

}  // namespace
}  // namespace rigor
