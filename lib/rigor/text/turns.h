// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How many threads work at the same time. There may be more threads than turns: one that waits for what
// another finds gives its turn to a third, so that no core is idle for it.
//
//   Turns turns(2);
//   for_each_index(files.size(), turns, 4, [&](std::size_t i) {
//     const auto lock = turns.lock(mutex);  // whoever has to wait for it lets others work
//     ...
//   });

#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

namespace rigor {

class Turns {
 public:
  /// So many at the same time; 0: as many as there are cores.
  explicit Turns(unsigned count)
      : count_(count > 0 ? count : std::max(1U, std::thread::hardware_concurrency())),
        given_(count_) {}

  unsigned count() const { return count_; }

  /// Waits for a turn, behind those who wait already.
  void take() {
    std::unique_lock lock(mutex_);
    const std::uint64_t ticket = taken_++;
    changed_.wait(lock, [&] { return ticket < given_; });
  }

  void give_back() {
    {
      const std::lock_guard lock(mutex_);
      ++given_;
    }
    changed_.notify_all();
  }

  /// Locks `mutex`, of somebody who has a turn and has one again afterwards. Nobody waits for a turn with the
  /// mutex locked.
  std::unique_lock<std::mutex> lock(std::mutex& mutex) {
    std::unique_lock lock(mutex, std::try_to_lock);
    while (!lock) {
      give_back();
      { const std::lock_guard other_is_done(mutex); }
      take();
      lock = std::unique_lock(mutex, std::try_to_lock);
    }
    return lock;
  }

 private:
  unsigned count_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t taken_ = 0;
  std::uint64_t given_;  // turns so far: those of tickets below it
};

}  // namespace rigor
