// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Both conversions over real models: what is written is taken by urdfdom, is the same robot, and comes
// back as it went.

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>

#include <rigor/author/conversion.h>
#include <rigor/environment.h>
#include <rigor/read/load.h>

#include "support/corpus.h"

namespace rigor {
namespace {

using author::Conversion;

/// One run: what is read stays as long as it.
class Converter {
 public:
  explicit Converter(const Environment& environment)
      : environment_(environment), workspace_(environment.disk, sources_) {}

  read::Loaded load(const read::File& file) {
    return read::load({workspace_, environment_.resolver, environment_.sdf, environment_.urdf},
                      file);
  }
  read::Loaded open(const std::string& path) { return load(workspace_.open(path)); }
  read::Loaded put(const std::string& path, std::string text) {
    return load(workspace_.put(path, std::move(text)));
  }

  Conversion to_urdf(const read::Loaded& loaded) {
    return author::to_urdf(environment_, sources_, workspace_, loaded, {}, allowed("robot.urdf"));
  }
  Conversion to_sdf(const read::Loaded& loaded) {
    return author::to_sdf(environment_, sources_, workspace_, loaded, {}, allowed("robot.sdf"));
  }

 private:
  static author::ConversionOptions allowed(const std::string& out) {
    return {.losses = author::Losses::kAllowed, .out = "/nowhere/" + std::to_string(++runs_) + out};
  }

  inline static int runs_ = 0;
  const Environment& environment_;
  Sources sources_;
  read::Workspace workspace_;
};

/// What the proof says against the result.
std::string against(const Conversion& result) {
  for (const Diagnostic& found : result.diagnostics.list()) {
    if (found.rule == "convert-not-the-same" || found.rule == "convert-refused") {
      return found.message;
    }
  }
  return {};
}

/// Told of these, and told rightly.
const std::set<std::string> kNotTheSame{
    // Unnamed visuals pair up by their order, and one is lost.
    "gazebo_models/hoop_red/model.sdf",
    // A link of no mass has an inertia, 1e-6 kg·m²; SDF has no link without mass.
    "example-robot-data/robots/bolt_description/robots/bolt.urdf",
    // Two joints of one name, which urdfdom refuses.
    "urdf-usd-converter/tests/data/error_duplicate_joint_names.urdf",
};

TEST(CorpusConversion, UrdfOfRealModelsIsTakenAndIsTheSameRobot) {
  RIGOR_NEEDS_CORPUS();
  const RealDisk disk;
  const Environment environment(disk, {});
  int models = 0, written = 0;
  for (const std::string& path : test::corpus_models()) {
    const std::string name = path.substr(test::corpus().size() + 1);
    if (!name.starts_with("gazebo_models/") || !name.ends_with(".sdf")) continue;
    Converter converter(environment);
    const read::Loaded loaded = converter.open(path);
    if (!loaded.file->document->complete() || loaded.root.links.empty()) continue;
    ++models;
    const Conversion result = converter.to_urdf(loaded);
    if (!result.text) continue;
    ++written;
    EXPECT_EQ(against(result).empty(), !kNotTheSame.contains(name))
        << name << ": " << against(result);
  }
  EXPECT_GT(models, 400);
  EXPECT_GE(written, models * 95 / 100);
}

TEST(CorpusConversion, UrdfComesBackByteForByte) {
  RIGOR_NEEDS_CORPUS();
  const RealDisk disk;
  const Environment environment(disk, {});
  int models = 0, returned = 0;
  for (const std::string& path : test::corpus_models()) {
    const std::string name = path.substr(test::corpus().size() + 1);
    if (!name.ends_with(".urdf")) continue;
    Converter converter(environment);
    const read::Loaded loaded = converter.open(path);
    if (!loaded.file->document->complete()) continue;
    const Conversion sdf = converter.to_sdf(loaded);
    if (!sdf.text) continue;
    ++models;
    EXPECT_EQ(against(sdf).empty(), !kNotTheSame.contains(name)) << name << ": " << against(sdf);
    const Conversion back = converter.to_urdf(converter.put("/nowhere/a.sdf", *sdf.text));
    if (!back.text) continue;
    ++returned;
    // The heads differ: they count what became of the elements of their own sources.
    const auto body = [](const Conversion& result) {
      return result.text->substr(result.text->find("-->"));
    };
    const Conversion second = converter.to_sdf(converter.put("/nowhere/b.urdf", *back.text));
    ASSERT_TRUE(second.text) << name;
    const Conversion third = converter.to_urdf(converter.put("/nowhere/c.sdf", *second.text));
    ASSERT_TRUE(third.text) << name;
    EXPECT_EQ(body(third), body(back)) << name;
  }
  EXPECT_GT(models, 140);
  EXPECT_GE(returned, models - 10);
}

}  // namespace
}  // namespace rigor
