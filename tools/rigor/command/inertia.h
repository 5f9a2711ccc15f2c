// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What `rigor inertia` does, and the options they share.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "option/search.h"
#include "output/output.h"

namespace rigor::tool {

/// What `--only` and `--from` take.
inline constexpr std::string_view kOnlyNames[] = {"missing", "implausible", "all"};
inline constexpr std::string_view kFromNames[] = {"collision", "visual"};

struct InertiaArguments {
  std::string what;  ///< a shape's name, or a model's path
  std::string mesh;  ///< the file, when `what` is "mesh"

  std::vector<std::string> size;
  std::string radius;
  std::string length;
  std::vector<std::string> radii;
  std::vector<std::string> scale;
  std::string hollow;
  std::string pose;
  bool hull = false;

  std::vector<std::string> masses;  ///< KG of a shape, LINK=KG of a model
  std::string density;
  std::string material;

  std::string only;
  std::string from;
  std::vector<std::string> joints;
  bool bake = false;
  bool diff = false;
  bool write = false;

  bool loads = false;
  std::string model;  ///< of several in a file; else empty
  std::string samples;
  std::string seed;

  OutputOptions output;
  SearchOptions search;
};

/// Whether `what` is the name of a shape.
bool is_shape_name(const std::string& what);

/// kg/m³, from --density or --material; nothing when neither is given. A material may be one of the
/// rigor.toml nearest above `path`.
std::optional<double> density_of(const InertiaArguments& arguments, const std::string& path);

/// A block from numbers alone.
int run_solid_inertia(const InertiaArguments& arguments);

/// A model's table, and its edits.
int run_model_inertia(const InertiaArguments& arguments);

/// What gravity asks of a model's joints; 1 where a motor cannot hold its part of the robot.
int run_static_loads(const InertiaArguments& arguments);

}  // namespace rigor::tool
