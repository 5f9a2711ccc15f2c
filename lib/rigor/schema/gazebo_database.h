// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Gazebo classic's public database of models. What a world includes from there is downloaded when it is
// not installed, so that it is missing here says nothing about the world.
//
//   if (in_gazebo_database("sun")) note(not_looked_at);

#pragma once

#include <string_view>

namespace rigor::schema {

bool in_gazebo_database(std::string_view model);

}  // namespace rigor::schema
