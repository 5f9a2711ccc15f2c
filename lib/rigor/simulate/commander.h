// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Carries out what a scenario does to a scene, step by step.
//
//   Commander commander(scene, scenario, settings);
//   while (going) { commander.tell(engine); engine.step(); }
//
// Of several commands for one axis the one that began last holds. A ramp rises from what the command
// before it (of the same kind) had come to, else from zero, or from where the axis stands.

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <rigor/simulate/engine/engine.h>
#include <rigor/simulate/scenario.h>
#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

class Commander {
 public:
  /// The three are only referred to.
  Commander(const Scene& scene, const Scenario& scenario, const SolverSettings& settings);

  /// Before each step.
  void tell(Engine& engine);

 private:
  struct Commanded {
    std::uint32_t joint = 0;
    std::uint32_t axis = 0;
    std::size_t index = 0;                 ///< in `State::axes`
    std::vector<const Command*> commands;  ///< by their begin
    const Command* now = nullptr;
    double from = 0;
    double integral = 0;  ///< of a position's error
  };

  void apply(Commanded& commanded, Engine& engine) const;
  void begin(Commanded& commanded, const Command* next, const AxisState& axis, double time) const;
  void reach_position(Commanded& commanded, Engine& engine, const AxisState& axis,
                      double time) const;
  void tilt(Engine& engine, double time) const;

  const Scene& scene_;
  const Scenario& scenario_;
  double step_;
  std::vector<Commanded> commanded_;
};

}  // namespace rigor::simulate
