// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "project/cache.h"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

#include <rigor/report/tool.h>
#include <rigor/text/path.h>
#include <rigor/text/store/file_stamp.h>

namespace rigor::tool {
namespace {

namespace fs = std::filesystem;

std::string setting(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// Empty without a home. XDG base directory specification 0.8: a relative path is to be ignored.
std::string cache_folder() {
  if (const std::string caches = setting("XDG_CACHE_HOME"); is_absolute(caches)) {
    return caches + "/rigor";
  }
  const std::string home = setting("HOME");
  return is_absolute(home) ? home + "/.cache/rigor" : "";
}

/// Versions are few, builds are many: one that was changed must not believe what the last one found.
std::string this_program() {
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  const auto time = fs::last_write_time(self, error).time_since_epoch().count();
  const std::uintmax_t bytes = fs::file_size(self, error);
  return std::string(report::tool_version()) + ' ' + std::to_string(time) + ' ' +
         std::to_string(bytes);
}

}  // namespace

void CacheOption::declare(CLI::App& app) {
  app.add_flag("--no-cache", off_,
               "Do not use or keep cached results of large meshes; so does RIGOR_CACHE=off");
}

std::optional<mass::MeshCache> CacheOption::cache(const process::Workers& workers) const {
  const std::string folder = cache_folder();
  if (off_ || setting("RIGOR_CACHE") == "off" || folder.empty()) return std::nullopt;
  return mass::MeshCache(FolderStore(folder), this_program(), workers,
                         mass::MeshCache::kMinTriangles, stamp_of);
}

}  // namespace rigor::tool
