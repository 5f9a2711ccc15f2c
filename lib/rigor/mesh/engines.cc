// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/engines.h>

#include <string_view>

#include <libqhull_r/libqhull_r.h>
#include <meshoptimizer.h>

namespace rigor::mesh {

/// Of "2020.2.r 2020/08/31", where the r represents the reentrant library.
std::string qhull_version() {
  std::string_view version = ::qh_version;
  version = version.substr(0, version.find(' '));
  if (version.ends_with(".r")) version.remove_suffix(2);
  return std::string(version);
}

/// 180 is 0.18, and a last digit that is not 0 a mended one of it.
std::string meshoptimizer_version() {
  constexpr int kVersion = MESHOPTIMIZER_VERSION;
  std::string version = std::to_string(kVersion / 1000) + '.' + std::to_string(kVersion / 10 % 100);
  if (kVersion % 10 != 0) version += '.' + std::to_string(kVersion % 10);
  return version;
}

}  // namespace rigor::mesh
