// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Workers that end in every way there is: each is blamed on its own request, and replaced.

#include <rigor/process/workers.h>

#include <poll.h>

#include <csignal>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include <gtest/gtest.h>

#include <rigor/process/exchange.h>
#include <rigor/process/launch.h>
#include <rigor/process/program.h>

#include "process/workers_fixture.h"

namespace rigor::process {
namespace {

/// After every end the next request is served as if nothing had been.
class WorkerEnds : public test::WorkersTest {
 protected:
  ~WorkerEnds() override { EXPECT_EQ(call("echo", "still here").bytes, "still here"); }
};

TEST_F(WorkerEnds, ExceptionsBecomeFailures) {
  const RequestResult known = call("throw", "no wheel");
  EXPECT_EQ(known.end, End::kFailed);
  EXPECT_EQ(known.bytes, "no wheel");
  EXPECT_EQ(describe(known, kLimits), "failed: no wheel");
  EXPECT_EQ(call("throw-number").end, End::kFailed);
}

TEST_F(WorkerEnds, SignalsBecomeCrashes) {
  const auto die_by = [&](int signal) { return call("raise", std::to_string(signal)); };
  const RequestResult segfault = die_by(SIGSEGV);
  EXPECT_EQ(segfault.end, End::kCrashed);
  EXPECT_EQ(segfault.signal, SIGSEGV);
  EXPECT_EQ(describe(segfault, kLimits), "crashed (segmentation fault)");
  EXPECT_EQ(describe(die_by(SIGABRT), kLimits), "crashed (aborted)");
  EXPECT_EQ(die_by(SIGKILL).signal, SIGKILL);
}

TEST_F(WorkerEnds, SignalsThatTheCallerIgnoresOrBlocksAreNotTheWorkers) {
  const auto before = std::signal(SIGUSR1, SIG_IGN);
  sigset_t blocked, mask;
  ::sigemptyset(&blocked);
  ::sigaddset(&blocked, SIGUSR1);
  ::pthread_sigmask(SIG_BLOCK, &blocked, &mask);
  const RequestResult result = call("raise", std::to_string(SIGUSR1));
  ::pthread_sigmask(SIG_SETMASK, &mask, nullptr);
  std::signal(SIGUSR1, before);
  EXPECT_EQ(result.signal, SIGUSR1);
}

TEST_F(WorkerEnds, LeavingByItselfIsNoResult) {
  const RequestResult result = call("leave");
  EXPECT_EQ(result.end, End::kCrashed);
  EXPECT_EQ(result.signal, 0);
  EXPECT_EQ(describe(result, kLimits), "ended before its time");
}

TEST_F(WorkerEnds, DeathWhileWritingIsNoResult) {
  const RequestResult result = call("die-while-writing");
  EXPECT_EQ(result.end, End::kCrashed);
  EXPECT_EQ(result.bytes, "");
}

/// A request to a worker, until the deadline.
class TimedExchange {
 public:
  TimedExchange(IdleWorker worker, Request request, Exchange::Clock::time_point deadline)
      : exchange_(std::move(worker), std::move(request), answer_, deadline) {
    for (exchange_.advance(); !exchange_.over(); exchange_.advance()) {
      pollfd wanted = exchange_.wanted();
      ::poll(&wanted, 1, -1);
    }
  }

  RequestResult result() { return exchange_.take_result(); }
  std::optional<IdleWorker> worker() { return exchange_.take_worker(); }

