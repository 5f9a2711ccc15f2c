// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "output/own_input.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <rigor/text/path.h>

#include "command/command.h"

namespace rigor::tool {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kReading[] = {"--baseline", "--compare", "--config", "--scenario"};
constexpr std::string_view kInPlace[] = {"mesh-check", "merge", "upgrade"};

template <std::size_t N>
bool is_among(const std::string_view (&list)[N], const std::string& name) {
  return std::find(std::begin(list), std::end(list), name) != std::end(list);
}

/// "FORMAT:FILE" names a file, "FORMAT" does not.
std::string file_of(const std::string& target) {
  const std::size_t colon = target.find(':');
  return colon == std::string::npos ? std::string() : target.substr(colon + 1);
}

struct Files {
  std::vector<std::string> read;
  std::vector<std::string> written;
};

Files files_of(const CLI::App& command) {
  Files files;
  for (const CLI::Option* option : command.get_options()) {
    const bool whole = option->check_name("--out") && !is_among(kInPlace, command.get_name());
    const bool target = option->check_name("--output");
    const bool reads = option->get_positional() ||
                       std::any_of(std::begin(kReading), std::end(kReading), [&](auto name) {
                         return option->check_name(std::string(name));
                       });
    for (const std::string& value : option->results()) {
      if (reads) files.read.push_back(value);
      if (whole) files.written.push_back(value);
      if (target && !file_of(value).empty()) files.written.push_back(file_of(value));
    }
  }
  return files;
}

/// Devices and pipes take what several write.
bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  return fs::is_regular_file(a, error) && fs::equivalent(a, b, error) && !error;
}

}  // namespace

void refuse_outputs_over_inputs(const CLI::App& command) {
  const Files files = files_of(command);
  std::error_code error;
  for (auto written = files.written.begin(); written != files.written.end(); ++written) {
    for (const std::string& read : files.read) {
      if (is_same_file(*written, read))
        throw UsageError(*written + " is also read: nothing is written over it");
    }
    const bool special = fs::exists(*written, error) && !fs::is_regular_file(*written, error);
    const auto again = std::find_if(files.written.begin(), written, [&](const std::string& other) {
      return normalize_path(other) == normalize_path(*written) || is_same_file(other, *written);
    });
    if (again != written && !special) throw UsageError(*written + " is to be written twice");
  }
}

}  // namespace rigor::tool
