// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The tests that `simulate` knows, as scenarios made for a scene.
//
//   std::optional<Scenario> drive = make_test("drive", scene, wheels);

#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/simulate/scenario.h>
#include <rigor/simulate/scene/scene.h>
#include <rigor/simulate/wheels.h>

namespace rigor::simulate {

inline constexpr std::array<std::string_view, 9> kTestNames{
    "settle", "drop", "drive", "turn", "brake", "push", "joint-sweep", "hold", "tilt-table"};

struct MadeTest {
  std::optional<Scenario> scenario;
  std::string why_not;  ///< "no wheels found: …"
  std::string note;     ///< what of the model it leaves out
};

MadeTest make_test(std::string_view name, const Scene& scene, const DriveTrain& wheels);

}  // namespace rigor::simulate
