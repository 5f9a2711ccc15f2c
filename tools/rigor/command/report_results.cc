// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "command/report_results.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include <rigor/report/results/results_site.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/results/reader.h>
#include <rigor/results/writer.h>
#include <rigor/text/path.h>

#include "command/command.h"
#include "output/atomic_file.h"
#include "output/output.h"

namespace rigor::tool {
namespace {

void save_page(const std::string& folder, const report::SiteFile& file) {
  const std::string path = join_path(folder, file.path);
  std::error_code error;
  std::filesystem::create_directories(parent_path(path), error);
  if (error)
    throw UsageError(std::string(parent_path(path)) + ": cannot be created: " + error.message());
  replace_file(path, file.bytes);
}

}  // namespace

bool names_results(const std::vector<std::string>& paths) {
  const bool any = std::any_of(paths.begin(), paths.end(), results::names_database);
  if (any && paths.size() > 1)
    throw UsageError("a report is of models, or of one database of results, not of both");
  return any;
}

int report_results(const std::string& database, const std::string& out) {
  if (results::sqlite_version().empty()) refuse_without("SQLite", "report of a database");
  if (!out.ends_with('/') && !std::filesystem::is_directory(out))
    throw UsageError("-o " + out + ": the report of a database is FOLDER/ with a slash at its end");
  std::size_t pages = 0;
  try {
    const results::Reader reader(database);
    report::write_results_site(reader, [&](const report::SiteFile& file) {
      save_page(out, file);
      ++pages;
    });
  } catch (const results::DatabaseError& error) {
    throw UsageError(database + ": " + error.what());
  }
  say("rigor: " + report::counted(pages, "page"));
  return kClean;
}

}  // namespace rigor::tool
