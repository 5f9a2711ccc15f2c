// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Children that end in every way there is. What holds for all of them is checked each time: no child
// and no descriptor is left.

#include <rigor/process/child.h>

#include <dirent.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace rigor::process {
namespace {

using End = ChildResult::End;

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kAddressSanitizer = true;
#elif defined(__has_feature)
constexpr bool kAddressSanitizer = __has_feature(address_sanitizer);
#else
constexpr bool kAddressSanitizer = false;
#endif

int open_descriptors() {
  DIR* folder = ::opendir("/proc/self/fd");
  if (!folder) return 0;
  int count = 0;
  while (::readdir(folder)) ++count;
  ::closedir(folder);
  return count;
}

class ProcessChild : public testing::Test {
 protected:
  ~ProcessChild() override {
    EXPECT_EQ(open_descriptors(), descriptors_);
    EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
    EXPECT_EQ(errno, ECHILD);
  }

  const ChildLimits limits_{.cpu_seconds = 60};

 private:
  int descriptors_ = open_descriptors();
};

TEST_F(ProcessChild, GivesBackBytes) {
  const ChildResult result = run_in_child(limits_, [] { return std::string("a\0b", 3); });
  EXPECT_EQ(result.end, End::kDone);
  EXPECT_EQ(result.bytes, std::string("a\0b", 3));
  EXPECT_EQ(run_in_child(limits_, [] { return std::string(); }).end, End::kDone);
}

TEST_F(ProcessChild, GivesBackMoreThanAPipeHolds) {
  const auto work = [] {
    std::string bytes(50'000'000, '\0');
    std::uint32_t state = 1;
    for (char& byte : bytes)
      byte = static_cast<char>((state = state * 1664525U + 1013904223U) >> 24U);
    return bytes;
  };
  const ChildResult result = run_in_child(limits_, work);
  EXPECT_EQ(result.end, End::kDone);
  EXPECT_TRUE(result.bytes == work());
}

TEST_F(ProcessChild, ChangesNothingHere) {
  int value = 1;
  run_in_child(limits_, [&] {
    value = 2;
    return std::string();
  });
  EXPECT_EQ(value, 1);
}

TEST_F(ProcessChild, ExceptionsBecomeFailures) {
  const ChildResult known =
      run_in_child(limits_, []() -> std::string { throw std::runtime_error("no wheel"); });
  EXPECT_EQ(known.end, End::kFailed);
  EXPECT_EQ(known.bytes, "no wheel");
  EXPECT_EQ(describe(known, limits_), "failed: no wheel");
  EXPECT_EQ(run_in_child(limits_, []() -> std::string { throw 7; }).end, End::kFailed);
}

TEST_F(ProcessChild, SignalsBecomeCrashes) {
  const auto die_by = [&](int signal) {
    return run_in_child(limits_, [signal] {
      ::raise(signal);
      return std::string();
    });
  };
  const ChildResult segfault = die_by(SIGSEGV);
  EXPECT_EQ(segfault.end, End::kCrashed);
  EXPECT_EQ(segfault.signal, SIGSEGV);
  EXPECT_EQ(describe(segfault, limits_), "crashed (segmentation fault)");
  EXPECT_EQ(describe(die_by(SIGABRT), limits_), "crashed (aborted)");
  EXPECT_EQ(die_by(SIGKILL).signal, SIGKILL);
}

TEST_F(ProcessChild, HandlersOfTheParentDoNotHideACrash) {
  const auto before = std::signal(SIGSEGV, [](int) { std::_Exit(0); });
  const ChildResult result = run_in_child(limits_, [] {
    ::raise(SIGSEGV);
    return std::string();
  });
  std::signal(SIGSEGV, before);
  EXPECT_EQ(result.signal, SIGSEGV);
}

TEST_F(ProcessChild, LeavingByItselfIsNoResult) {
  const ChildResult result = run_in_child(limits_, []() -> std::string { std::_Exit(0); });
  EXPECT_EQ(result.end, End::kCrashed);
  EXPECT_EQ(result.signal, 0);
  EXPECT_EQ(describe(result, limits_), "ended before its time");
}

TEST_F(ProcessChild, DeathWhileWritingIsNoResult) {
  // More than the pipe holds comes through before the child dies, as when it is killed in between.
  const ChildResult result = run_in_child(limits_, []() -> std::string {
    constexpr int kResult = 3;
    const std::string part(300'000, '\0');
    EXPECT_EQ(::write(kResult, part.data(), part.size()), static_cast<ssize_t>(part.size()));
    ::raise(SIGKILL);
    return part;
  });
  EXPECT_EQ(result.end, End::kCrashed);
  EXPECT_EQ(result.signal, SIGKILL);
  EXPECT_EQ(result.bytes, "");
}

TEST_F(ProcessChild, WorksMayComeOfResults) {
  // Each number calls for the next, until there are four.
  std::vector<int> waiting{1};
  std::string told;
  feed_children(
      limits_, 2,
      [&]() -> std::function<std::string()> {
        if (waiting.empty()) return {};
        const int number = waiting.back();
        waiting.pop_back();
        return [number] { return std::to_string(number); };
      },
      [&](std::size_t index, const ChildResult& result) {
        told += std::to_string(index) + ':' + result.bytes + ' ';
        if (index < 3) waiting.push_back(static_cast<int>(index) + 2);
      });
  EXPECT_EQ(told, "0:1 1:2 2:3 3:4 ");
}

TEST_F(ProcessChild, RunningForeverEndsAsOutOfTime) {
  const ChildLimits second{.cpu_seconds = 1};
  const ChildResult result = run_in_child(second, [] {
    std::atomic<bool> end = false;
    while (!end) {
    }
    return std::string();
  });
  EXPECT_EQ(result.end, End::kOutOfTime);
  EXPECT_EQ(describe(result, second), "took more than 1 s of CPU time");
}

TEST_F(ProcessChild, WaitingForeverEndsAsOutOfTime) {
  // Stands for the alarm of the wall clock, which a test must not wait for.
  const ChildResult result = run_in_child(limits_, [] {
    const unsigned left = ::alarm(0);
    if (left == 0 || left > 60 * kWallPerCpuSecond) return std::string("no alarm is set");
    ::raise(SIGALRM);
    return std::string();
  });
  EXPECT_EQ(result.end, End::kOutOfTime) << result.bytes;
  EXPECT_EQ(describe(result, limits_), "did not end within 600 s");
}

TEST_F(ProcessChild, MemoryIsBounded) {
  if (kAddressSanitizer) GTEST_SKIP() << "no limit of memory under the address sanitizer";
  constexpr std::size_t kLimit = std::size_t{256} << 20U;
  const ChildLimits small{.cpu_seconds = 60, .memory_bytes = kLimit};
  const auto take = [&](std::size_t bytes) {
    return run_in_child(small, [bytes] { return std::to_string(std::vector<char>(bytes).size()); });
  };
  EXPECT_EQ(take(kLimit / 2).end, End::kDone);
  const ChildResult over = take(2 * kLimit);
  EXPECT_EQ(over.end, End::kOutOfMemory);
  EXPECT_EQ(describe(over, small), "needed more than 256 MiB of memory");
}

TEST_F(ProcessChild, PrintsNothing) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  run_in_child(limits_, [] {
    std::fputs("out", stdout);
    std::fputs("err", stderr);
    std::fflush(nullptr);
    return std::string();
  });
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(ProcessChild, SeesNoDescriptorButItsOwn) {
  constexpr int kFarFromItsOwn = 100;
  const int low = ::open("/dev/null", O_RDONLY);
  const int secret = ::fcntl(low, F_DUPFD, kFarFromItsOwn);
  ::close(low);
  const ChildResult result = run_in_child(
      limits_, [secret] { return std::string(::fcntl(secret, F_GETFD) < 0 ? "closed" : "open"); });
  ::close(secret);
  EXPECT_EQ(result.bytes, "closed");
}

TEST_F(ProcessChild, RunsFromSeveralThreads) {
  std::vector<std::thread> threads;
  std::atomic<int> good = 0;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      for (int i = 0; i < 10; ++i) {
        const std::string expected(200'000, static_cast<char>('a' + t));
        good += run_in_child(limits_, [&] { return expected; }).bytes == expected;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(good, 40);
}

TEST_F(ProcessChild, AnIgnoredSigchldLosesNoResult) {
  const auto before = std::signal(SIGCHLD, SIG_IGN);
  const ChildResult result = run_in_child(limits_, [] { return std::string("here"); });
  std::signal(SIGCHLD, before);
  EXPECT_EQ(result.end, End::kDone);
  EXPECT_EQ(result.bytes, "here");
}

TEST_F(ProcessChild, SeveralGiveTheirResultsInTheirOwnOrder) {
  std::vector<std::function<std::string()>> works;
  for (int i = 0; i < 20; ++i) {
    works.push_back([i] {
      // The first ones work longest, so that they end last.
      volatile double sum = 0;
      for (int k = 0; k < (20 - i) * 100'000; ++k) sum = sum + k;
      return std::string(static_cast<std::size_t>(i) * 10'000, 'x') + std::to_string(i);
    });
  }
  for (const unsigned jobs : {1U, 3U, 64U}) {
    std::vector<std::size_t> told;
    const std::vector<ChildResult> results =
        run_in_children(limits_, works, jobs, [&](std::size_t ended) { told.push_back(ended); });
    ASSERT_EQ(results.size(), works.size());
    for (std::size_t i = 0; i < results.size(); ++i) {
      EXPECT_EQ(results[i].end, End::kDone);
      EXPECT_EQ(results[i].bytes, std::string(i * 10'000, 'x') + std::to_string(i));
    }
    ASSERT_EQ(told.size(), works.size());
    for (std::size_t i = 0; i < told.size(); ++i) EXPECT_EQ(told[i], i + 1);
  }
}

TEST_F(ProcessChild, OneThatCrashesTakesNoOtherAlong) {
  const std::vector<ChildResult> results = run_in_children(
      limits_,
      {[] { return std::string("first"); }, []() -> std::string { std::abort(); },
       []() -> std::string { throw std::runtime_error("no"); }, [] { return std::string("last"); }},
      2);
  ASSERT_EQ(results.size(), 4U);
  EXPECT_EQ(results[0].bytes, "first");
  EXPECT_EQ(results[1].end, End::kCrashed);
  EXPECT_EQ(results[1].signal, SIGABRT);
  EXPECT_EQ(results[2].end, End::kFailed);
  EXPECT_EQ(results[2].bytes, "no");
  EXPECT_EQ(results[3].bytes, "last");
}

TEST_F(ProcessChild, OnesThatCannotBeStartedHaveEnded) {
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
  const rlimit none{0, before.rlim_max};  // no pipe can be made
  const auto work = [] { return std::string("never"); };
  std::vector<std::size_t> told;
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &none), 0);
  const ChildResult alone = run_in_child(limits_, work);
  const std::vector<ChildResult> several = run_in_children(
      limits_, {work, work, work}, 2, [&](std::size_t ended) { told.push_back(ended); });
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
  EXPECT_EQ(alone.end, End::kNotStarted);
  EXPECT_EQ(describe(alone, limits_), "could not be started: Too many open files");
  ASSERT_EQ(several.size(), 3U);
  for (const ChildResult& each : several) EXPECT_EQ(each.end, End::kNotStarted);
  EXPECT_EQ(told, (std::vector<std::size_t>{1, 2, 3}));
}

TEST_F(ProcessChild, NoWorksGiveNoResults) { EXPECT_TRUE(run_in_children(limits_, {}, 4).empty()); }

}  // namespace
}  // namespace rigor::process
