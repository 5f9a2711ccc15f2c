// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor mesh-check` as its users script it.

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <utility>

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cli/program.h>
#include "support/corpus.h"

namespace rigor::test {
namespace {

using nlohmann::json;

/// A box of 1 × 2 × 3 in millimeters, its lowest corner at (10, 20, 30), without its top when `open`.
std::string box_obj(bool open = false) {
  std::string text =
      "v 10 20 30\nv 11 20 30\nv 11 22 30\nv 10 22 30\n"
      "v 10 20 33\nv 11 20 33\nv 11 22 33\nv 10 22 33\n"
      "f 1 4 3\nf 1 3 2\nf 1 2 6\nf 1 6 5\nf 2 3 7\nf 2 7 6\nf 3 4 8\nf 3 8 7\nf 4 1 5\nf 4 5 8\n";
  return open ? text : text + "f 5 6 7\nf 5 7 8\n";
}

json checked(const Folder& folder, const std::string& arguments, int exit = 0) {
  const Ran ran = folder.rigor("mesh-check " + arguments + " --format json");
  EXPECT_EQ(ran.exit, exit) << ran.err;
  return json::parse(ran.out);
}

void expect_vector(const json& found, double x, double y, double z) {
  EXPECT_NEAR(found[0].get<double>(), x, 1e-9);
  EXPECT_NEAR(found[1].get<double>(), y, 1e-9);
  EXPECT_NEAR(found[2].get<double>(), z, 1e-9);
}

TEST(MeshCheckCli, FactsOfABox) {
  const Folder folder;
  folder.put("box.obj", box_obj());
  const json result = checked(folder, "box.obj");
  const json& box = result["meshes"][0];
  EXPECT_EQ(box["path"], "box.obj");
  EXPECT_EQ(box["format"], "obj");
  EXPECT_EQ(box["vertices"], 8);
  EXPECT_EQ(box["triangles"], 12);
  EXPECT_EQ(box["watertight"], true);
  EXPECT_EQ(box["edge_manifold"], true);
  EXPECT_EQ(box["oriented"], true);
  EXPECT_EQ(box["components"], 1);
  EXPECT_EQ(box["degenerate"], 0);
  EXPECT_EQ(box["duplicate_faces"], 0);
  EXPECT_EQ(box["boundary_edges"], 0);
  EXPECT_EQ(box["nonmanifold_edges"], 0);
  EXPECT_NEAR(box["volume"].get<double>(), 6, 1e-12);
  EXPECT_NEAR(box["area"].get<double>(), 22, 1e-12);
  EXPECT_EQ(box["euler"], 2);
  EXPECT_EQ(box["convex"], true);
  EXPECT_EQ(box["self_intersections"], 0);
  expect_vector(box["com"], 10.5, 21, 31.5);
  expect_vector(box["bounds"]["min"], 10, 20, 30);
  expect_vector(box["bounds"]["max"], 11, 22, 33);
  EXPECT_EQ(result["written"], json::array());
}

TEST(MeshCheckCli, AModelThatCannotBeReadIsAnError) {
  const Folder folder;
  folder.put("box.obj", box_obj());
  folder.put("cut.sdf", "<sdf version='1.9'><model name='m'");
  folder.put("empty.sdf", "");
  folder.put("other.sdf", "<foo/>");
  folder.put("f/a.xacro", "<robot/>");
  folder.put("f/b.sdf", "<sdf version='1.9'><model name='m'><link name='l'/></model></sdf>");
  for (const char* file : {"cut.sdf", "empty.sdf", "other.sdf", "box.obj cut.sdf"}) {
    const json result = checked(folder, file, 1);
    ASSERT_FALSE(result["diagnostics"].empty()) << file;
    EXPECT_EQ(result["diagnostics"].back()["severity"], "error");
  }
  const Ran left = folder.rigor("mesh-check f");
  EXPECT_EQ(left.exit, 0);
  EXPECT_NE(left.err.find("skipped: f/a.xacro"), std::string::npos) << left.err;
  EXPECT_EQ(folder.rigor("mesh-check f -o out.obj").exit, 2);
}

TEST(MeshCheckCli, AnOpenBox) {
  const Folder folder;
  folder.put("box.obj", box_obj(true));
  const json box = checked(folder, "box.obj")["meshes"][0];
  EXPECT_EQ(box["watertight"], false);
  EXPECT_EQ(box["boundary_edges"], 4);
  EXPECT_EQ(box["volume"], nullptr);
  EXPECT_EQ(box["convex"], false);
}

TEST(MeshCheckCli, UnitAndCenterAndEveryFormat) {
  const Folder folder;
  folder.put("box.obj", box_obj());
  for (const char* ending : {"stl", "obj", "dae", "glb", "ply"}) {
    const std::string out = std::string("small.") + ending;
    const json result = checked(folder, "box.obj --unit mm --center bottom -o " + out);
    EXPECT_EQ(result["written"][0]["path"], out);
    EXPECT_EQ(result["written"][0]["triangles"], 12);
    const json small = checked(folder, out)["meshes"][0];
    EXPECT_EQ(small["watertight"], true) << out;
    EXPECT_NEAR(small["volume"].get<double>(), 6e-9, 1e-15) << out;
    expect_vector(small["bounds"]["min"], -0.0005, -0.001, 0);
    expect_vector(small["bounds"]["max"], 0.0005, 0.001, 0.003);
  }
}

TEST(MeshCheckCli, ALidIsNoSmallHole) {
  const Folder folder;
  folder.put("box.obj", box_obj(true));
  checked(folder, "box.obj --repair -o closed.stl");
  EXPECT_EQ(checked(folder, "closed.stl")["meshes"][0]["watertight"], false);
}

TEST(MeshCheckCli, AHullAndAPrimitive) {
  const Folder folder;
  folder.put("box.obj", box_obj(true));
  checked(folder, "box.obj --convex-hull -o hull.stl");
  EXPECT_NEAR(checked(folder, "hull.stl")["meshes"][0]["volume"].get<double>(), 6, 1e-6);
  const json fit = checked(folder, "box.obj --fit best")["fit"];
  EXPECT_EQ(fit["shape"], "box");
  EXPECT_NEAR(fit["volume"].get<double>(), 6, 1e-9);
  expect_vector(fit["position"], 10.5, 21, 31.5);
}

TEST(MeshCheckCli, WhatCannotBeReadWritesNothing) {
  const Folder folder;
  folder.put("cut.stl",
             std::string(80, ' ') + std::string("\x05\0\0\0", 4) + std::string(70, '\0'));
  const Ran ran = folder.rigor("mesh-check cut.stl -o out.stl");
  EXPECT_EQ(ran.exit, 1) << ran.err;
  EXPECT_FALSE(std::filesystem::exists(folder.path("out.stl")));
  folder.put("pointer.stl", "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n");
  const json found = checked(folder, "pointer.stl", 1);
  EXPECT_EQ(found["diagnostics"][0]["rule"], "mesh-lfs-pointer");
  EXPECT_EQ(found["diagnostics"][0]["path"], "pointer.stl");
  EXPECT_EQ(found["diagnostics"][0]["line"], nullptr);
}

TEST(MeshCheckCli, WrongInvocations) {
  const Folder folder;
  folder.put("box.obj", box_obj());
  for (const char* arguments :
       {"", "no.stl", "box.obj --center com", "box.obj --center middle -o a.stl",
        "box.obj -o a.xyz", "box.obj --unit parsec -o a.stl", "box.obj --scale 0 -o a.stl",
        "box.obj --convex-hull --fit box -o a.stl", "box.obj --apply",
        "box.obj --attach nowhere::link::visual"}) {
    const Ran ran = folder.rigor(std::string("mesh-check ") + arguments);
    EXPECT_EQ(ran.exit, 2) << arguments << ran.err;
    EXPECT_EQ(ran.out, "") << arguments;
    EXPECT_NE(ran.err, "") << arguments;
    EXPECT_FALSE(std::filesystem::exists(folder.path("a.stl"))) << arguments;
  }
}

class MeshModel {
 public:
  MeshModel() {
    folder.put("arm/model.config",
               "<?xml version=\"1.0\"?>\n<model>\n  <name>arm</name>\n  <version>1.0</version>\n"
               "  <sdf version=\"1.6\">model.sdf</sdf>\n  <author>\n    <name>A</name>\n"
               "    <email>a@b.org</email>\n  </author>\n  <description>An arm.</description>\n"
               "</model>\n");
    folder.put("arm/model.sdf", R"(<?xml version="1.0"?>
<sdf version="1.6">
  <model name="arm">
    <static>true</static>
    <link name="base">
      <collision name="hull">
        <geometry>
          <box>
            <size>1 1 1</size>
          </box>
        </geometry>
      </collision>
      <visual name="skin">
        <pose>1 2 3 0 0 1.5</pose>
        <geometry>
          <mesh>
            <uri>model://arm/meshes/box.obj</uri>
            <scale>0.001 0.001 0.001</scale>
          </mesh>
        </geometry>
      </visual>
    </link>
  </model>
</sdf>
)");
    folder.put("arm/meshes/box.obj", box_obj());
  }

