// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where facts of large meshes are kept between runs: `$XDG_CACHE_HOME/rigor`, else `~/.cache/rigor`.
// `--no-cache` and RIGOR_CACHE=off turn that off; without a home there is none.

#pragma once

#include <optional>

#include <rigor/mass/mesh/cache.h>
#include <rigor/process/workers.h>
#include <CLI/CLI.hpp>

namespace rigor::tool {

class CacheOption {
 public:
  void declare(CLI::App& app);

  /// The workers outlive it.
  std::optional<mass::MeshCache> cache(const process::Workers& workers) const;

 private:
  bool off_ = false;
};

}  // namespace rigor::tool
