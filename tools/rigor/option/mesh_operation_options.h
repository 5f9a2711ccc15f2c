// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What `rigor mesh-check` may do to a mesh, from its options.

#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include <rigor/author/mesh_operations.h>

namespace rigor::tool {

class MeshOperationOptions {
 public:
  void declare(CLI::App& app);

  /// The name of an option that changes the mesh; empty when none is given.
  std::string given() const;

  bool says_unit() const { return !unit_.empty(); }

  /// A UsageError when values are no numbers or names, or options contradict each other.
  author::MeshOperations operations() const;

 private:
  void set_product(author::MeshOperations& operations) const;

  std::string center_;
  std::vector<std::string> scale_;
  std::string unit_;
  std::string up_;
  bool weld_ = false;
  bool repair_ = false;
  std::string normals_;
  std::string reduce_;
  std::string max_error_;
  bool keep_seams_ = false;
  bool convex_hull_ = false;
  std::string convex_pieces_;
  std::string split_;
  std::string fit_;
};

}  // namespace rigor::tool
