// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the whole library works with: built once in `main`, or by whoever uses the library, and passed
// on by const reference. It takes the place of every global.
//
//   RealDisk disk;
//   Sources sources;
//   Environment environment(disk, read::search_paths_from(get_environment_variable));
//   rules::ValidateResult result = rules::validate(environment, {.paths = {"models"}}, sources);
//
// What may crash or hang (importers of scenes, the engine of simulations, another parser of URDF) runs in
// workers: the program `rigor-worker`, which is installed with the library and found by itself
// (process/worker_path.h), or named here. Without it all else works, and what needs it says so.

#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include <rigor/process/workers.h>
#include <rigor/read/resolver.h>
#include <rigor/rules/registry.h>
#include <rigor/schema/schema.h>
#include <rigor/text/disk.h>

namespace rigor {

/// What the library knows of the formats and what it checks: the same in every environment, which may share it, also
/// across threads. It takes some milliseconds to make.
class Knowledge {
 public:
  Knowledge();

  const schema::Schema sdf;
  const schema::Schema urdf;
  const rules::Registry registry;

  /// Of MJCF: parsed by the first request, since it is as long as the others and few files need it.
  const schema::Schema& mjcf() const;

 private:
  mutable std::once_flag mjcf_once_;
  mutable std::optional<schema::Schema> mjcf_;
};

struct Environment {
  Environment(const Disk& the_disk, read::SearchPaths paths);
  /// With the worker's program at a path, which is looked for when it is empty, and what another environment knows.
  Environment(const Disk& the_disk, read::SearchPaths paths, const std::string& worker,
              std::shared_ptr<const Knowledge> known = std::make_shared<const Knowledge>());
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

  const Disk& disk;
  std::shared_ptr<const Knowledge> knowledge;
  const schema::Schema& sdf;
  const schema::Schema& urdf;
  const rules::Registry& registry;
  read::Resolver resolver;
  process::Workers workers;

  const schema::Schema& mjcf() const { return knowledge->mjcf(); }
};

}  // namespace rigor
