// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "output/results_file.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "command/command.h"
#include "output/atomic_file.h"

namespace rigor::tool {
namespace {

using Json = nlohmann::json;

std::optional<CaseNumber> case_in(const Json& json) {
  if (!json.is_object() || !json.contains("case")) return std::nullopt;
  const Json& one = json["case"];
  const auto is_count = [&one](const char* key) {
    return one.is_object() && one.contains(key) && one[key].is_number_unsigned();
  };
  if (!is_count("index") || !is_count("of") || one["index"] >= one["of"]) return std::nullopt;
  if (one.contains("id") && !one["id"].is_string()) return std::nullopt;
  const std::string id = one.value("id", std::string());
  return CaseNumber{one["index"].get<std::size_t>(), one["of"].get<std::size_t>(), id};
}

/// The text under a key; nothing when there is none.
std::optional<std::string> text_in(const Json& json, const char* key) {
  if (!json.is_object() || !json.contains(key) || !json[key].is_string()) return std::nullopt;
  return json[key].get<std::string>();
}

/// The text under a key of each entry of a list; nothing when any has none.
std::optional<std::vector<std::string>> texts_in(const Json& json, const char* list,
                                                 const char* key) {
  if (!json.is_object() || !json.contains(list) || !json[list].is_array()) return std::nullopt;
  std::vector<std::string> texts;
  for (const Json& entry : json[list]) {
    const std::optional<std::string> text = text_in(entry, key);
    if (!text) return std::nullopt;
    texts.push_back(*text);
  }
  return texts;
}

/// Nothing when the line is no result of a simulation.
std::optional<KeptResult> kept_in(const std::string& line) {
  const Json json = Json::parse(line, nullptr, false);
  const std::optional<CaseNumber> one = case_in(json);
  const std::optional<std::string> model = text_in(json, "model");
  const auto tests = texts_in(json, "runs", "test");
  const auto severities = texts_in(json, "diagnostics", "severity");
  if (!one || !model || !tests || !severities) return std::nullopt;
  KeptResult kept{*one, *model, *tests, std::nullopt};
  // With two engines each test is run twice, one after the other.
  kept.tests.erase(std::unique(kept.tests.begin(), kept.tests.end()), kept.tests.end());
  for (const Severity severity : {Severity::kInfo, Severity::kWarning, Severity::kError}) {
    const std::string_view name = to_string(severity);
    if (std::find(severities->begin(), severities->end(), name) != severities->end()) {
      kept.worst = severity;
    }
  }
  return kept;
}

}  // namespace

std::optional<CaseNumber> case_of(std::string_view line) {
  return case_in(Json::parse(line, nullptr, false));
}

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
  while (!line.empty()) {
    const ssize_t written = ::write(descriptor_.number(), line.data(), line.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(errno);
    line.remove_prefix(static_cast<std::size_t>(written));
  }
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
