// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The rules on conversions: a row for each kind of `convert::Note`, in a file for each group of kinds.
// Their messages may name {written}, {instead}, {count} and {target} of the note, and {whereabouts}: "is lost"
// or "is for Gazebo only".

#pragma once

#include <span>

#include <rigor/convert/note.h>
#include <rigor/rules/fact_row.h>

namespace rigor::rules::conversion {

using Row = FactRow<convert::Note>;

std::span<const Row> file_rows();
std::span<const Row> graph_rows();
std::span<const Row> joint_rows();
std::span<const Row> link_rows();
std::span<const Row> shape_rows();
std::span<const Row> carried_rows();
std::span<const Row> proof_rows();
std::span<const Row> mjcf_rows();
std::span<const Row> from_mjcf_rows();

}  // namespace rigor::rules::conversion
