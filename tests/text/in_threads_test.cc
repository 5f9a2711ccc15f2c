// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/in_threads.h>

#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace rigor {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kReservesTerabytes = true;
#elif defined(__has_feature)
constexpr bool kReservesTerabytes =
    __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
constexpr bool kReservesTerabytes = false;
#endif

TEST(InThreads, EachNumberIsCalledOnce) {
  for (const std::size_t count : {1U, 2U, 20U}) {
    std::vector<int> calls(count, 0);
    in_threads(count, [&](std::size_t number) { ++calls[number]; });
    EXPECT_EQ(calls, std::vector<int>(count, 1));
  }
}

TEST(InThreads, ThrowsWhenAllHaveEnded) {
  std::atomic<int> ended = 0;
  const auto work = [&](std::size_t number) {
    if (number == 3) throw std::runtime_error("three");
    ++ended;
  };
  EXPECT_THROW(in_threads(5, work), std::runtime_error);
  EXPECT_EQ(ended, 4);
}

std::size_t address_space_in_use() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

/// Of a process that has little room for stacks: the work is done, and with memory to do it in.
[[noreturn]] void work_in_little_memory() {
  constexpr std::size_t kRoom = std::size_t{256} << 20U;
  constexpr std::size_t kNeeded = std::size_t{16} << 20U;
  constexpr std::size_t kThreads = 1000;
  const rlim_t bytes = address_space_in_use() + kRoom;
  const rlimit limit{bytes, bytes};
  if (::setrlimit(RLIMIT_AS, &limit) != 0) std::_Exit(1);
  std::atomic<std::size_t> calls = 0;
  std::size_t got = 0;
  in_threads(kThreads, [&](std::size_t number) {
    ++calls;
    if (number == 0) got = std::vector<char>(kNeeded).size();
  });
  std::_Exit(got == kNeeded && calls > 1 && calls < kThreads ? 0 : 2);
}

TEST(InThreadsDeathTest, FewerThanWantedDoTheWork) {
  if (kReservesTerabytes) GTEST_SKIP() << "no limit of memory under this sanitizer";
  EXPECT_EXIT(work_in_little_memory(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace rigor
