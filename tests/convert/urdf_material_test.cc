// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf/material.h>

#include <set>

#include <gtest/gtest.h>

#include <rigor/schema/embedded.h>
#include <rigor/schema/script_material.h>

#include "convert/urdf_part.h"

namespace rigor::convert {
namespace {

using test::of_kind;
using test::UrdfPart;

std::string drawn_ball(const std::string& name, const std::string& look) {
  return "<visual name='" + name + "'><geometry><sphere><radius>1</radius></sphere></geometry>" +
         look + "</visual>";
}

std::string ogre_script(const std::string& name) {
  return "<material><script><uri>file://media/materials/scripts/gazebo.material</uri><name>" +
         name + "</name></script></material>";
}

UrdfPart looking(const std::string& look) {
  return UrdfPart("<link name='base'>" + drawn_ball("v", look) + "</link>");
}

std::array<double, 4> rgba_of(const UrdfPart& part) {
  std::array<double, 4> rgba{-1, -1, -1, -1};
  if (part.draft.robot.materials.size() != 1) return rgba;
  const auto& color = part.draft.robot.materials[0].rgba;
  for (std::size_t i = 0; color && i < 4; ++i) rgba[i] = (*color)[i].value;
  return rgba;
}

using Rgba = std::array<double, 4>;

TEST(UrdfMaterial, TheTableIsWhole) {
  std::set<std::string> names;
  std::string_view text = schema::gazebo_materials_text();
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (line.empty() || line[0] == '#') continue;
    const std::string name(line.substr(0, line.find(' ')));
    EXPECT_TRUE(names.insert(name).second) << name;
    const auto found = schema::find_material(name);
    ASSERT_TRUE(found) << name;
    EXPECT_TRUE(name.starts_with("Gazebo/")) << name;
    for (const double part : found->diffuse) EXPECT_TRUE(part >= 0 && part <= 1) << name;
    for (const double part : found->ambient) EXPECT_TRUE(part >= 0 && part <= 1) << name;
  }
  EXPECT_GE(names.size(), 66U);
}

TEST(UrdfMaterial, KnowsWhatGazeboKnows) {
  const auto grey = schema::find_material("Gazebo/Grey");
  EXPECT_EQ(grey->ambient, (std::array<double, 3>{0.3, 0.3, 0.3}));
  EXPECT_EQ(grey->diffuse, (Rgba{0.7, 0.7, 0.7, 1}));
  EXPECT_EQ(schema::find_material("Gazebo/Orange")->diffuse, (Rgba{1, 0.5088, 0.0468, 1}));
  EXPECT_EQ(schema::find_material("Gazebo/RedTransparent")->diffuse[3], 0.5);
  EXPECT_EQ(schema::find_material("Gazebo/Wood")->texture, "wood.jpg");
  EXPECT_FALSE(schema::find_material("Gazebo/Gre"));
  EXPECT_FALSE(schema::find_material("Gazebo/Nothing"));
  EXPECT_FALSE(schema::find_material(""));
}

TEST(UrdfMaterial, OneColourIsThatColour) {
  for (const std::string look : {"<material><diffuse>0.10 .2 0.3 0.5</diffuse></material>",
                                 "<material><ambient>0.10 .2 0.3 0.5</ambient></material>",
                                 "<material><ambient>0.1 0.2 0.3 1</ambient><diffuse>0.10 .2 0.3 "
                                 "0.5</diffuse></material>"}) {
    const UrdfPart part = looking(look);
    EXPECT_EQ(rgba_of(part), (Rgba{0.1, 0.2, 0.3, 0.5})) << look;
    EXPECT_EQ((*part.draft.robot.materials[0].rgba)[0].text, "0.10");
    EXPECT_EQ((*part.draft.robot.materials[0].rgba)[1].text, ".2");
    EXPECT_EQ(part.link.visuals.at(0).material, part.draft.robot.materials[0].name);
  }
}

TEST(UrdfMaterial, TwoColoursAreGazebosLook) {
  // 0.4 · 0.3 + 0.8 · 0.7 = 0.68; the alpha of the diffuse colour, of which half is let through.
  UrdfPart part = looking(
      "<transparency>0.5</transparency><material><ambient>0.3 0.3 1 1</ambient><diffuse>0.7 0.7 1 "
      "0.8</diffuse></material>");
  EXPECT_EQ(rgba_of(part), (Rgba{0.68, 0.68, 1, 0.4}));
  const Account account = part.account();
  const auto notes = of_kind(account.notes, NoteKind::kMaterialLook);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].outcome, Outcome::kSubstituted);
  EXPECT_TRUE(of_kind(account.notes, NoteKind::kVisualExtra).empty());
}

