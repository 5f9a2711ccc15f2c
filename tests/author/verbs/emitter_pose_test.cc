// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Particle emitters, projectors and audio sources of SDF go with their link; a sensor in a joint stays with the joint.

#include <gtest/gtest.h>

#include <rigor/author/verbs/lump/lump.h>
#include <rigor/author/verbs/mirror.h>
#include <rigor/author/verbs/move_frame.h>
#include <rigor/author/verbs/scale.h>

#include "author/verbs/verb_bench.h"

namespace rigor::author {
namespace {

constexpr const char* kPlume = R"(<sdf version="1.9"><model name="m">
  <link name="a"/>
  <link name="b">
    <pose>1 0 0 0 0 0</pose>
    <particle_emitter name="e" type="point"><pose>0 0.5 0.25 0 0 0</pose></particle_emitter>
    <projector name="p"><pose>0 0 0.5 0 0 0</pose><texture>t.png</texture></projector>
    <audio_source><uri>a.wav</uri><pose>0.5 0 0 0 0 0</pose></audio_source>
    <battery name="cell"><voltage>12</voltage></battery>
  </link>
  <joint name="j" type="TYPE">
    <parent>a</parent><child>b</child>
    JOINT
  </joint>
</model></sdf>
)";

std::string plume(const std::string& type, const std::string& in_joint) {
  std::string text = kPlume;
  text.replace(text.find("TYPE"), 4, type);
  return text.replace(text.find("JOINT"), 5, in_joint);
}

std::string plume_poses(const std::string& emitter, const std::string& projector,
                        const std::string& audio) {
  return "<particle_emitter name=\"e\" type=\"point\"><pose>" + emitter +
         "</pose></particle_emitter>\n    <projector name=\"p\"><pose>" + projector +
         "</pose><texture>t.png</texture></projector>\n    "
         "<audio_source><uri>a.wav</uri><pose>" +
         audio + "</pose></audio_source>\n";
}

TEST(EmitterPose, OfALinkWithAnotherFrame) {
  constexpr const char* kSensor =
      "<axis><xyz>0 0 1</xyz></axis><sensor name=\"ft\" type=\"force_torque\"><pose>0 0 0.125 0 0 "
      "0</pose></sensor>";
  VerbBench bench({{"m.sdf", plume("revolute", kSensor)}});
  const EditedModel& m = bench.open("m.sdf");
  const std::string text = bench.text(m, with_frame(m, "b", {{0, 0, 1}, {}}));
  EXPECT_NE(text.find(plume_poses("0 0.5 -0.75 0 0 0", "0 0 -0.5 0 0 0", "0.5 0 -1 0 0 0")),
            std::string::npos)
      << text;
  // The joint was kept in its place, and with it what it measures.
  EXPECT_NE(text.find("<pose>0 0 -1 0 0 0</pose>"), std::string::npos) << text;
  EXPECT_NE(text.find("<pose>0 0 0.125 0 0 0</pose></sensor>"), std::string::npos) << text;
}

TEST(EmitterPose, OfAScaledAndAMirroredModel) {
  VerbBench bench({{"m.sdf", plume("fixed", "")}});
  const EditedModel& m = bench.open("m.sdf");
  const std::string twice = bench.text(m, scaled(m, 2, {}));
  EXPECT_NE(twice.find(plume_poses("0 1 0.5 0 0 0", "0 0 1 0 0 0", "1 0 0 0 0 0")),
            std::string::npos)
      << twice;
  const std::string image = bench.text(m, mirrored(m, "b", {}));
  EXPECT_NE(image.find(plume_poses("0 -0.5 0.25 0 0 0", "0 0 0.5 0 0 0", "0.5 0 0 0 0 0")),
            std::string::npos)
      << image;
}

TEST(EmitterPose, OfALumpedLink) {
  VerbBench bench({{"m.sdf", plume("fixed", "")}});
  const EditedModel& m = bench.open("m.sdf");
  const std::string text = bench.text(m, lumped(m, {}));
  EXPECT_NE(text.find(plume_poses("1 0.5 0.25 0 0 0", "1 0 0.5 0 0 0", "1.5 0 0 0 0 0")),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("<battery name=\"cell\"><voltage>12</voltage></battery>"), std::string::npos)
      << text;
}

}  // namespace
}  // namespace rigor::author
