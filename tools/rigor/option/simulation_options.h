// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What `simulate` is asked to do: tests, scenarios, commands, the solver, grids and shards.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include <rigor/author/simulation.h>
#include <rigor/simulate/sweep.h>
#include <rigor/text/disk.h>
#include <rigor/text/shard.h>

#include "option/shard_option.h"

namespace rigor::tool {

class SimulationChoices {
 public:
  void declare(CLI::App& app);

  /// A UsageError when a value is none, or a scenario file cannot be used.
  author::SimulationOptions options(const Disk& disk) const;

  /// The points of the grid times the seeds; `seeds` may come from a scenario file.
  std::vector<simulate::Case> cases(const simulate::Plan& plan) const;

  Shard shard() const { return shard_.shard(); }

  /// Of `--joint NAME=VALUE`: where the run begins.
  const std::vector<std::string>& joints() const { return joints_; }
  const std::vector<std::string>& scenarios() const { return scenarios_; }

  /// Models that scenario files name, from where they stand.
  std::vector<std::string> models_of(const simulate::Plan& plan) const;

 private:
  simulate::Plan plan(const Disk& disk) const;
  config::ScenarioFile commanded() const;

  std::vector<std::string> tests_, scenarios_, commands_, wheels_, joints_, gravity_, grid_;
  std::string duration_, ramp_, time_step_, solver_, iterations_, seed_, seeds_, profile_, meshes_;
  std::string model_, jobs_, base_, budget_, engine_, mujoco_;
  ShardOption shard_;
  bool no_confirm_ = false;
};

}  // namespace rigor::tool
