// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "option/fix_options.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <rigor/read/workspace.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/text/diff.h>
#include <rigor/text/path.h>
#include "command/command.h"
#include "output/atomic_file.h"

namespace rigor::tool {
namespace {

using FixedFiles = std::vector<author::FixedFile>;

/// Fixes that were not kept and are reported one by one at most.
constexpr std::size_t kMaxHeldBackReported = 10;

/// While this lives, what asks the program to end waits: it does not leave half of its work behind.
class SignalsWait {
 public:
  SignalsWait() {
    sigset_t ends;
    sigemptyset(&ends);
    for (const int signal : {SIGHUP, SIGINT, SIGTERM}) sigaddset(&ends, signal);
    pthread_sigmask(SIG_BLOCK, &ends, &before_);
  }
  ~SignalsWait() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsWait(const SignalsWait&) = delete;
  SignalsWait& operator=(const SignalsWait&) = delete;

 private:
  sigset_t before_;
};

/// What was fixed, over several files.
struct FixTally {
  std::size_t findings = 0;
  std::size_t files = 0;
  std::map<std::string_view, std::size_t> rules;

  void add(const author::FixedFile& file) {
    ++files;
    for (const auto& [rule, count] : file.applied) {
      findings += count;
      rules[rule] += count;
    }
  }

  /// "3 findings (2 axis-zero, 1 uri-backslash) in 2 files"
  std::string text() const {
    std::vector<std::pair<std::string_view, std::size_t>> most(rules.begin(), rules.end());
    std::stable_sort(most.begin(), most.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    std::string of_rules;
    for (const auto& [rule, count] : most) {
      if (!of_rules.empty()) of_rules += ", ";
      of_rules += std::to_string(count) + " " + std::string(rule);
    }
    return report::counted(findings, "finding") + " (" + of_rules + ") in " +
           report::counted(files, "file");
  }
};

std::string why_held_back(const author::HeldBackFix& fix) {
  switch (fix.why) {
    case author::HeldBack::kBringsFinding: return "it would bring " + std::string(fix.brings);
    case author::HeldBack::kDoesNotHelp: return "what it fixes would still be found";
    case author::HeldBack::kNotXml: return "the file would not be well-formed XML";
    case author::HeldBack::kNotTried: break;
  }
  return "too many were tried before it";
}

void tell_held_back(const FixedFiles& files) {
  std::size_t told = 0;
  std::size_t more = 0;
  for (const author::FixedFile& file : files) {
    for (const author::HeldBackFix& fix : file.held_back) {
      if (told == kMaxHeldBackReported) {
        ++more;
        continue;
      }
      ++told;
      say("not fixed: " + report::printable(file.path) + ": " + std::string(fix.rule) + " (" +
          report::printable(fix.title) + "): " + why_held_back(fix));
    }
    if (!file.settled) {
      say("not fixed to the end: " + report::printable(file.path) + ": another run may fix more");
    }
  }
  if (more > 0) say("not fixed: " + report::counted(more, "more finding"));
}

/// Whether the bytes under a path are those of stdin.
bool is_buffer(const author::FixedFile& file, const rules::ValidateOptions& options) {
  return options.buffer && options.buffer->path == file.path;
}

void write_fixed(const author::FixedFile& file, const std::vector<std::string>& named,
                 const Disk& disk) {
  const SignalsWait wait;
  const ReadResult now = disk.read(file.path, read::kMaxModelBytes);
  if (now.bytes == file.after) return;  // the same file under another name
  if (now.bytes != file.before) {
    throw UsageError(file.path + ": was changed while it was checked, and is left as it is");
  }
  replace_found(named, file.path, file.after);
}

/// All that can be written are, before anything is said of those that can not.
FixTally write_all_fixed(const FixedFiles& files, const rules::ValidateOptions& options,
                         const Disk& disk) {
  FixTally tally;
  std::string failed;
  for (const author::FixedFile& file : files) {
    if (!file.changed()) continue;
    try {
      if (!is_buffer(file, options)) write_fixed(file, options.paths, disk);
      tally.add(file);
    } catch (const UsageError& error) {
      failed += (failed.empty() ? "" : "; ") + std::string(error.what());
    }
  }
  if (failed.empty()) return tally;
  if (tally.files > 0) say("fixed " + tally.text());
  throw UsageError(failed);
}

}  // namespace

void FixOptions::declare(CLI::App& app) {
  app.add_flag("--fix", fix_, "Write safe fixes into the files; of -, to stdout");
  app.add_flag(
      "--unsafe-fixes", unsafe_,
      "With --fix or --diff: also fixes that change mass, inertia, pose, limits or topology");
  app.add_flag("--diff", diff_,
               "Print what --fix would change, and write nothing; exit 1 if anything, or if "
               "there are findings as without it");
}

bool FixOptions::run(const Environment& environment, rules::ValidateOptions& options,
                     const rules::ValidateResult& result, const Sources& sources) const {
  const FixedFiles files = author::fix_files(environment, options, result, sources, most());
  FixTally tally;
  if (diff_) {
    for (const author::FixedFile& file : files) {
      if (!file.changed()) continue;
      tool::write({}, unified_diff(normalize_path(file.path), file.before, file.edits));
      tally.add(file);
    }
  } else {
    tally = write_all_fixed(files, options, environment.disk);
    for (const author::FixedFile& file : files) {
      if (is_buffer(file, options)) options.buffer->bytes = file.after;
    }
    if (options.buffer) tool::write({}, options.buffer->bytes);
  }
  if (tally.files > 0) {
    say((diff_ ? "would fix " : "fixed ") + tally.text());
  } else {
    say("nothing fixed");
  }
  tell_held_back(files);
  return tally.files > 0;
}

void FixOptions::write(const Target& target, std::string_view text,
                       const rules::ValidateOptions& options) const {
  if (!target.file.empty() || !fix_ || !options.buffer) return tool::write(target, text);
  std::fwrite(text.data(), 1, text.size(), stderr);
}

void FixOptions::hint(const Diagnostics& findings) const {
  std::size_t safe = 0;
  std::size_t unsafe = 0;
  for (const Diagnostic& finding : findings.list()) {
    if (author::has_fix(finding, Applicability::kSafe)) {
      ++safe;
    } else if (author::has_fix(finding, Applicability::kUnsafe)) {
      ++unsafe;
    }
  }
  if (asked()) {  // what is safe was tried
    if (unsafe > 0 && !unsafe_)
      say(report::counted(unsafe, "more finding") + " can be fixed with --unsafe-fixes");
  } else if (safe > 0 && unsafe > 0 && !unsafe_) {
    say(report::counted(safe, "finding") + " can be fixed with --fix, " + std::to_string(unsafe) +
        " more with --unsafe-fixes");
  } else if (safe + unsafe > 0) {
    say(report::counted(safe + unsafe, "finding") + " can be fixed with --fix" +
        (unsafe > 0 ? " --unsafe-fixes" : ""));
  }
}

}  // namespace rigor::tool
