// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `tools/dev fuzz SECONDS conversion`: any bytes, as a URDF and as an SDF, through both conversions. What was written
// is well-formed.

#include <cstddef>
#include <cstdint>
#include <string>

#include <rigor/author/conversion.h>
#include <rigor/read/load.h>
#include <rigor/read/workspace.h>
#include <rigor/rules/environment.h>
#include <rigor/xml/document.h>

namespace {

void convert(const std::string& path, const std::string& bytes) {
  static const rigor::MemoryDisk disk;
  static const rigor::Environment environment(disk, {});
  rigor::Sources sources;
  rigor::read::Workspace workspace(disk, sources);
  const rigor::read::Reader reader{workspace, environment.resolver, environment.sdf,
                                   environment.urdf};
  const rigor::read::Loaded loaded = rigor::read::load(reader, workspace.put(path, bytes));
  if (!loaded.file->document || !loaded.file->document->complete()) return;
  rigor::author::ConversionOptions options;
  options.proof = rigor::author::Proof::kNone;  // it has another parser in a process of its own
  options.losses = rigor::author::Losses::kAllowed;
  options.out = path + ".converted";
  const auto result = [&]() -> rigor::author::Conversion {
    switch (loaded.root.format) {
      case rigor::model::Format::kSdf:
        return to_urdf(environment, sources, workspace, loaded, {}, options);
      case rigor::model::Format::kUrdf:
        return to_sdf(environment, sources, workspace, loaded, {}, options);
      case rigor::model::Format::kMjcf:
        from_mjcf_to_urdf(environment, sources, workspace, loaded, {}, options);
        return from_mjcf_to_sdf(environment, sources, workspace, loaded, {}, options);
      default: return {};
    }
  }();
  if (result.text && !rigor::xml::parse(*result.text, rigor::SourceId{}).complete())
    __builtin_trap();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  convert("fuzz.sdf", bytes);
  convert("fuzz.urdf", bytes);
  convert("fuzz.xml", bytes);
  return 0;
}
