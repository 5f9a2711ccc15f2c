// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The same work for many things, by several threads. Results go where each index has a place of its own, so
// that they do not depend on who did what.
//
//   Turns turns(threads);
//   for_each_index(files.size(), turns, 4, [&](std::size_t i) { facts[i] = read(files[i]); });

#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <vector>

#include <rigor/text/in_threads.h>
#include <rigor/text/turns.h>

namespace rigor {

/// Calls `work` with each index below `count`, in as many threads at the same time as there are turns at
/// most, and one for each `per_thread` things: fewer are not worth a thread. As many again stand ready for
/// turns that are given back. Each thread begins in a part of its own, then helps in the others: neighbors
/// use the same meshes, and two threads at one mesh would wait for each other. Where the system gives fewer
/// threads, those there are do all. Throws what a `work` threw, when all have ended.
template <class Work>
void for_each_index(std::size_t count, Turns& turns, std::size_t per_thread, const Work& work) {
  const std::size_t working = std::clamp<std::size_t>(count / per_thread, 1, turns.count());
  const std::size_t parts = working == 1 ? 1 : 2 * working;
  const auto begin_of = [&](std::size_t part) { return count * part / parts; };
  std::vector<std::atomic<std::size_t>> next(parts);
  for (std::size_t part = 0; part < parts; ++part) next[part] = begin_of(part);
  std::exception_ptr failure;
  std::mutex mutex;
  const auto run = [&](std::size_t own) {
    turns.take();
    for (std::size_t k = 0; k < parts; ++k) {
      const std::size_t part = (own + k) % parts;
      for (std::size_t i = next[part]++; i < begin_of(part + 1); i = next[part]++) {
        try {
          work(i);
        } catch (...) {
          const std::lock_guard lock(mutex);
          failure = std::current_exception();
        }
      }
    }
    turns.give_back();
  };
  in_threads(parts, run);
  if (failure) std::rethrow_exception(failure);
}

}  // namespace rigor
