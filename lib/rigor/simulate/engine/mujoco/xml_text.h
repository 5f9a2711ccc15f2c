// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers and poses as attributes of MuJoCo's text. Private to the folder.
//
//   text += attribute("pos", p_B);

#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

/// The shortest decimal that is read as the same number; a bound where it is infinite, which MuJoCo does not read.
std::string number_text(double value);

/// ` name="1 2 3"`.
std::string attribute(std::string_view name, std::initializer_list<double> values);
std::string attribute(std::string_view name, const Vector3& v);
std::string attribute(std::string_view name, std::string_view text);

/// ` pos="…" quat="…"`.
std::string pose_attributes(const Pose& X);

}  // namespace rigor::simulate
