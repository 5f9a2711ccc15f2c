// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/config/configs.h>

#include <algorithm>
#include <utility>
#include <vector>

#include <rigor/text/path.h>

namespace rigor::config {

Configs::Configs(const Disk& disk, std::string working_folder, ConfigChoice choice)
    : disk_(disk), working_folder_(std::move(working_folder)), choice_(std::move(choice)) {}

std::string Configs::absolute(std::string_view path) const {
  return join_path(working_folder_, path);
}

const Config& Configs::of(std::string_view path) const {
  std::string whole = absolute(path);
  if (disk_.kind(whole) == PathKind::kFolder) return in_folder(std::move(whole));
  return in_folder(std::string(parent_path(whole)));
}

const Config& Configs::beside(std::string_view file) const {
  return in_folder(std::string(parent_path(absolute(file))));
}

const Config& Configs::in_folder(std::string folder) const {
  if (choice_.of == ConfigChoice::Of::kNone) return none_;
  const std::lock_guard lock(mutex_);
  if (choice_.of == ConfigChoice::Of::kFile) return at(absolute(choice_.file));
  std::vector<std::string> passed;
  const Config* found = &none_;
  while (true) {
    if (const auto known = by_folder_.find(folder); known != by_folder_.end()) {
      found = known->second;
      break;
    }
    passed.push_back(folder);
    const std::string candidate = join_path(folder, kConfigName);
    const PathKind kind = disk_.kind(candidate);
    // A link that does not exist was meant as one; reading it says what is wrong. A folder that is not
    // there, as those above a confinement, has none.
    if (kind == PathKind::kFile ||
        (kind == PathKind::kMissing && !disk_.obstacle(candidate).empty() &&
         disk_.kind(folder) == PathKind::kFolder)) {
      found = &at(candidate);
      break;
    }
    const bool repository = disk_.kind(join_path(folder, ".git")) != PathKind::kMissing;
    std::string parent(parent_path(folder));
    if (repository || parent == folder) break;
    folder = std::move(parent);
  }
  for (std::string& each : passed) by_folder_.emplace(std::move(each), found);
  return *found;
}

const Config& Configs::at(const std::string& file) const {
  std::unique_ptr<const Config>& config = by_file_[file];
  if (!config) config = std::make_unique<const Config>(read_chain(file));
  return *config;
}

Config Configs::read_one(const std::string& file) const {
  const ReadResult read = disk_.read(file, kMaxConfigBytes);
  if (read.bytes) return read_config(file, *read.bytes);
  Config config;
  config.files.push_back(file);
  const std::string obstacle = disk_.obstacle(file);
  config.problems.push_back({.message = obstacle.empty() ? read.problem : obstacle, .path = file});
  return config;
}

Config Configs::read_chain(const std::string& file) const {
  std::vector<Config> chain{read_one(file)};
  while (chain.back().extend) {
    Config& last = chain.back();
    const std::string next = join_path(parent_path(last.files.front()), last.extend->value);
    const auto stop = [&last](const std::string& why) {
      last.problems.push_back({last.extend->place.line, why, {}, {}, last.files.front()});
    };
    const auto known = std::find_if(chain.begin(), chain.end(), [&next](const Config& config) {
      return config.files.front() == next;
    });
    if (known != chain.end()) {
      stop(&*known == &last ? "extends itself"
                            : "extends itself: " + last.extend->value + " leads back here");
      break;
    }
    if (chain.size() == kMaxChain) {
      stop("is the last of " + std::to_string(kMaxChain) +
           " files that extend each other; no more are read");
      break;
    }
    if (const PathKind kind = disk_.kind(next); kind != PathKind::kFile) {
      stop("extend: " + last.extend->value +
           (kind == PathKind::kFolder ? ": is a folder" : ": no such file"));
      break;
    }
    chain.push_back(read_one(next));
  }
  Config config = std::move(chain.back());
  for (chain.pop_back(); !chain.empty(); chain.pop_back()) {
    // What the nearest file says of itself stays.
    config = extended(std::move(chain.back()), std::move(config));
  }
  return config;
}

}  // namespace rigor::config
