// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which configuration counts for which file: the `rigor.toml` that is nearest above it, and what that
// one extends. The search ends at the root of a repository, which is a folder with `.git`. Nothing is
// merged but what a file extends by name.
//
//   const Configs configs(disk, "/home/me", {});
//   const Config& config = configs.of("robot/worlds/lab.world");
//   for (const Problem& problem : config.problems) complain(problem);
//
// Each file is read once, each folder examined once. Safe across threads.

#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include <rigor/config/config.h>
#include <rigor/text/disk.h>

namespace rigor::config {

inline constexpr std::string_view kConfigName = "rigor.toml";

/// Files in a chain of `extend`. People use two or three.
inline constexpr std::size_t kMaxChain = 16;

struct ConfigChoice {
  enum class Of : std::uint8_t {
    kNearest,
    kFile,  ///< `file` for all
    kNone,
  };
  Of of = Of::kNearest;
  std::string file = {};
};

class Configs {
 public:
  /// `working_folder` is absolute; relative paths begin there.
  Configs(const Disk& disk, std::string working_folder, ConfigChoice choice);

  /// Of a file or folder; one that nothing configures has no `files`. The reference stays valid as long
  /// as this.
  const Config& of(std::string_view path) const;

  /// Of what is in the folder of a file: the same as `of` for a file, without a look at the disk.
  const Config& beside(std::string_view file) const;

  /// The path as a configuration has it: absolute.
  std::string absolute(std::string_view path) const;

  const Disk& disk() const { return disk_; }

 private:
  const Config& in_folder(std::string folder) const;
  const Config& at(const std::string& file) const;
  Config read_chain(const std::string& file) const;
  Config read_one(const std::string& file) const;

  const Disk& disk_;
  std::string working_folder_;
  ConfigChoice choice_;
  Config none_;
  mutable std::mutex mutex_;
  mutable std::map<std::string, const Config*> by_folder_;
  mutable std::map<std::string, std::unique_ptr<const Config>> by_file_;
};

}  // namespace rigor::config
