// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/process/program.h>

#include <csignal>

#include <gtest/gtest.h>

namespace rigor::process {
namespace {

using ProgramEnds = ProgramResult::End;

ProgramResult run_words(const std::vector<std::string>& words) { return run_program(words, {}); }

TEST(Program, ItsWordsAreNoCode) {
  const ProgramResult ran = run_words({"printf", "%s|", "$(id)", "a b", "; exit 3"});
  EXPECT_EQ(ran.end, ProgramEnds::kExited);
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_EQ(ran.out, "$(id)|a b|; exit 3|");
}

TEST(Program, BothOutputsAndTheCodeComeBack) {
  const ProgramResult ran = run_words({"sh", "-c", "echo out; echo err >&2; cat; exit 7"});
  EXPECT_EQ(ran.end, ProgramEnds::kExited);
  EXPECT_EQ(ran.exit_code, 7);
  EXPECT_EQ(ran.out, "out\n");
  EXPECT_EQ(ran.err, "err\n");
  EXPECT_EQ(describe(ran, {}), "err");
}

TEST(Program, MoreThanAPipeHoldsComesBack) {
  const ProgramResult ran =
      run_words({"sh", "-c", "head -c 1000000 /dev/zero >&2; head -c 1000000 /dev/zero"});
  EXPECT_EQ(ran.out.size(), 1'000'000U);
  EXPECT_EQ(ran.err.size(), 1'000'000U);
}

TEST(Program, OneThatIsNotThereIsNotFound) {
  const ProgramResult ran = run_words({"no-such-program-of-rigor"});
  EXPECT_EQ(ran.end, ProgramEnds::kNotFound);
  EXPECT_EQ(describe(ran, {}), "is not installed");
}

TEST(Program, LimitsEndIt) {
  const ProgramLimits little{.wall_seconds = 60, .output_bytes = 1000};
  EXPECT_EQ(run_program({"yes"}, little).end, ProgramEnds::kTooMuchOutput);
  const ProgramLimits brief{.wall_seconds = 1};
  EXPECT_EQ(run_program({"sleep", "100"}, brief).end, ProgramEnds::kOutOfTime);
  EXPECT_EQ(run_program({"sh", "-c", "exec >&- 2>&-; sleep 100 & wait"}, brief).end,
            ProgramEnds::kOutOfTime);
  EXPECT_EQ(run_program({"sh", "-c", "kill -SEGV $$"}, brief).end, ProgramEnds::kCrashed);
}

TEST(Program, AnEndThatNobodyCanTellIsNoSuccess) {
  const auto before = std::signal(SIGCHLD, SIG_IGN);
  const ProgramResult ran = run_words({"sh", "-c", "echo out; exit 3"});
  const ProgramResult missing = run_words({"no-such-program-of-rigor"});
  std::signal(SIGCHLD, before);
  EXPECT_EQ(ran.end, ProgramEnds::kUnknown);
  EXPECT_EQ(ran.out, "out\n");
  EXPECT_EQ(describe(ran, {}), "ended, and it is unknown how");
  EXPECT_EQ(missing.end, ProgramEnds::kNotFound);
}

}  // namespace
}  // namespace rigor::process
