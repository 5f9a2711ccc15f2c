// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xacro/expand.h>

#include <rigor/xacro/expander.h>

namespace rigor::xacro {

Expansion expand(const std::string& path, const World& world, const Options& options,
                 Sources& sources) {
  return Expander(world, options, sources).run(path);
}

}  // namespace rigor::xacro