TEST(UrdfMaterial, BringsColoursIntoTheirRange) {
  EXPECT_EQ(rgba_of(looking("<material><diffuse>255 -1 0.5</diffuse></material>")),
            (Rgba{1, 0, 0.5, 1}));
}

TEST(UrdfMaterial, NoColourIsNoMaterial) {
  for (const std::string look : {"", "<material/>", "<material><diffuse>red</diffuse></material>",
                                 "<material><diffuse>1 0</diffuse></material>"}) {
    const UrdfPart part = looking(look);
    EXPECT_TRUE(part.draft.robot.materials.empty()) << look;
    EXPECT_EQ(part.link.visuals.at(0).material, "") << look;
  }
}

TEST(UrdfMaterial, ATransparencyWithoutColourIsLost) {
  UrdfPart part = looking("<transparency>0.5</transparency>");
  const auto notes = of_kind(part.account().notes, NoteKind::kVisualExtra);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].written, "transparency");
}

TEST(UrdfMaterial, EqualColoursAreOneMaterial) {
  const UrdfPart part(
      "<link name='base'>" + drawn_ball("a", "<material><diffuse>1 0 0 1</diffuse></material>") +
      drawn_ball("b", "<material><diffuse>1.0 0.0 0 1</diffuse></material>") +
      drawn_ball("c", ogre_script("Gazebo/Red")) +
      drawn_ball("d", "<material><diffuse>1 0 0 0.5</diffuse></material>") + "</link>");
  ASSERT_EQ(part.draft.robot.materials.size(), 2U);
  EXPECT_EQ(part.draft.robot.materials[0].name, "base_color");
  EXPECT_EQ(part.draft.robot.materials[1].name, "base_color_2");
  EXPECT_EQ(part.link.visuals.at(2).material, "base_color");
}

TEST(UrdfMaterial, AScriptThatAllVisualsShareIsCarried) {
  UrdfPart part("<link name='base'>" + drawn_ball("a", ogre_script("Gazebo/Blue")) +
                drawn_ball("b", ogre_script("Gazebo/Blue")) + "</link>");
  EXPECT_EQ(rgba_of(part), (Rgba{0, 0, 1, 1}));
  EXPECT_EQ(part.draft.robot.materials[0].name, "Gazebo/Blue");
  EXPECT_EQ(part.draft.robot.blocks.at(0).xml, "<material>Gazebo/Blue</material>\n");
  for (const Note& note : of_kind(part.account().notes, NoteKind::kMaterialScript)) {
    EXPECT_EQ(note.outcome, Outcome::kCarried);
    EXPECT_EQ(note.count, 3U);
  }
}

TEST(UrdfMaterial, OtherScriptsAreTold) {
  UrdfPart part("<link name='base'>" + drawn_ball("a", ogre_script("Gazebo/Blue")) +
                drawn_ball("b", ogre_script("Mine/Blue")) + "</link>");
  EXPECT_TRUE(part.draft.robot.blocks.empty());
  const auto notes = of_kind(part.account().notes, NoteKind::kMaterialScript);
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_EQ(notes[0].outcome, Outcome::kSubstituted);
  EXPECT_EQ(notes[0].instead, "0 0 1 1");
  EXPECT_EQ(notes[1].outcome, Outcome::kLost);
  EXPECT_EQ(notes[1].written, "Mine/Blue");
}

TEST(UrdfMaterial, TheRestOfALookIsOneNote) {
  UrdfPart part = looking(
      "<material><diffuse>1 0 0 1</diffuse><specular>0 0 0 1</specular><lighting>1</lighting>"
      "<emissive>1 0 0 1</emissive><pbr><metal><albedo_map>a.png</albedo_map></metal></pbr>"
      "</material>");
  const auto notes = of_kind(part.account().notes, NoteKind::kMaterialLook);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].written, "emissive, pbr");  // the others are defaults
  EXPECT_EQ(notes[0].count, 4U);
}

TEST(UrdfMaterial, ReadsTheAttributesOfTheFirstVersion) {
  const UrdfPart script_part(
      "<link name='base'><visual name='v'><geometry><sphere radius='1'/></geometry>"
      "<material script='Gazebo/Red'/></visual></link>",
      "1.0");
  EXPECT_EQ(rgba_of(script_part), (Rgba{1, 0, 0, 1}));
  const UrdfPart color_part(
      "<link name='base'><visual name='v'><geometry><sphere radius='1'/></geometry>"
      "<material><diffuse rgba='0 1 0 1'/></material></visual></link>",
      "1.0");
  EXPECT_EQ(rgba_of(color_part), (Rgba{0, 1, 0, 1}));
}

}  // namespace
}  // namespace rigor::convert
