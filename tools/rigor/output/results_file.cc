// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "output/results_file.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <variant>

#include <fcntl.h>
#include <unistd.h>

#include <rigor/results/line.h>
#include <rigor/text/write_all.h>

#include "command/command.h"
#include "output/atomic_file.h"

namespace rigor::tool {
namespace {

/// Nothing when the line is no result of a simulation.
std::optional<KeptResult> kept_in(const std::string& line) {
  std::optional<results::Record> record = results::record_of(line);
  auto* const made = record ? std::get_if<results::SimulatedCase>(&*record) : nullptr;
  if (made == nullptr) return std::nullopt;
  KeptResult kept{std::move(made->one), std::move(made->model), {}, std::nullopt};
  // With two engines each test is run twice, one after the other.
  for (results::Run& run : made->runs) {
    if (kept.tests.empty() || kept.tests.back() != run.test)
      kept.tests.push_back(std::move(run.test));
  }
  for (const Severity severity : {Severity::kInfo, Severity::kWarning, Severity::kError}) {
    const bool any = std::any_of(
        made->findings.begin(), made->findings.end(),
        [&](const results::Finding& each) { return each.severity == to_string(severity); });
    if (any) kept.worst = severity;
  }
  return kept;
}

}  // namespace

ResultsFile::~ResultsFile() { close(); }

int ResultsFile::close() { return descriptor_.close(); }

void ResultsFile::fail(int error) const {
  throw UsageError(path_ + ": cannot be written: " + std::generic_category().message(error));
}

void ResultsFile::read(const std::function<void(const KeptResult&, const std::string&)>& each) {
  keeps_ = true;
  std::error_code ignored;
  if (!std::filesystem::exists(path_, ignored)) return;
  std::ifstream file(path_, std::ios::binary);
  std::string line;
  // A line that ends with the file was not finished when the run before was ended.
  for (unsigned number = 1; std::getline(file, line) && !file.eof(); ++number) {
    const std::string where = path_ + ':' + std::to_string(number);
    const std::optional<KeptResult> kept = kept_in(line);
    if (!kept) {
      throw UsageError(where +
                       ": is no result of a simulation; --resume adds to a file of such "
                       "results only");
    }
    each(*kept, where);
    kept_.insert(kept->one.index);
    order_.push_back(kept->one.index);
    whole_ += line.size() + 1;
  }
  // What could not be read is not to be cut off as torn.
  if (!file.eof()) throw UsageError(path_ + ": cannot be read");
}

void ResultsFile::open() {
  if (path_.empty()) return;
  const int flags = O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | (keeps_ ? 0 : O_TRUNC);
  descriptor_ = process::Descriptor(::open(path_.c_str(), flags, 0666));
  if (descriptor_.number() < 0) fail(errno);
  std::error_code error;
  const bool torn = keeps_ && std::filesystem::is_regular_file(path_, error) &&
                    std::filesystem::file_size(path_, error) > whole_;
  if (torn) std::filesystem::resize_file(path_, whole_, error);
  if (error) fail(error.value());
}

void ResultsFile::add(std::size_t index, std::string_view line) {
  if (descriptor_.number() < 0) return;
  if (const int error = write_all(descriptor_.number(), line)) fail(error);
  order_.push_back(index);
}

void ResultsFile::finish() {
  // A pipe has nothing to synchronize, and says so.
  if (descriptor_.number() >= 0 && ::fsync(descriptor_.number()) != 0 && errno != EINVAL)
    fail(errno);
  if (const int error = close()) fail(error);
  if (std::is_sorted(order_.begin(), order_.end())) return;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path_, ignored)) return;  // a pipe is read already
  std::ifstream file(path_, std::ios::binary);
  std::vector<std::pair<std::size_t, std::string>> lines;
  std::string line;
  while (lines.size() < order_.size() && std::getline(file, line)) {
    lines.emplace_back(order_[lines.size()], line + '\n');
  }
  // Somebody else has written to it: which line is whose is not known.
  if (lines.size() != order_.size() || file.peek() != std::ifstream::traits_type::eof()) return;
  std::stable_sort(lines.begin(), lines.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string all;
  for (const auto& [index, text] : lines) all += text;
  replace_file(path_, all);
}

}  // namespace rigor::tool
