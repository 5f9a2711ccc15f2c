// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/schema/schema.h>

#include <utility>
#include <variant>

#include <rigor/schema/embedded.h>
#include <rigor/schema/export.h>
#include "command/command.h"
#include "output/output.h"

namespace rigor::tool {
namespace {

/// The schema files are part of the program: one that does not parse is a bug.
schema::Schema parsed(std::string_view text) {
  auto result = schema::Schema::parse(text);
  if (const auto* fault = std::get_if<schema::Schema::Fault>(&result)) {
    throw std::logic_error("embedded schema: " + fault->message);
  }
  return std::get<schema::Schema>(std::move(result));
}

class SchemaCommand final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app = add_command(program, "schema", "Print a format's elements",
                                {"rigor schema 1.9", "rigor schema urdf --xsd"});
    app->add_option("version", version_, "Of SDFormat, as 1.9; or urdf")
        ->required()
        ->type_name("VERSION");
    CLI::Option* docs = app->add_flag("--docs", docs_, "As a reference page in Markdown (default)");
    app->add_flag("--xsd", xsd_, "As an XML Schema, for editors")->excludes(docs);
    return app;
  }

  int run() override {
    const bool urdf = version_ == "urdf";
    const schema::Schema schema =
        parsed(urdf ? schema::urdf_schema_text() : schema::sdf_schema_text());
    const schema::Version version = urdf ? schema.latest() : sdf_version(schema);
    // Before SDF 1.3 the root was <gazebo>.
    const std::string_view root = urdf ? "robot" : schema.root("sdf", version) ? "sdf" : "gazebo";
    const std::optional<std::string> text =
        xsd_ ? to_xsd(schema, version, root) : to_docs(schema, version, root);
    if (!text) throw std::logic_error("embedded schema: no root " + std::string(root));
    write({0, {}}, *text);
    return kClean;
  }

 private:
  schema::Version sdf_version(const schema::Schema& schema) const {
    const std::optional<schema::Version> version = schema::parse_version(version_);
    if (version && schema.knows(*version)) return *version;
    std::string known;
    for (const schema::Version each : schema.versions()) known += to_string(each) + ", ";
    throw UsageError("unknown format \"" + version_ + "\"; known are " + known + "urdf");
  }

  std::string version_;
  bool docs_ = false;
  bool xsd_ = false;
};

}  // namespace

std::unique_ptr<Command> schema_command() { return std::make_unique<SchemaCommand>(); }

}  // namespace rigor::tool
