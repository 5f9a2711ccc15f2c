// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Children of a helper process end in every way that children of one's own do, and neither they nor
// the helper are left behind.

#include <rigor/process/fork_server.h>

#include <dirent.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace rigor::process {
namespace {

using ServedEnd = ChildResult::End;
using Ask = ForkServer::Ask;

int descriptors_in_use() {
  DIR* folder = ::opendir("/proc/self/fd");
  if (!folder) return 0;
  int count = 0;
  while (::readdir(folder)) ++count;
  ::closedir(folder);
  return count;
}

class ProcessForkServer : public testing::Test {
 protected:
  ~ProcessForkServer() override {
    EXPECT_EQ(descriptors_in_use(), descriptors_);
    EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1) << "a process is left";
    EXPECT_EQ(errno, ECHILD);
  }

  /// What one child gives that does `work`.
  ChildResult run(const ForkServer::Work& work, const ChildLimits& limits) const {
    return ForkServer([] {}, work).run(limits, "", no_answer_);
  }
  ChildResult run(const ForkServer::Work& work) const { return run(work, limits_); }

  const ChildLimits limits_{.cpu_seconds = 60};
  const ForkServer::Answer no_answer_ = [](std::string_view) { return std::nullopt; };

 private:
  int descriptors_ = descriptors_in_use();
};

std::string parent_of_child(const std::string&, const Ask&) { return std::to_string(::getppid()); }

[[noreturn]] void sleep_for_ever() {
  while (true) ::pause();
}

TEST_F(ProcessForkServer, RequestGoesThereAndBytesComeBack) {
  const ForkServer server([] {}, [](const std::string& request,
                                    const Ask&) { return request + std::string("\0!", 2); });
  for (const std::string& request :
       {std::string("a\0b", 3), std::string(), std::string(3 << 20, 'x')}) {
    const ChildResult result = server.run(limits_, request, no_answer_);
    EXPECT_EQ(result.end, ServedEnd::kDone);
    EXPECT_EQ(result.bytes, request + std::string("\0!", 2));
  }
}

TEST_F(ProcessForkServer, NothingIsStartedUnlessItIsUsed) {
  const ForkServer unused([] {}, parent_of_child);
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
}

TEST_F(ProcessForkServer, StartedAndNeverUsedLeavesNothing) {
  const ForkServer server([] {}, parent_of_child);
  server.start();
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), 0) << "there is a helper";
}

TEST_F(ProcessForkServer, WhatIsPreparedOnceEachChildFinds) {
  int prepared = 0;
  const ForkServer server(
      [&] { ++prepared; },
      [&](const std::string&, const Ask&) { return std::to_string(++prepared); });
  EXPECT_EQ(server.run(limits_, "", no_answer_).bytes, "2");
  EXPECT_EQ(server.run(limits_, "", no_answer_).bytes, "2");
  EXPECT_EQ(prepared, 0);
}

TEST_F(ProcessForkServer, ChildrenAreOfOneHelper) {
  const ForkServer server([] {}, parent_of_child);
  const std::string helper = server.run(limits_, "", no_answer_).bytes;
  EXPECT_EQ(server.run(limits_, "", no_answer_).bytes, helper);
  EXPECT_NE(helper, std::to_string(::getpid()));
}

TEST_F(ProcessForkServer, QuestionsAreAnsweredByTheCaller) {
  const ForkServer server([] {},
                          [](const std::string& request, const Ask& ask) {
                            std::string answers = ask(request + ".one").value_or("none");
                            answers += ask("").value_or("none");
                            return answers + ask("two").value_or("none");
                          });
  std::vector<std::string> asked;
  const ChildResult result =
      server.run(limits_, "r", [&](std::string_view name) -> std::optional<std::string_view> {
        asked.emplace_back(name);
        if (name == "two") return std::nullopt;
        return name.empty() ? "" : "1";
      });
  EXPECT_EQ(result.bytes, "1none");
  EXPECT_EQ(asked, (std::vector<std::string>{"r.one", "", "two"}));
}

TEST_F(ProcessForkServer, WhatIsThrownComesBackAsText) {
  const ChildResult result = run(
      [](const std::string&, const Ask&) -> std::string { throw std::runtime_error("no wheel"); });
  EXPECT_EQ(result.end, ServedEnd::kFailed);
  EXPECT_EQ(result.bytes, "no wheel");
}

TEST_F(ProcessForkServer, CrashesAreTold) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGKILL, SIGFPE}) {
    const ChildResult result = run([signal](const std::string&, const Ask&) -> std::string {
      ::signal(signal, SIG_DFL);
      ::raise(signal);
      return {};
    });
    EXPECT_EQ(result.end, ServedEnd::kCrashed) << signal;
    EXPECT_EQ(result.signal, signal);
  }
  const ChildResult left =
      run([](const std::string&, const Ask&) -> std::string { std::_Exit(0); });
  EXPECT_EQ(left.end, ServedEnd::kCrashed);
  EXPECT_EQ(left.signal, 0);
}

