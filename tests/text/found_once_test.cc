// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/found_once.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace rigor {
namespace {

TEST(FoundOnce, IsMadeByOneAndSeenByAll) {
  FoundOnce<int, int> known;
  std::atomic<int> made{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < 64; ++i) {
    threads.emplace_back([&known, &made, i] {
      const int key = i % 4;
      EXPECT_EQ(known.find(key,
                           [&] {
                             ++made;
                             return key * key;
                           }),
                key * key);
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(made, 4);
}

TEST(FoundOnce, StaysWhereItIsAndMayAskForOthers) {
  FoundOnce<int, int> known;
  const int& one = known.find(1, [&] { return known.find(2, [] { return 2; }) - 1; });
  for (int i = 3; i < 100; ++i) known.find(i, [i] { return i; });
  EXPECT_EQ(&known.find(1, [] { return 0; }), &one);
  EXPECT_EQ(one, 1);
}

TEST(FoundOnce, AFailureIsNotKept) {
  FoundOnce<int, int> known;
  EXPECT_THROW(known.find(1, []() -> int { throw std::runtime_error("no"); }), std::runtime_error);
  EXPECT_EQ(known.find(1, [] { return 7; }), 7);
}

}  // namespace
}  // namespace rigor
