// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `tools/dev fuzz SECONDS config`: any bytes as a rigor.toml, and as one that it extends.

#include <cstddef>
#include <cstdint>
#include <string>

#include <rigor/config/configs.h>
#include <rigor/text/disk.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  rigor::MemoryDisk disk;
  disk.put("/project/rigor.toml", bytes);
  disk.put("/project/inner/rigor.toml", "extend = \"../rigor.toml\"\n" + bytes);
  disk.put("/project/inner/model.sdf", "<sdf version='1.9'/>");
  const rigor::config::Configs configs(disk, "/project", {});
  configs.of("/project/inner/model.sdf");
  configs.of("/project");
  return 0;
}
