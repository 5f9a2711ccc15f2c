// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests that hold for each engine: they are skipped, and say so, where MuJoCo's library is not installed.
//
//   TEST_P(Engines, Falls) { const auto engine = made_engine(scene, hand::stiff()); … }
//   INSTANTIATE_TEST_SUITE_P(Each, Engines, test::kEngines, test::engine_name);

#pragma once

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include <rigor/simulate/engine/engine.h>
#include <rigor/simulate/engine/mujoco/mujoco_engine.h>

namespace rigor::test {

inline std::string engine_name(const testing::TestParamInfo<simulate::EngineKind>& parameter) {
  return parameter.param == simulate::EngineKind::kOde ? "Ode" : "Mujoco";
}

class Engines : public testing::TestWithParam<simulate::EngineKind> {
 protected:
  void SetUp() override {
    if (!is_mujoco()) return;
    const std::string problem = simulate::mujoco_problem({});
    if (!problem.empty()) GTEST_SKIP() << problem;
  }

  bool is_mujoco() const { return GetParam() == simulate::EngineKind::kMujoco; }

  std::unique_ptr<simulate::Engine> made_engine(const simulate::Scene& scene,
                                                simulate::SolverSettings settings) const {
    settings.engine = GetParam();
    return simulate::make_engine(scene, settings);
  }
};

}  // namespace rigor::test
