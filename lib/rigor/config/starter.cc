// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/config/starter.h>

namespace rigor::config {

std::string_view starter_config() {
  return R"(# What rigor does in this folder and below. Every line is a comment: take a "#" away to use it.
# `rigor validate --show-config FILE` tells what holds for a file, and why.

# Another file to begin with, from where this one stands. What is said here goes before.
#extend = "../rigor.toml"

# The topmost configuration of a project: nothing above it is looked at.
#root = true

# Rules, or whole categories, that run: all when this is left out. `rigor rules` lists them.
#select = ["xml", "schema", "reference", "inertia"]

# Rules or categories that do not run.
#ignore = ["mesh-tiny-component"]

# The least severity that makes the exit code 1: "error", "warning", "info" or "never".
#fail-on = "warning"

# Consumers whose own rules run as well: "gazebo-classic", "gz-sim", "ros", "mujoco", "isaac",
# "bullet".
#target = ["gz-sim", "ros"]

# What is passed over in folders, as in a .gitignore that stands beside this file.
#exclude = ["third_party/", "*.generated.sdf"]

# Findings that are known and not shown; `rigor validate --baseline-write rigor.baseline` writes it.
#baseline = "rigor.baseline"

# How severe a rule is: "error", "warning", "info" or "off".
#[severity]
#axis-not-unit = "warning"

# What holds for some files only.
#[[per-file]]
#files = ["worlds/**"]
#select = ["world", "reference"]
#ignore = ["plugin"]
#severity = {axis-not-unit = "off"}

# Where model:// and package:// lead, before the environment's variables are asked.
#[resolve]
#paths = ["models"]
#packages = {my_robot_description = "../my_robot_description"}

# How `rigor fmt` lays files out: spaces a level or "tab", columns, quotes of attributes, order of children.
#[format]
#indent = 2
#width = 120
#quotes = "double"
#order  = "keep"      # or "canonical": children as the schema lists them

# Densities in kg/m³, for `rigor inertia --material`.
#[materials]
#our-foam = 42

# The arguments that a xacro file is expanded with, in place of its defaults.
#[[xacro]]
#file = "urdf/arm.urdf.xacro"
#arguments = [{side = "left"}, {side = "right"}]
)";
}

}  // namespace rigor::config
