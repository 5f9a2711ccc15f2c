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

#pragma once

#include <utility>

#include <rigor/read/resolver.h>
#include <rigor/rules/registry.h>
#include <rigor/schema/schema.h>
#include <rigor/text/disk.h>

namespace rigor {

struct Environment {
  Environment(const Disk& the_disk, read::SearchPaths paths);

  const Disk& disk;
  schema::Schema sdf;
  schema::Schema urdf;
  rules::Registry registry;
  read::Resolver resolver;
};

}  // namespace rigor
