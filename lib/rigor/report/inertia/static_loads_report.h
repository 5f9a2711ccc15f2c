// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What `inertia --loads` prints: what gravity asks of each joint, beside its effort limit.

#pragma once

#include <string>

#include <rigor/robot/static_loads.h>

namespace rigor::report {

struct LoadTable {
  std::string path;
  const robot::Robot& robot;
  robot::LoadRequest request;
  const robot::StaticLoads& loads;
};

std::string loads_text(const LoadTable& table);
std::string loads_json(const LoadTable& table);

}  // namespace rigor::report
