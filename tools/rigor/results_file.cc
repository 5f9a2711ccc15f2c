// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "results_file.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "command.h"

namespace rigor::tool {

std::optional<CaseNumber> case_of(std::string_view line) {
  const nlohmann::json json = nlohmann::json::parse(line, nullptr, false);
  if (!json.is_object() || !json.contains("case")) return std::nullopt;
  const nlohmann::json& one = json["case"];
  const auto is_count = [&one](const char* key) {
    return one.is_object() && one.contains(key) && one[key].is_number_unsigned();
  };
  if (!is_count("index") || !is_count("of") || one["index"] >= one["of"]) return std::nullopt;
  if (one.contains("id") && !one["id"].is_string()) return std::nullopt;
  const std::string id = one.value("id", std::string());
  return CaseNumber{one["index"].get<std::size_t>(), one["of"].get<std::size_t>(), id};
}

ResultsFile::ResultsFile(std::string path, bool resume) : path_(std::move(path)) {
  if (path_.empty()) return;
  if (resume) read_what_is_there();
  const int flags = O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | (resume ? 0 : O_TRUNC);
  descriptor_ = ::open(path_.c_str(), flags, 0666);
  if (descriptor_ < 0) {
    throw UsageError(path_ + ": cannot be written: " + std::generic_category().message(errno));
  }
}

ResultsFile::~ResultsFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

/// Cuts off a line that was not finished when the run before was ended.
void ResultsFile::read_what_is_there() {
  std::ifstream file(path_, std::ios::binary);
  if (!file) return;
  std::ostringstream all;
  all << file.rdbuf();
  const std::string bytes = all.str();
  const std::size_t whole = bytes.rfind('\n') + 1;  // 0 when there is none
  std::size_t begin = 0;
  for (unsigned number = 1; begin < whole; ++number) {
    const std::size_t end = bytes.find('\n', begin);
    const auto one = case_of(std::string_view(bytes).substr(begin, end - begin));
    if (!one) {
      throw UsageError(path_ + ':' + std::to_string(number) + ": is no result of a run; " +
                       "--resume adds to a file of results only");
    }
    done_.insert(one->index);
    begin = end + 1;
  }
  if (whole == bytes.size()) return;
  std::error_code error;
  std::filesystem::resize_file(path_, whole, error);
  if (error) throw UsageError(path_ + ": cannot be written: " + error.message());
}

void ResultsFile::add(std::string_view line) {
  while (descriptor_ >= 0 && !line.empty()) {
    const ssize_t written = ::write(descriptor_, line.data(), line.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      throw UsageError(path_ + ": cannot be written: " + std::generic_category().message(errno));
    }
    line.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace rigor::tool
