// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/environment.h>

#include <stdexcept>
#include <variant>

#include <rigor/schema/embedded.h>

namespace rigor {
namespace {

schema::Schema embedded(std::string_view text) {
  auto parsed = schema::Schema::parse(text);
  if (const auto* fault = std::get_if<schema::Schema::Fault>(&parsed)) {
    throw std::logic_error("embedded schema, line " + std::to_string(fault->line) + ": " +
                           fault->message);
  }
  return std::get<schema::Schema>(std::move(parsed));
}

}  // namespace

Environment::Environment(const Disk& the_disk, read::SearchPaths paths)
    : disk(the_disk),
      sdf(embedded(schema::sdf_schema_text())),
      urdf(embedded(schema::urdf_schema_text())),
      mjcf(embedded(schema::mjcf_schema_text())),
      resolver(the_disk, std::move(paths)) {}

Environment::Environment(const Disk& the_disk, read::SearchPaths paths, std::string worker)
    : disk(the_disk),
      sdf(embedded(schema::sdf_schema_text())),
      urdf(embedded(schema::urdf_schema_text())),
      mjcf(embedded(schema::mjcf_schema_text())),
      resolver(the_disk, std::move(paths)),
      workers(std::move(worker)) {}

}  // namespace rigor
