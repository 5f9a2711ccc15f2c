// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/environment.h>

#include <stdexcept>
#include <utility>
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

Knowledge::Knowledge()
    : sdf(embedded(schema::sdf_schema_text())), urdf(embedded(schema::urdf_schema_text())) {}

const schema::Schema& Knowledge::mjcf() const {
  std::call_once(mjcf_once_, [this] { mjcf_.emplace(embedded(schema::mjcf_schema_text())); });
  return *mjcf_;
}

Environment::Environment(const Disk& the_disk, read::SearchPaths paths)
    : Environment(the_disk, std::move(paths), {}) {}

Environment::Environment(const Disk& the_disk, read::SearchPaths paths, const std::string& worker,
                         std::shared_ptr<const Knowledge> known)
    : disk(the_disk),
      knowledge(std::move(known)),
      sdf(knowledge->sdf),
      urdf(knowledge->urdf),
      registry(knowledge->registry),
      resolver(the_disk, std::move(paths)),
      workers(worker.empty() ? process::Workers() : process::Workers(worker)) {}

}  // namespace rigor
