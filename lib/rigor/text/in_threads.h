// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Several threads for one piece of work, or fewer when the system gives no more of them.
//
//   std::atomic<std::size_t> next{0};
//   in_threads(8, [&](std::size_t) {
//     for (std::size_t i = next++; i < rows; i = next++) draw(i);
//   });

#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace rigor {

/// Calls `work` with the numbers below `count`, each in a thread of its own at the same time; 0 is the
/// calling thread's. Number 0 is always called, others only so far as there can be threads: each call has
/// to go on until nothing is left to do. Throws what a call threw, when all have ended.
template <class Work>
void in_threads(std::size_t count, const Work& work) {
  std::exception_ptr failure;
  std::mutex mutex;
  const auto run = [&](std::size_t number) {
    try {
      work(number);
    } catch (...) {
      const std::lock_guard lock(mutex);
      failure = std::current_exception();
    }
  };
  std::atomic<std::size_t> kept{0};  // how many are to work, once it is known how many there are
  std::atomic<bool> begun{false};
  const auto help = [&](std::size_t number) {
    kept.wait(0);
    if (number >= kept) return;
    begun.wait(false);
    run(number);
  };
  std::vector<std::thread> others;
  bool all = true;
  try {
    for (std::size_t number = 1; number < count; ++number) others.emplace_back(help, number);
  } catch (const std::exception&) {
    all = false;
  }
  // Where memory for one more stack was lacking, none is left to work with: half of them go first.
  kept = 1 + (all ? others.size() : others.size() / 2);
  kept.notify_all();
  for (; others.size() >= kept; others.pop_back()) others.back().join();
  begun = true;
  begun.notify_all();
  run(0);
  for (std::thread& other : others) other.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace rigor
