// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A value of a configuration, and the place that set it.
//
//   Setting<double> density{42, {"/home/me/robot/rigor.toml", 7}};

#pragma once

#include <string>

namespace rigor::config {

struct Place {
  std::string path;   ///< of the file
  unsigned line = 0;  ///< 1-based
};

template <class T>
struct Setting {
  T value{};
  Place place;
};

using Name = Setting<std::string>;

}  // namespace rigor::config
