// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/turns.h>

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace rigor {
namespace {

TEST(Turns, NoMoreWorkThanThereAre) {
  Turns turns(3);
  std::atomic<int> working{0};
  std::atomic<int> most{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < 16; ++i) {
    threads.emplace_back([&] {
      for (int k = 0; k < 100; ++k) {
        turns.take();
        const int now = ++working;
        for (int seen = most; seen < now && !most.compare_exchange_weak(seen, now);) continue;
        --working;
        turns.give_back();
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_LE(most, 3);
  EXPECT_EQ(working, 0);
}

/// With one turn, the second thread gets one only because the first waits for the mutex.
TEST(Turns, WhoWaitsForAMutexLetsAnotherWork) {
  Turns turns(1);
  std::mutex mutex;
  std::unique_lock held(mutex);
  std::atomic<bool> first_has_turn{false};
  bool second_worked = false;
  bool first_saw_it = false;
  std::thread first([&] {
    turns.take();
    first_has_turn = true;
    const std::unique_lock lock = turns.lock(mutex);
    first_saw_it = second_worked;
    turns.give_back();
  });
  while (!first_has_turn) std::this_thread::yield();
  std::thread second([&] {
    turns.take();
    second_worked = true;
    turns.give_back();
  });
  second.join();
  held.unlock();
  first.join();
  EXPECT_TRUE(first_saw_it);
}

TEST(Turns, ZeroIsOneForEachCore) {
  EXPECT_EQ(Turns(0).count(), std::max(1U, std::thread::hardware_concurrency()));
}

}  // namespace
}  // namespace rigor
