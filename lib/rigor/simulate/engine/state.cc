// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/engine/state.h>

namespace rigor::simulate {

Pose pose_of(const SceneBody& body, const BodyState& state) {
  return {state.p_WBcm - model::rotate(state.R_WB, body.mass.com), state.R_WB};
}

}  // namespace rigor::simulate
