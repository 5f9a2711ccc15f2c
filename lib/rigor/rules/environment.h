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

#include <string>
#include <utility>

#include <rigor/process/workers.h>
#include <rigor/read/resolver.h>
#include <rigor/rules/registry.h>
#include <rigor/schema/schema.h>
#include <rigor/text/disk.h>

namespace rigor {

struct Environment {
  Environment(const Disk& the_disk, read::SearchPaths paths);
  /// The same with the worker's program at a path.
  Environment(const Disk& the_disk, read::SearchPaths paths, std::string worker);

  const Disk& disk;
  schema::Schema sdf;
  schema::Schema urdf;
  schema::Schema mjcf;
  rules::Registry registry;
  read::Resolver resolver;
  process::Workers workers;
};

}  // namespace rigor