TEST_F(ProcessForkServer, TheLimitsHoldForEachChild) {
  const ChildResult endless = run(
      [](const std::string&, const Ask&) -> std::string {
        std::atomic<int> spin{0};
        while (true) ++spin;
      },
      {.cpu_seconds = 1});
  EXPECT_EQ(endless.end, ServedEnd::kOutOfTime);
  const ChildResult bad_alloc =
      run([](const std::string&, const Ask&) -> std::string { throw std::bad_alloc(); });
  EXPECT_EQ(bad_alloc.end, ServedEnd::kOutOfMemory);
}

TEST_F(ProcessForkServer, AChildThatWaitsKeepsNoOtherWaiting) {
  const ForkServer server([] {},
                          [](const std::string& request, const Ask& ask) {
                            return request == "outer" ? "outer " + ask("").value_or("") : request;
                          });
  std::string inner;
  const ChildResult outer =
      server.run(limits_, "outer", [&](std::string_view) -> std::optional<std::string_view> {
        inner = server.run(limits_, "inner", no_answer_).bytes;
        return inner;
      });
  EXPECT_EQ(outer.bytes, "outer inner");
}

TEST_F(ProcessForkServer, ServesManyThreads) {
  const ForkServer server([] {}, [](const std::string& request,
                                    const Ask& ask) { return request + ask("?").value_or(""); });
  server.start();  // before there are threads, as is said where it is declared
  std::atomic<int> good{0};
  std::vector<std::thread> threads;
  for (int t = 0; t < 8; ++t) {
    threads.emplace_back([&, t] {
      for (int i = 0; i < 20; ++i) {
        const std::string own = std::to_string(100 * t + i);
        const std::string long_one(100'000 + static_cast<std::size_t>(i), 'z');
        const ChildResult result = server.run(
            limits_, own,
            [&](std::string_view) -> std::optional<std::string_view> { return long_one; });
        good += result.bytes == own + long_one;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(good, 160);
}

TEST_F(ProcessForkServer, AHelperThatIsKilledIsDoneWithout) {
  const ForkServer server([] {},
                          [](const std::string&, const Ask& ask) {
                            return std::to_string(::getppid()) + ask("?").value_or("");
                          });
  const ForkServer::Answer mark = [](std::string_view) { return "!"; };
  const std::string helper = server.run(limits_, "", no_answer_).bytes;
  ::kill(std::stoi(helper), SIGKILL);
  for (int i = 0; i < 2; ++i) {
    const ChildResult result = server.run(limits_, "", mark);
    EXPECT_EQ(result.end, ServedEnd::kDone);
    EXPECT_EQ(result.bytes, std::to_string(::getpid()) + "!");
  }
}

TEST_F(ProcessForkServer, AHelperThatIsKilledInBetweenTakesItsChildAlong) {
  const ForkServer server([] {},
                          [](const std::string&, const Ask& ask) {
                            ask(std::to_string(::getppid()));
                            return std::to_string(::getppid());
                          });
  const ChildResult result =
      server.run(limits_, "", [](std::string_view parent) -> std::optional<std::string_view> {
        const int process = std::stoi(std::string(parent));
        // Not when this is asked by a child of this process, in that child.
        if (process != ::getpid() && ::getppid() != process) ::kill(process, SIGKILL);
        return "";
      });
  // Its end may come before the helper's: then its result counts.
  EXPECT_EQ(result.end, ServedEnd::kDone);
}

TEST_F(ProcessForkServer, WhatCannotBePreparedIsDoneWithout) {
  const auto work = [](const std::string& request, const Ask&) { return request; };
  const ForkServer throwing([] { throw std::runtime_error("no library"); }, work);
  EXPECT_EQ(throwing.run(limits_, "a", no_answer_).bytes, "a");
  const ForkServer crashing([] { ::raise(SIGKILL); }, work);
  EXPECT_EQ(crashing.run(limits_, "b", no_answer_).bytes, "b");
}

TEST_F(ProcessForkServer, AnAnswerThatThrowsEndsTheChild) {
  int child = 0;
  {
    const ForkServer server([] {},
                            [](const std::string&, const Ask& ask) -> std::string {
                              ask(std::to_string(::getpid()));
                              sleep_for_ever();
                            });
    const auto refuse = [&](std::string_view name) -> std::optional<std::string_view> {
      child = std::stoi(std::string(name));
      throw std::runtime_error("refused");
    };
    EXPECT_THROW(server.run(limits_, "", refuse), std::runtime_error);
  }
  EXPECT_EQ(::kill(child, 0), -1) << "the child is left";
}

TEST_F(ProcessForkServer, AQuestionThatIsTooLongEndsTheChild) {
  const ChildResult result = run([](const std::string&, const Ask& ask) -> std::string {
    ask(std::string(ForkServer::kMaxQuestion + 1, '?'));
    sleep_for_ever();
  });
  EXPECT_EQ(result.end, ServedEnd::kCrashed);
  EXPECT_EQ(result.signal, 0);
}

TEST_F(ProcessForkServer, AResultLargerThanTheMemoryIsNotBelieved) {
  const ChildResult result =
      run([](const std::string&, const Ask&) { return std::string(2 << 20, 'r'); },
          {.cpu_seconds = 60, .memory_bytes = 1 << 20});
  EXPECT_NE(result.end, ServedEnd::kDone);
}

}  // namespace
}  // namespace rigor::process
