// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// MuJoCo's functions, opened with dlopen: nothing is linked to it, and no run without it loads it. Its structs have
// another layout in every version, so only the version whose headers rigor was built with is used; another one is
// named in `problem`. For sources of this folder, and for a worker only.
//
//   const MujocoLibrary mujoco = open_mujoco({});
//   if (!mujoco.problem.empty()) throw EngineError(mujoco.problem);
//   mujoco.step1(model, data);

#pragma once

#include <string>

#include <mujoco/mujoco.h>

namespace rigor::simulate {

struct MujocoLibrary {
  std::string problem;  ///< why there is none; empty when all is well

  decltype(&mj_loadXML) load_xml = nullptr;
  decltype(&mj_deleteModel) delete_model = nullptr;
  decltype(&mj_makeData) make_data = nullptr;
  decltype(&mj_deleteData) delete_data = nullptr;
  decltype(&mj_step1) step1 = nullptr;
  decltype(&mj_step2) step2 = nullptr;
  decltype(&mj_fwdVelocity) forward_velocity = nullptr;
  decltype(&mj_makeConstraint) make_constraint = nullptr;
  decltype(&mj_projectConstraint) project_constraint = nullptr;
  decltype(&mj_objectVelocity) object_velocity = nullptr;
  decltype(&mj_contactForce) contact_force = nullptr;
  /// Handlers of the whole process.
  void (**user_error)(const char*) = nullptr;
  void (**user_warning)(const char*) = nullptr;
};

/// `path`: of a libmujoco.so; empty for the installed one.
MujocoLibrary open_mujoco(const std::string& path);

}  // namespace rigor::simulate
