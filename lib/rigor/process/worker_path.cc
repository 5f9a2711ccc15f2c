// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/process/worker_path.h>

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include <rigor/text/path.h>

namespace rigor::process {
namespace {

constexpr std::string_view kWorkerName = "/rigor-worker";

std::string in_libexec_of(std::string_view programs) {
  return std::string(parent_path(programs)) + "/libexec" + std::string(kWorkerName);
}

/// The number in hexadecimal that a text begins with; zero without one.
std::uintptr_t address_in(std::string_view text) {
  std::uintptr_t value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value, 16);
  return value;
}

/// Empty where the system does not tell.
std::string folder_of_this_code() {
  std::ifstream stream("/proc/self/maps");
  const std::string maps{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  const auto here = reinterpret_cast<std::uintptr_t>(&find_worker);
  const std::optional<std::string> file = file_mapped_at(maps, here);
  return file ? std::string(parent_path(*file)) : std::string();
}

}  // namespace

std::optional<std::string> file_mapped_at(std::string_view maps, std::uintptr_t address) {
  while (!maps.empty()) {
    const std::string_view line = maps.substr(0, maps.find('\n'));
    maps.remove_prefix(std::min(line.size() + 1, maps.size()));
    const std::size_t dash = line.find('-');
    const std::size_t path = line.find('/');
    if (dash == std::string_view::npos || path == std::string_view::npos) continue;
    if (address < address_in(line) || address >= address_in(line.substr(dash + 1))) continue;
    return std::string(line.substr(path));
  }
  return std::nullopt;
}

WorkerProgram find_worker() {
  const char* search_path = std::getenv("PATH");
  return find_worker_from(folder_of_this_code(), search_path ? search_path : "");
}

WorkerProgram find_worker_from(const std::string& folder, std::string_view search_path) {
  WorkerProgram found;
  if (!folder.empty()) {
    found.looked_for = {folder + std::string(kWorkerName), in_libexec_of(folder)};
  }
  found.looked_for.push_back(RIGOR_LIBEXEC + std::string(kWorkerName));
  std::vector<std::string> candidates = found.looked_for;
  while (!search_path.empty()) {
    const std::string_view each = search_path.substr(0, search_path.find(':'));
    search_path.remove_prefix(std::min(each.size() + 1, search_path.size()));
    if (is_absolute(each)) candidates.push_back(in_libexec_of(each));
  }
  const auto known =
      std::find_if(candidates.begin(), candidates.end(),
                   [](const std::string& path) { return ::access(path.c_str(), X_OK) == 0; });
  if (known != candidates.end()) found.path = *known;
  return found;
}

std::string path_beside_worker(std::string_view name) {
  const WorkerProgram worker = find_worker();
  const std::filesystem::path found = worker.path.value_or(worker.looked_for.front());
  std::error_code error;
  const std::filesystem::path program = std::filesystem::canonical(found, error);
  return ((error ? found : program).parent_path() / name).string();
}

}  // namespace rigor::process
