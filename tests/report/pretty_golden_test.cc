// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a stranger reads of twenty faults, kept in testdata/pretty and read by people: each says what is
// wrong, where, why it matters and what to do. The files are rewritten when RIGOR_REWRITE_GOLDEN is set.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <rigor/report/terminal/pretty.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>

#include "support/corpus.h"

namespace rigor::report {
namespace {

const std::string kPretty = std::string(RIGOR_TESTDATA) + "pretty/";

/// Paths are shown as they are given, so the files are looked up from their folder.
class PrettyGolden : public testing::TestWithParam<const char*> {
 protected:
  PrettyGolden() : before_(std::filesystem::current_path()) {
    std::filesystem::current_path(std::string(RIGOR_TESTDATA) + "faults");
  }
  ~PrettyGolden() override { std::filesystem::current_path(before_); }

 private:
  std::filesystem::path before_;
};

TEST_P(PrettyGolden, ReadsAsItWasRead) {
  const std::string file = GetParam();
  const RealDisk disk;
  const Environment environment(disk, {});
  Sources sources;
  const auto result = rules::validate(environment, {.paths = {file}}, sources);
  const std::string text = pretty(result.diagnostics, sources, Color::kPlain, environment.registry);
  const std::string golden = kPretty + std::filesystem::path(file).stem().string() + ".txt";
  if (std::getenv("RIGOR_REWRITE_GOLDEN") != nullptr) std::ofstream(golden) << text;
  EXPECT_EQ(text, test::read_file(golden));
  EXPECT_NE(text.find(" why: "), std::string::npos);
  EXPECT_TRUE(text.find(" help: ") != std::string::npos ||
              text.find(" fix: ") != std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    Twenty, PrettyGolden,
    testing::Values("kinematics/joint-limit-inverted-1.sdf", "kinematics/two-parents-1.urdf",
                    "inertia/inertia-triangle-inequality-1.sdf",
                    "inertia/inertia-geometry-mismatch-1.sdf",
                    "reference/joint-parent-missing-1.sdf", "reference/mimic-joint-missing-1.urdf",
                    "schema/unknown-element-1.sdf", "schema/value-decimal-comma-1.sdf",
                    "schema/missing-attribute-1.sdf", "xml/xml-not-well-formed-1.sdf",
                    "naming/duplicate-name-1.sdf", "frame/relative-to-cycle-1.sdf",
                    "frame/pose-looks-like-degrees-1.sdf", "plugin/plugin-joint-missing-1.sdf",
                    "package/include-not-found-1.world", "package/uri-unknown-scheme-1.sdf",
                    "mesh/mesh-not-found-1.sdf", "mesh/mesh-case-mismatch-1.sdf",
                    "mesh/mesh-inverted-1.sdf", "sensor/camera-clip-inverted-1.sdf"),
    [](const auto& instance) {
      std::string name = std::filesystem::path(instance.param).stem().string();
      for (char& c : name) {
        if (c == '-') c = '_';
      }
      return name;
    });

}  // namespace
}  // namespace rigor::report
