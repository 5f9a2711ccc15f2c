// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// MuJoCo as a whole, for as long as an engine lives: its library, handlers that throw and count, a model and its
// data. Private to the folder.
//
//   const MujocoSession session(text.xml, path);
//   session.mujoco.step1(session.model(), session.data());

#pragma once

#include <cstdint>
#include <string>

#include <rigor/simulate/engine/mujoco/library.h>

namespace rigor::simulate {

class MujocoSession {
 public:
  /// Compiles a model. An EngineError with MuJoCo's words where it does not.
  MujocoSession(const std::string& xml, const std::string& library);
  ~MujocoSession();
  MujocoSession(const MujocoSession&) = delete;
  MujocoSession& operator=(const MujocoSession&) = delete;

  mjModel* model() const { return model_; }
  mjData* data() const { return data_; }
  /// Warnings since it was made.
  std::uint64_t messages() const;

  MujocoLibrary mujoco;

 private:
  std::uint64_t messages_before_ = 0;
  mjModel* model_ = nullptr;
  mjData* data_ = nullptr;
};

}  // namespace rigor::simulate
