// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `tools/dev fuzz SECONDS scenario`: any bytes as a scenario of `simulate`.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include <rigor/config/scenario.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rigor::config::read_scenario("fuzz.scenario.toml",
                               std::string_view(reinterpret_cast<const char*>(data), size));
  return 0;
}
