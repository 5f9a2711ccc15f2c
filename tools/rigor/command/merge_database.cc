// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "command/merge_database.h"

#include <optional>
#include <string_view>

#include <rigor/report/terminal/summary.h>
#include <rigor/results/parts.h>
#include <rigor/results/writer.h>
#include <rigor/text/disk.h>

#include "command/command.h"
#include "output/output.h"

namespace rigor::tool {
namespace {

using results::ResultKind;

std::string case_name(ResultKind kind, std::uint64_t index) {
  return "case " + std::to_string(index) + " of " +
         (kind == ResultKind::kValidate ? "validate" : "simulate");
}

/// What is missing or doubled, on stderr.
void say_problems(const results::Completeness& found) {
  for (const auto& doubled : found.first_doubled) {
    say("rigor: " + case_name(doubled.kind, doubled.index) + " is in " + doubled.first +
        " and in " + doubled.second);
  }
  for (const auto& missing : found.first_missing)
    say("rigor: " + case_name(missing.kind, missing.index) + " is missing");
  const std::uint64_t all = found.missing + found.doubled;
  const std::size_t listed = found.first_missing.size() + found.first_doubled.size();
  if (all > listed) say("rigor: and " + std::to_string(all - listed) + " more");
  say("rigor: " + report::counted(all, "case") + " missing or doubled; nothing is written");
}

void write_database(const results::Parts& parts, const std::string& out) {
  try {
    results::Writer writer(out);
    const auto problem = parts.each([&writer](const results::Record& one) { writer.add(one); });
    if (problem) throw UsageError(*problem);
    writer.finish();
  } catch (const results::DatabaseError& error) {
    throw UsageError(out + ": cannot be written: " + error.what());
  }
}

}  // namespace

int merge_database(const std::vector<std::string>& files, const std::string& out) {
  if (results::sqlite_version().empty()) refuse_without("SQLite", "merge into a database");
  const RealDisk disk;
  results::Parts parts(disk);
  for (const std::string& file : files) {
    if (const auto problem = parts.add(file)) throw UsageError(*problem);
  }
  const std::uint64_t checked = parts.cases(ResultKind::kValidate);
  const std::uint64_t simulated = parts.cases(ResultKind::kSimulate);
  if (checked + simulated == 0) throw UsageError("the files contain no results");
  const results::Completeness found = parts.sort();
  if (found.missing + found.doubled > 0) {
    say_problems(found);
    return kFindings;
  }
  write_database(parts, out);
  say("rigor: " + report::counted(checked, "file") + " checked, " +
      report::counted(simulated, "case") + " simulated, of " +
      report::counted(files.size(), "file"));
  return kClean;
}

}  // namespace rigor::tool
