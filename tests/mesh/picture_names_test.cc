// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/image/picture_names.h>

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/text/path.h>

namespace rigor::mesh {
namespace {

/// The name that a mesh at `to` gets for what one at `from` calls `written`.
std::string name_at(const std::string& from, const std::string& written, const std::string& to) {
  const MemoryDisk disk({{"/robot/meshes/skin.png", ""},
                         {"/robot/materials/textures/steel.png", ""},
                         {"/robot/meshes/with space.png", ""}});
  const std::vector<Material> materials{{.name = "a", .texture = written}};
  return materials_at(to, materials, {resolve(disk, from, written, 0)}).front().texture;
}

TEST(PictureNames, LeadToThePictureFromTheNewFolder) {
  const std::string arm = "/robot/meshes/arm.dae";
  EXPECT_EQ(name_at(arm, "skin.png", "/robot/collision/arm.obj"), "../meshes/skin.png");
  EXPECT_EQ(name_at(arm, "skin.png", "/robot/meshes/low/arm.obj"), "../skin.png");
  EXPECT_EQ(name_at(arm, "skin.png", "/robot/arm.obj"), "meshes/skin.png");
  EXPECT_EQ(name_at(arm, "skin.png", "/arm.obj"), "robot/meshes/skin.png");
  EXPECT_EQ(name_at(arm, "with%20space.png", "/robot/arm.obj"), "meshes/with space.png");
  EXPECT_EQ(name_at(arm, "steel.png", "/robot/a/b/arm.obj"),
            "../../materials/textures/steel.png");  // where Gazebo looks for it
}

TEST(PictureNames, StayWhereTheyLeadToThePictureOrToNone) {
  const std::string arm = "/robot/meshes/arm.dae";
  EXPECT_EQ(name_at(arm, "skin.png", "/robot/meshes/arm_edited.dae"), "skin.png");
  EXPECT_EQ(name_at(arm, "./skin.png", "/robot/meshes/arm_edited.dae"), "./skin.png");
  EXPECT_EQ(name_at(arm, "missing.png", "/robot/collision/arm.obj"), "missing.png");
  EXPECT_EQ(name_at(arm, "https://a.b/skin.png", "/arm.obj"), "https://a.b/skin.png");
  EXPECT_EQ(name_at(arm, "/robot/meshes/skin.png", "/arm.obj"), "/robot/meshes/skin.png");
}

TEST(RelativePath, JoinedToTheFolderIsThePath) {
  for (const std::string folder : {"/", "/a", "/a/b", "/c/d/e"}) {
    for (const std::string path : {"/x", "/a/x", "/a/b/x", "/a/bc/x", "/c/x"}) {
      const std::string relative = relative_path(folder, path);
      EXPECT_FALSE(is_absolute(relative));
      EXPECT_EQ(join_path(folder, relative), path) << folder;
    }
  }
  EXPECT_EQ(relative_path("a/b", "a/c/x"), "../c/x");
  EXPECT_EQ(relative_path(".", "a/x"), "a/x");
  EXPECT_EQ(relative_path("a", "a"), ".");
  EXPECT_EQ(relative_path("/a", "b/x"), "b/x");    // not seen from one place
  EXPECT_EQ(relative_path("../a", "b/x"), "b/x");  // `..` has a name that is not known
}

}  // namespace
}  // namespace rigor::mesh
