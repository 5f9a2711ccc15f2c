// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A pool of workers: who serves what, and what is left of it.

#include <rigor/process/workers.h>

#include <fcntl.h>
#include <sys/resource.h>

#include <atomic>
#include <csignal>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "process/workers_fixture.h"

namespace rigor::process {
namespace {

using WorkerPool = test::WorkersTest;

TEST_F(WorkerPool, BytesGoThereAndComeBack) {
  const std::string bytes("a\0b", 3);
  EXPECT_EQ(call("echo", bytes).end, End::kDone);
  EXPECT_EQ(call("echo", bytes).bytes, bytes);
  EXPECT_EQ(call("echo").end, End::kDone);
}

TEST_F(WorkerPool, MoreThanASocketHoldsGoesBothWays) {
  const std::string noise = call("noise", "50000000").bytes;
  ASSERT_EQ(noise.size(), 50'000'000U);
  EXPECT_TRUE(call("echo", noise).bytes == noise);
  // The same generator, three values on: 1664525·1 + 1013904223, and so on.
  EXPECT_EQ(static_cast<unsigned char>(noise[0]), (1664525U * 1U + 1013904223U) >> 24U);
}

TEST_F(WorkerPool, AnUnknownKindFails) {
  const RequestResult result = call("fly");
  EXPECT_EQ(result.end, End::kFailed);
  EXPECT_EQ(result.bytes, "no service is named fly");
}

TEST_F(WorkerPool, AWorkerIsKeptForTheNext) {
  const std::string first = call("process").bytes;
  EXPECT_EQ(call("process").bytes, first);
  call("noise", "1000000");
  EXPECT_EQ(call("process").bytes, first);
  call("throw", "what it left behind is unknown");
  EXPECT_NE(call("process").bytes, first);
}

TEST_F(WorkerPool, AWorkerThatRetiresIsReplaced) {
  const std::string first = call("retire").bytes;
  EXPECT_NE(call("process").bytes, first);
}

TEST_F(WorkerPool, AWorkerThatHoardsIsReplaced) {
  const std::string small = call("hoard", std::to_string(16U << 20U)).bytes;
  EXPECT_EQ(call("process").bytes, small);
  const std::string large = call("hoard", std::to_string(300U << 20U)).bytes;
  EXPECT_EQ(large, small);
  EXPECT_NE(call("process").bytes, large);
}

TEST_F(WorkerPool, AWorkerThatWasKilledBetweenRequestsIsReplaced) {
  const pid_t worker = std::stoi(call("process").bytes);
  ::kill(worker, SIGKILL);
  ASSERT_TRUE(test::ends(worker));
  const RequestResult next = call("process");
  EXPECT_EQ(next.end, End::kDone);
  EXPECT_NE(next.bytes, std::to_string(worker));
}

TEST_F(WorkerPool, QuestionsAreAnsweredByTheCaller) {
  std::string asked;
  const Answer answer = [&](std::string_view question) -> std::optional<std::string_view> {
    asked = question;
    if (question == "nobody") return std::nullopt;
    return "answer";
  };
  EXPECT_EQ(workers_.call({.kind = "ask", .bytes = "who"}, answer).bytes, "answer to who");
  EXPECT_EQ(asked, "who");
  EXPECT_EQ(workers_.call({.kind = "ask", .bytes = "nobody"}, answer).bytes, "no answer to nobody");
  EXPECT_EQ(call("ask", "x").bytes, "no answer to x");
}

TEST_F(WorkerPool, ARequestMayBeMadeWhileAnotherIsAnswered) {
  std::string inner;
  const Answer answer = [&](std::string_view) -> std::optional<std::string_view> {
    inner = call("echo", "inner").bytes;
    return inner;
  };
  EXPECT_EQ(workers_.call({.kind = "ask", .bytes = "outer"}, answer).bytes, "inner to outer");
}

TEST_F(WorkerPool, ServesManyThreads) {
  std::atomic<int> good{0};
  std::vector<std::thread> threads;
  for (int t = 0; t < 8; ++t) {
    threads.emplace_back([&, t] {
      for (int i = 0; i < 20; ++i) {
        const std::string own = std::to_string(100 * t + i);
        const std::string answer(100'000 + static_cast<std::size_t>(i), 'z');
        const RequestResult result = workers_.call(
            {.kind = "ask", .bytes = own},
            [&](std::string_view) -> std::optional<std::string_view> { return answer; });
        good += result.bytes == answer + " to " + own;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(good, 160);
}

TEST_F(WorkerPool, ThereAreNoMoreWorkersThanRequestsAtOnce) {
  std::set<std::string> processes;
  int left = 30;
  workers_.feed(
      3, [&] { return left-- > 0 ? std::optional(Request{.kind = "process"}) : std::nullopt; },
      [&](std::size_t, const RequestResult& result) { processes.insert(result.bytes); });
  EXPECT_LE(processes.size(), 3U);
}

TEST_F(WorkerPool, RequestsMayComeOfResults) {
  // Each number calls for the next, until there are four.
  std::vector<int> waiting{1};
  std::string told;
  workers_.feed(
      2,
      [&]() -> std::optional<Request> {
        if (waiting.empty()) return std::nullopt;
        const int number = waiting.back();
        waiting.pop_back();
        return Request{.kind = "echo", .bytes = std::to_string(number)};
      },
      [&](std::size_t index, const RequestResult& result) {
        told += std::to_string(index) + ':' + result.bytes + ' ';
        if (index < 3) waiting.push_back(static_cast<int>(index) + 2);
      });
  EXPECT_EQ(told, "0:1 1:2 2:3 3:4 ");
}

TEST_F(WorkerPool, OneThatCrashesTakesNoOtherAlong) {
  const std::vector<Request> requests{{.kind = "echo", .bytes = "first"},
                                      {.kind = "raise", .bytes = std::to_string(SIGABRT)},
                                      {.kind = "throw", .bytes = "no"},
                                      {.kind = "echo", .bytes = "last"}};
  for (const unsigned jobs : {1U, 2U, 64U}) {
    std::size_t given = 0;
    std::map<std::size_t, RequestResult> results;
    workers_.feed(
        jobs, [&] { return given < 4 ? std::optional(requests[given++]) : std::nullopt; },
        [&](std::size_t index, RequestResult result) { results[index] = std::move(result); });
    ASSERT_EQ(results.size(), 4U);
    EXPECT_EQ(results[0].bytes, "first");
    EXPECT_EQ(results[1].signal, SIGABRT);
    EXPECT_EQ(results[2].end, End::kFailed);
    EXPECT_EQ(results[2].bytes, "no");
    EXPECT_EQ(results[3].bytes, "last");
  }
}

TEST_F(WorkerPool, PrintsNothing) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  call("print");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(WorkerPool, SeesNoDescriptorButItsOwn) {
  constexpr int kFarFromItsOwn = 100;
  const int low = ::open("/dev/null", O_RDONLY);
  const int secret = ::fcntl(low, F_DUPFD, kFarFromItsOwn);  // stays open over exec
  ::close(low);
  EXPECT_EQ(call("is-open", std::to_string(secret)).bytes, "closed");
  EXPECT_EQ(call("is-open", "4").bytes, "closed");
  EXPECT_EQ(call("is-open", "2").bytes, "open");
  ::close(secret);
}

TEST_F(WorkerPool, AnIgnoredSigchldLosesNoResult) {
  const auto before = std::signal(SIGCHLD, SIG_IGN);
  const RequestResult result = call("echo", "here");
  const RequestResult crash = call("raise", std::to_string(SIGSEGV));
  std::signal(SIGCHLD, before);
  EXPECT_EQ(result.bytes, "here");
  EXPECT_EQ(crash.end, End::kCrashed);
}

TEST(WorkerPoolEnd, LeavesNoProcessAndNoDescriptor) {
  const int descriptors = test::open_descriptors();
  pid_t worker = 0;
  {
    const Workers unused{RIGOR_TEST_WORKER};
    const Workers workers{RIGOR_TEST_WORKER};
    worker = std::stoi(workers.call({.kind = "process"}).bytes);
    workers.call({.kind = "echo"});
  }
  EXPECT_EQ(::kill(worker, 0), -1) << "the worker is left";
  EXPECT_EQ(test::open_descriptors(), descriptors);
}

}  // namespace
}  // namespace rigor::process