 private:
  const Answer answer_ = [](std::string_view) { return std::nullopt; };
  Exchange exchange_;
};

IdleWorker new_worker() {
  return {std::get<WorkerProcess>(WorkerProcess::start(RIGOR_TEST_WORKER)), RIGOR_TEST_WORKER};
}

TEST_F(WorkerEnds, RunningForeverEndsAsOutOfTime) {
  const RequestLimits second{.cpu_seconds = 1};
  // Without a clock on the wall, which a busy machine would be too slow for.
  const auto never = Exchange::Clock::time_point::max();
  TimedExchange spin(new_worker(), {.kind = "spin", .limits = second}, never);
  const RequestResult result = spin.result();
  EXPECT_EQ(result.end, End::kOutOfTime);
  EXPECT_EQ(describe(result, second), "took more than 1 s of CPU time");
  EXPECT_FALSE(spin.worker());
}

TEST_F(WorkerEnds, TheTimeIsARequestsAndNotTheWorkers) {
  const RequestLimits second{.cpu_seconds = 1};
  const auto never = Exchange::Clock::time_point::max();
  std::optional<IdleWorker> worker = new_worker();
  // Together they take more than a second.
  for (int i = 0; i < 3 && worker; ++i) {
    TimedExchange some(std::move(*worker), {.kind = "use", .bytes = "600", .limits = second},
                       never);
    EXPECT_EQ(some.result().end, End::kDone) << i;
    auto next = some.worker();
    worker.reset();
    if (next) worker.emplace(std::move(*next));
  }
}

TEST_F(WorkerEnds, WaitingForeverEndsAsOutOfTime) {
  // Its time has passed already, which a test need not wait for.
  TimedExchange wait(new_worker(), {.kind = "wait"}, Exchange::Clock::now());
  const RequestResult result = wait.result();
  EXPECT_EQ(result.end, End::kOutOfTime);
  EXPECT_EQ(describe(result, kLimits), "did not end within 600 s");
  EXPECT_FALSE(wait.worker());
}

TEST_F(WorkerEnds, MemoryIsBounded) {
  EXPECT_EQ(call("bad-alloc").end, End::kOutOfMemory);
  if (test::kUnderAddressSanitizer) GTEST_SKIP() << "no limit of memory under the sanitizer";
  constexpr std::size_t kLimit = std::size_t{256} << 20U;
  const RequestLimits small{.cpu_seconds = 60, .memory_bytes = kLimit};
  const auto take = [&](std::size_t bytes) { return call("take", std::to_string(bytes), small); };
  EXPECT_EQ(take(kLimit / 2).end, End::kDone);
  const RequestResult over = take(2 * kLimit);
  EXPECT_EQ(over.end, End::kOutOfMemory);
  EXPECT_EQ(describe(over, small), "needed more than 256 MiB of memory");
  // The next request may have more again.
  EXPECT_EQ(call("take", std::to_string(2 * kLimit)).end, End::kDone);
}

TEST_F(WorkerEnds, ARequestThatTakesMoreMemoryThanItMayIsRefused) {
  if (test::kUnderAddressSanitizer) GTEST_SKIP() << "no limit of memory under the sanitizer";
  const RequestLimits small{.cpu_seconds = 60, .memory_bytes = 1U << 20U};
  EXPECT_EQ(call("echo", std::string(64U << 20U, 'x'), small).end, End::kOutOfMemory);
}

TEST_F(WorkerEnds, AResultLargerThanTheMemoryIsNotBelieved) {
  const RequestLimits small{.cpu_seconds = 60, .memory_bytes = 1U << 20U};
  EXPECT_NE(call("noise", std::to_string(2U << 20U), small).end, End::kDone);
}

TEST_F(WorkerEnds, AQuestionThatIsTooLongEndsTheWorker) {
  const RequestResult result = call("ask-and-wait", std::to_string(kMaxQuestion + 1));
  EXPECT_EQ(result.end, End::kCrashed);
  EXPECT_EQ(result.signal, 0);
}

TEST_F(WorkerEnds, AnAnswerThatThrowsEndsTheWorker) {
  pid_t worker = 0;
  const Answer refuse = [&](std::string_view process) -> std::optional<std::string_view> {
    worker = std::stoi(std::string(process));
    throw std::runtime_error("refused");
  };
  EXPECT_THROW(workers_.call({.kind = "ask-and-wait"}, refuse), std::runtime_error);
  EXPECT_EQ(::kill(worker, 0), -1) << "the worker is left";
}

TEST_F(WorkerEnds, AWorkerEndsWithItsCaller) {
  const ProgramResult caller = run_program({RIGOR_TEST_WORKER, "orphan"}, {});
  ASSERT_EQ(caller.exit_code, 0) << caller.err;
  EXPECT_TRUE(test::ends(std::stoi(caller.out)));
}

}  // namespace
}  // namespace rigor::process