  Folder folder;
};

TEST(MeshCheckCli, TheMeshesOfAModel) {
  const MeshModel model;
  const json result = checked(model.folder, "arm");
  ASSERT_EQ(result["meshes"].size(), 1U);
  EXPECT_EQ(result["meshes"][0]["uses"], json({"arm/link base/visual skin"}));
  expect_vector(result["meshes"][0]["scale"], 0.001, 0.001, 0.001);
}

TEST(MeshCheckCli, AppliedTheModelLooksAsBefore) {
  const MeshModel model;
  const Ran ran = model.folder.rigor("mesh-check arm --unit mm --center bounds --apply");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  const std::string text = model.folder.get("arm/model.sdf");
  EXPECT_NE(text.find("model://arm/meshes/box_edited.obj"), std::string::npos) << text;
  const json mesh = checked(model.folder, "arm")["meshes"][0];
  // The box's middle, 10.5 21 31.5 mm, turned by 1.5 about z, from the old pose.
  const double x = 1 + 0.0105 * std::cos(1.5) - 0.021 * std::sin(1.5);
  const double y = 2 + 0.0105 * std::sin(1.5) + 0.021 * std::cos(1.5);
  const json row = json::parse(model.folder.rigor("inspect arm --format json").out);
  expect_vector(mesh["scale"], 1, 1, 1);
  expect_vector(mesh["bounds"]["max"], 0.0005, 0.001, 0.0015);
  const std::string poses = model.folder.rigor("inspect arm --format tsv").out;
  std::istringstream lines(poses);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    std::string kind, name;
    double px = 0, py = 0, pz = 0;
    fields >> kind >> name >> px >> py >> pz;
    if (kind != "visual") continue;
    EXPECT_NEAR(px, x, 1e-9);
    EXPECT_NEAR(py, y, 1e-9);
    EXPECT_NEAR(pz, 3.0315, 1e-9);
  }
  EXPECT_TRUE(std::filesystem::exists(model.folder.path("arm/meshes/box.obj"))) << "kept";
}

/// What each visual of the model draws: a closed box, or one without its top.
std::map<std::string, int> triangles_by_use(const Folder& folder) {
  std::map<std::string, int> triangles;
  const json all = checked(folder, "arm --fail-on never");
  for (const json& mesh : all["meshes"]) {
    for (const json& use : mesh["uses"]) triangles[use] = mesh["triangles"];
  }
  return triangles;
}

/// A model of a closed box and an open one.
void put_two_boxes(const Folder& folder, const std::string& closed, const std::string& open) {
  const auto visual = [](const std::string& name, const std::string& file) {
    return "<visual name='" + name + "'><geometry><mesh><uri>meshes/" + file +
           "</uri></mesh></geometry></visual>\n";
  };
  folder.put("arm/meshes/" + closed, box_obj());
  folder.put("arm/meshes/" + open, box_obj(true));
  folder.put("arm/model.sdf", "<sdf version='1.9'><model name='arm'><link name='base'>\n" +
                                  visual("closed", closed) + visual("open", open) +
                                  "</link></model></sdf>\n");
}

TEST(MeshCheckCli, AppliedEachMeshGetsAFileOfItsOwn) {
  const std::string apply = "mesh-check arm --center bounds --apply --fail-on never";
  for (const auto& [closed, open] :
       {std::pair{"box.obj", "box_edited.obj"}, std::pair{"box_edited.obj", "box.obj"},
        std::pair{"box.OBJ", "box.obj"}}) {
    const MeshModel model;
    put_two_boxes(model.folder, closed, open);
    const auto before = triangles_by_use(model.folder);
    ASSERT_EQ(before.size(), 2U);
    const Ran ran = model.folder.rigor(apply);
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_EQ(triangles_by_use(model.folder), before) << closed;
    // What an earlier run has written is replaced, so that the model names the same files again.
    const std::string text = model.folder.get("arm/model.sdf");
    EXPECT_NE(text.find("box_edited.obj"), std::string::npos) << text;
    EXPECT_NE(text.find("box_edited_2.obj"), std::string::npos) << text;
    EXPECT_EQ(model.folder.rigor(apply).exit, 0);
    EXPECT_EQ(triangles_by_use(model.folder), before) << closed;
    EXPECT_FALSE(std::filesystem::exists(model.folder.path("arm/meshes/box_edited_2_edited.obj")));
  }
}

TEST(MeshCheckCli, AppliedInAFolderThatIsGone) {
  const MeshModel model;
  const Ran ran =
      model.folder.rigor("mesh-check '" + model.folder.path("arm") + "' --center bounds --apply",
                         "mkdir gone && cd gone && rmdir ../gone &&");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_TRUE(std::filesystem::exists(model.folder.path("arm/meshes/box_edited.obj")));
}

TEST(MeshCheckCli, AttachingWhereNoFolderCanBeMade) {
  const MeshModel model;
  std::filesystem::remove_all(model.folder.path("arm/meshes"));
  model.folder.put("arm/meshes", "a file");
  model.folder.put("new.obj", box_obj());
  const std::string before = model.folder.get("arm/model.sdf");
  const Ran ran = model.folder.rigor("mesh-check new.obj --attach arm::base::hull");
  EXPECT_EQ(ran.exit, 2);
  EXPECT_NE(ran.err.find("arm/meshes: cannot be created"), std::string::npos) << ran.err;
  EXPECT_EQ(model.folder.get("arm/model.sdf"), before);
}

TEST(MeshCheckCli, Attached) {
  const MeshModel model;
  model.folder.put("new.obj", box_obj());
  const Ran ran = model.folder.rigor("mesh-check new.obj --attach arm::base::hull");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  const std::string text = model.folder.get("arm/model.sdf");
  EXPECT_NE(text.find("<uri>model://arm/meshes/new.obj</uri>"), std::string::npos) << text;
  EXPECT_EQ(text.find("<box>"), std::string::npos);
  EXPECT_EQ(model.folder.get("arm/meshes/new.obj"), box_obj());
  EXPECT_EQ(model.folder.rigor("validate arm").exit, 0);
}

TEST(MeshCheckCli, AttachingReplacesNoOtherFile) {
  const MeshModel model;
  model.folder.put("new.obj", "mtllib new.mtl\nusemtl red\n" + box_obj());
  model.folder.put("new.mtl", "newmtl red\nmap_Kd skin.png\n");
  model.folder.put("skin.png", "picture");
  model.folder.put("arm/meshes/skin.png", "another");
  const std::string before = model.folder.get("arm/model.sdf");
  const Ran refused = model.folder.rigor("mesh-check new.obj --attach arm::base::hull");
  EXPECT_EQ(refused.exit, 2);
  EXPECT_NE(refused.err.find("skin.png is there already"), std::string::npos) << refused.err;
  EXPECT_EQ(model.folder.get("arm/model.sdf"), before);
  EXPECT_EQ(model.folder.get("arm/meshes/new.obj"), "");
  // The mesh takes along what it names.
  model.folder.put("arm/meshes/skin.png", "picture");
  EXPECT_EQ(model.folder.rigor("mesh-check new.obj --attach arm::base::hull").exit, 0);
  EXPECT_EQ(model.folder.get("arm/meshes/new.mtl"), model.folder.get("new.mtl"));
  // A name that is wrong costs nothing.
  EXPECT_EQ(model.folder.rigor("mesh-check new.obj -o made.stl --attach arm::base::hul").exit, 2);
  EXPECT_EQ(model.folder.get("made.stl"), "");
}

TEST(MeshCheckCli, SaysWhatIsLeftAfterARepairAndALoss) {
  const Folder folder;
  folder.put("box.obj", box_obj(true));
  const Ran open = folder.rigor("mesh-check box.obj --repair -o same.obj");
  EXPECT_NE(open.out.find("repaired: open at 4 edges, 1 hole too large"), std::string::npos)
      << open.out;
  folder.put("red.obj", "mtllib red.mtl\nusemtl red\n" + box_obj());
  folder.put("red.mtl", "newmtl red\nKd 1 0 0\n");
  const Ran lost = folder.rigor("mesh-check red.obj -o red.stl");
  EXPECT_NE(lost.out.find("left out: materials"), std::string::npos) << lost.out;
  const Ran nothing = folder.rigor("mesh-check box.obj --reduce 1 -o none.obj");
  EXPECT_EQ(nothing.exit, 1);
  EXPECT_EQ(folder.get("none.obj"), "");
}

TEST(MeshCheckCli, ATestWorldThatIsValid) {
  const Folder folder;
  folder.put("meshes/box.obj", box_obj());
  const Ran ran = folder.rigor("mesh-check meshes/box.obj --test-world -o worlds/test.sdf");
  EXPECT_EQ(ran.exit, 2) << "there is no folder worlds";
  EXPECT_EQ(folder.rigor("mesh-check meshes/box.obj --test-world -o meshes/box.obj").exit, 2);
  EXPECT_EQ(folder.get("meshes/box.obj"), box_obj());
  EXPECT_EQ(folder.rigor("mesh-check meshes/box.obj --test-world -o test.sdf").exit, 0);
  const Ran valid = folder.rigor("validate test.sdf --format json");
  EXPECT_EQ(json::parse(valid.out)["summary"]["errors"], 0) << valid.out;
  EXPECT_NE(folder.get("test.sdf").find("meshes/box.obj"), std::string::npos);
}

TEST(MeshCheckCli, ReducingTellsWhatBecameOfSeams) {
  // A flat square of 10 by 10, each half of each with its own piece of the picture.
  std::string obj;
  for (int y = 0; y <= 10; ++y) {
    for (int x = 0; x <= 10; ++x) obj += fmt::format("v {} {} 0\n", x, y);
  }
  std::string faces;
  int texture = 0;
  const auto face = [&](int a, int b, int c) {
    obj += fmt::format("vt 0.{0:03} 0\nvt 0.{0:03} 0.5\nvt 0.{0:03} 1\n", texture);
    faces += fmt::format("f {}/{} {}/{} {}/{}\n", a, texture + 1, b, texture + 2, c, texture + 3);
    texture += 3;
  };
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 10; ++x) {
      const int low = 11 * y + x + 1;
      face(low, low + 1, low + 12);
      face(low, low + 12, low + 11);
    }
  }
  const Folder folder;
  folder.put("square.obj", obj + faces);
  const Ran moved = folder.rigor("mesh-check square.obj --reduce 2 -o two.obj");
  EXPECT_NE(moved.out.find("reduce: 2 triangles"), std::string::npos) << moved.out;
  EXPECT_NE(moved.out.find("seams"), std::string::npos) << moved.out;
  EXPECT_NE(folder.get("two.obj").find("\nvt "), std::string::npos);
  const Ran kept = folder.rigor("mesh-check square.obj --reduce 2 --keep-seams -o all.obj");
  // All of them, or all but two at corners, by the version of meshoptimizer.
  const std::size_t said = kept.out.find("reduce: ");
  ASSERT_NE(said, std::string::npos) << kept.out;
  EXPECT_GE(std::stoi(kept.out.substr(said + 8)), 198) << kept.out;
  EXPECT_NE(kept.out.find("2 were asked for"), std::string::npos) << kept.out;
  EXPECT_EQ(folder.rigor("mesh-check square.obj --keep-seams -o all.obj").exit, 2);
}

TEST(MeshCheckCli, TheSameBytesTwice) {
  const Folder folder;
  folder.put("box.obj", box_obj(true));
  for (const char* ending : {"stl", "obj", "dae", "glb", "ply"}) {
    const std::string what = "mesh-check box.obj --repair --center com --reduce 0.9 -o ";
    folder.rigor(what + "a." + ending);
    folder.rigor(what + "b." + ending);
    EXPECT_EQ(folder.get(std::string("a.") + ending), folder.get(std::string("b.") + ending));
    EXPECT_NE(folder.get(std::string("a.") + ending), "");
  }
}

}  // namespace
}  // namespace rigor::test
