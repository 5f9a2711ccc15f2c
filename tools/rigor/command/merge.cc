// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor merge FILE.jsonl...`: the parts of a run that several machines shared, as the one file that a
// single machine would have written, or as a database of results.

#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/results/line.h>
#include <rigor/results/writer.h>

#include "command/command.h"
#include "command/merge_database.h"
#include "output/atomic_file.h"
#include "output/output.h"

namespace rigor::tool {
namespace {

/// Missing cases are named up to this many.
constexpr std::size_t kMaxNamed = 20;

class Merge final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app = add_command(program, "merge", "Join the parts of a run that was sharded",
                                {"rigor merge part1.jsonl part2.jsonl -o all.jsonl",
                                 "rigor merge validate*.jsonl simulate*.jsonl -o results.sqlite"});
    app->add_option("files", files_, "Results, as --output jsonl:FILE wrote them")
        ->type_name("FILE.jsonl")
        ->required();
    app->add_option("-o,--out", out_,
                    "Write them there; to stdout when absent. FILE.sqlite or FILE.db is a database")
        ->type_name("FILE");
    return app;
  }

  int run() override {
    if (results::names_database(out_)) return merge_database(files_, out_);
    for (const std::string& path : files_) read(path);
    if (results_.empty() && total_ == 0) throw UsageError("the files contain no results");
    name_missing();
    if (problems_ > 0) {
      say("rigor: " + report::counted(problems_, "case") +
          " missing or doubled; nothing is written");
      return kFindings;
    }
    std::string all;
    for (const auto& [index, result] : results_) all += result.line + '\n';
    if (out_.empty()) {
      write({0, {}}, all);
    } else {
      replace_file(out_, all);
    }
    say("rigor: " + report::counted(results_.size(), "case") + " of " +
        report::counted(files_.size(), "file"));
    return kClean;
  }

 private:
  struct Result {
    std::string line;
    std::string file;
  };

  void read(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw UsageError(path + ": cannot be read");
    std::string line;
    for (unsigned number = 1; std::getline(file, line); ++number) {
      const std::optional<results::Case> one = results::case_of(line);
      const std::string where = path + ':' + std::to_string(number);
      if (!one) throw UsageError(where + ": is not a result of a run");
      if (total_ != 0 && one->of != total_) {
        throw UsageError(where + ": is of a run of " + std::to_string(one->of) + " cases, not " +
                         std::to_string(total_));
      }
      total_ = one->of;
      const auto [known, is_new] = results_.try_emplace(one->index, Result{line, where});
      if (is_new) continue;
      ++problems_;
      say("rigor: case " + std::to_string(one->index) + " (" + report::printable(one->id) +
          ") is in " + known->second.file + " and in " + where);
    }
  }

  void name_missing() {
    std::size_t next = 0;
    std::size_t named = 0;
    std::size_t missing = 0;
    const auto gap = [&](std::size_t end) {
      missing += end - next;
      for (; next < end && named < kMaxNamed; ++next, ++named) {
        say("rigor: case " + std::to_string(next) + " of " + std::to_string(total_) +
            " is missing");
      }
    };
    for (const auto& [index, result] : results_) {
      gap(index);
      next = index + 1;
    }
    gap(total_);
    if (missing > named) say("rigor: and " + std::to_string(missing - named) + " more");
    problems_ += missing;
  }

  std::vector<std::string> files_;
  std::string out_;
  std::map<std::size_t, Result> results_;
  std::size_t total_ = 0;
  std::size_t problems_ = 0;
};

}  // namespace

std::unique_ptr<Command> merge_command() { return std::make_unique<Merge>(); }

}  // namespace rigor::tool
