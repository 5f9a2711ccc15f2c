// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `tools/dev fuzz SECONDS results`: any line as a result that `merge` and `--resume` read, and any bytes as a baseline.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include <rigor/results/line.h>
#include <rigor/rules/baseline.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  rigor::results::case_of(bytes);
  rigor::rules::read_baseline(bytes);
  return 0;
}
