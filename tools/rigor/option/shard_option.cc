// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "option/shard_option.h"

#include <charconv>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "command/command.h"

namespace rigor::tool {
namespace {

/// How a service numbers the jobs of one kind.
struct CiMatrix {
  const char* service;
  const char* index;
  const char* of;
  unsigned first;  ///< number of the first job
};

/// GitHub has no such variables: there the matrix is written into the command.
constexpr CiMatrix kCiMatrices[] = {
    {"GitLab", "CI_NODE_INDEX", "CI_NODE_TOTAL", 1},
    {"CircleCI", "CIRCLE_NODE_INDEX", "CIRCLE_NODE_TOTAL", 0},
    {"Buildkite", "BUILDKITE_PARALLEL_JOB", "BUILDKITE_PARALLEL_JOB_COUNT", 0},
    {"Azure", "SYSTEM_JOBPOSITIONINPHASE", "SYSTEM_TOTALJOBSINPHASE", 1},
    {"Semaphore", "SEMAPHORE_JOB_INDEX", "SEMAPHORE_JOB_COUNT", 1},
    {"Slurm, --array=1-N", "SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT", 1},
};

std::string ci_variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

std::optional<unsigned> matrix_number(std::string_view text) {
  unsigned number = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number);
  if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
  return number;
}

/// Nothing when the service says nothing of several jobs.
std::optional<Shard> shard_of(const CiMatrix& matrix) {
  const std::string index_text = ci_variable(matrix.index);
  const std::string of_text = ci_variable(matrix.of);
  if (index_text.empty() && of_text.empty()) return std::nullopt;
  const std::optional<unsigned> index = matrix_number(index_text);
  const std::optional<unsigned> of = matrix_number(of_text);
  // A single job has no number in GitLab, and is one of none in Azure.
  if (of && *of <= 1 && (!index || *index <= matrix.first)) return Shard{};
  if (index && of && *index >= matrix.first && *of <= kMaxShards && *index - matrix.first < *of) {
    return Shard{*index - matrix.first + 1, *of};
  }
  throw UsageError(std::string("--shard auto: ") + matrix.index + " is \"" + index_text +
                   "\" and " + matrix.of + " \"" + of_text + "\", which is no part of a run");
}

Shard shard_of_ci() {
  std::string known;
  for (const CiMatrix& matrix : kCiMatrices) {
    if (const auto shard = shard_of(matrix)) return *shard;
    known += std::string(known.empty() ? "" : ", ") + matrix.index + " and " + matrix.of + " (" +
             matrix.service + ')';
  }
  throw UsageError("--shard auto: no variable of a CI service says which job this is: " + known +
                   "; on GitHub write --shard ${{ matrix.shard }}/${{ strategy.job-total }}");
}

}  // namespace

void ShardOption::declare(CLI::App& app, const std::string& help, const std::string& group) {
  CLI::Option* option =
      app.add_option("--shard", shard_, help + "; auto: from the variables of the CI service");
  option->type_name("I/N");
  if (!group.empty()) option->group(group);
}

Shard ShardOption::shard() const {
  if (shard_.empty()) return {};
  if (shard_ == "auto") return shard_of_ci();
  const auto shard = parse_shard(shard_);
  if (!shard) throw UsageError("--shard takes I/N, as 2/5, or auto, not \"" + shard_ + '"');
  return *shard;
}

}  // namespace rigor::tool
