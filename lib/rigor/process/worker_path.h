// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where the worker's program is, `rigor-worker`. It is of the same build as the library, and is installed with
// it: in `libexec`, or beside the program that the library is linked into.
//
//   const WorkerProgram found = find_worker();
//   if (!found.path) say("rigor-worker is missing: looked for " + join(found.looked_for));

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rigor::process {

struct WorkerProgram {
  std::optional<std::string> path;
  std::vector<std::string> looked_for;  ///< the paths, in their order, before those of PATH
};

/// In order: beside the file that this library's code is in (a program, or the shared library); in
/// `../libexec` of that; in the `libexec` that rigor was configured with; in `../libexec` of the folders in
/// PATH, where an installed rigor is that somebody else's program is built with.
WorkerProgram find_worker();

/// The same from the folder of a program, which may be empty, and the text of PATH.
WorkerProgram find_worker_from(const std::string& folder, std::string_view search_path);

/// A module of rigor's, which is installed beside the worker. In a build, programs may have a link to the worker
/// alone: its place is where that leads. The file need not be there.
std::string path_beside_worker(std::string_view name);

/// From the text of /proc/self/maps (man 5 proc): the file that an address of this process is mapped from.
/// Of a program that was started as an argument of the dynamic loader, /proc/self/exe names the loader.
std::optional<std::string> file_mapped_at(std::string_view maps, std::uintptr_t address);

}  // namespace rigor::process
