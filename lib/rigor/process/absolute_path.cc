// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/process/absolute_path.h>

#include <filesystem>
#include <system_error>

#include <rigor/text/path.h>

namespace rigor::process {

std::string absolute_path(std::string_view path) {
  std::error_code error;
  return join_path(std::filesystem::current_path(error).string(), path);
}

}  // namespace rigor::process
