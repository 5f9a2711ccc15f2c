// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where causes are looked for. For sources of this room.
//
//   Causes causes{scene, input, wheels};
//   add_inertia_causes(causes);

#pragma once

#include <vector>

#include <rigor/simulate/advice/advice.h>

namespace rigor::simulate {

struct Causes {
  const Scene& scene;
  const SceneInput& input;
  const DriveTrain& wheels;
  struct Weighed {
    Fact fact;
    double weight = 0;  ///< how many times its limit it is
  };
  std::vector<Weighed> all;

  /// From `severe_from` times the limit on it is worth a word even where no run shows it.
  void add(FactKind kind, Fact about, double value, double limit, double weight,
           double severe_from);
};

void add_inertia_causes(Causes& causes);
void add_mass_ratio_causes(Causes& causes);
void add_wheel_causes(Causes& causes);
void add_stance_causes(Causes& causes);
void add_joint_causes(Causes& causes);

}  // namespace rigor::simulate
