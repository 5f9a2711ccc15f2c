// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `tools/dev fuzz`: any bytes, through xml, read and rules, from an in-memory disk.

#include <cstddef>
#include <cstdint>
#include <string>

#include <rigor/model/frames.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const rigor::MemoryDisk disk([] {
    rigor::MemoryDisk files;
    files.put("part/model.config",
              "<model><name>p</name><sdf version='1.6'>model.sdf</sdf></model>");
    files.put("part/model.sdf",
              "<sdf version='1.6'><model name='part'><link name='l'/></model></sdf>");
    files.put("part.xml",
              "<mujoco><worldbody><body name='part'><geom size='1'/></body></worldbody></mujoco>");
    files.put("loop.sdf",
              "<sdf version='1.9'><model name='m'><include><uri>loop.sdf</uri>"
              "</include></model></sdf>");
    return files;
  }());
  static const rigor::Environment environment(disk, {});
  // What begins with <mujoco> is MJCF where its name ends as that of MJCF does.
  for (const char* name : {"fuzz.sdf", "fuzz.xml"}) {
    rigor::Sources sources;
    rigor::rules::ValidateOptions options;
    options.buffer = {name, std::string(reinterpret_cast<const char*>(data), size)};
    rigor::rules::validate(environment, options, sources);
  }
  return 0;
}
