// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The rules on simulations: a row for each kind of `simulate::Fact`, in a file for each group of kinds.
// Their messages may name {name}, {value} and {limit} of the fact, and what is made of these:
// {value_mm} of meters, {value_deg} of radians, {value_percent} of a share, {value_length} with its unit,
// and the same of the limit; {inverse} of the value, {deficit_percent} of a negative one; {unit} and
// {effort_unit} of the joint. What shows a cause has a help, and is so whatever a test shows.

#pragma once

#include <span>

#include <rigor/rules/fact_row.h>
#include <rigor/simulate/fact.h>

namespace rigor::rules::simulation {

using Row = FactRow<simulate::Fact>;

std::span<const Row> refused_rows();
std::span<const Row> as_read_rows();
std::span<const Row> run_rows();
std::span<const Row> stand_rows();
std::span<const Row> drive_rows();
std::span<const Row> joint_rows();
std::span<const Row> cause_rows();

}  // namespace rigor::rules::simulation
