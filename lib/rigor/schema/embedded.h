// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The schema files of this repository, as bytes in the program: the build writes the source file
// that defines these functions from schemas/*.schema. The bytes live as long as the program, so
// views into them never dangle.
//
//   auto parsed = Schema::parse(sdf_schema_text());
#pragma once

#include <string_view>

namespace rigor::schema {

std::string_view sdf_schema_text();
std::string_view urdf_schema_text();
std::string_view mjcf_schema_text();

// The colors of Gazebo's own material script, by name: schemas/gazebo.materials.
std::string_view gazebo_materials_text();

// The models of Gazebo classic's public database: schemas/gazebo.models.
std::string_view gazebo_models_text();

// What consumers read beyond the formats: schemas/dialects.table.
std::string_view dialects_table_text();

}  // namespace rigor::schema
