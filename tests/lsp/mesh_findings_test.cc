// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include <rigor/lsp/document/moving_place.h>
#include <rigor/lsp/document/stoppable_disk.h>

#include "lsp/editor.h"

namespace rigor::lsp {
namespace {

using test::Editor;

/// An STL without the triangle that it says it has.
const std::string kCut = std::string(80, '\0') + std::string("\x01\0\0\0", 4);

constexpr const char* kMeshRobot =
    "<robot name='r'>\n"
    "  <link name='a'>\n"
    "    <visual><geometry><mesh filename='cut.stl'/></geometry></visual>\n"
    "  </link>\n"
    "  <link name='b'/>\n"
    "  <joint name='j' type='fixed'><parent link='a'/><child link='b'/></joint>\n"
    "</robot>\n";

/// What only a look into the file tells.
Json mesh_finding(Editor& editor) {
  for (const Json& each : editor.diagnostics("/ws/r.urdf")) {
    if (text_at(each, "code") == "mesh-empty") return each;
  }
  return nullptr;
}

void open_meshes(Editor& editor) {
  while (const auto check = editor.session().take_mesh_check()) {
    check->run();
    editor.session().finish(*check);
  }
  editor.work();
}

TEST(LspMeshFindings, MeshesAreOpenedBehindTheTypingAndTheirFindingsKept) {
  MemoryDisk disk(test::Files{{"/ws/cut.stl", kCut}});
  Editor editor(disk);
  editor.open("/ws/r.urdf", kMeshRobot);
  EXPECT_TRUE(mesh_finding(editor).is_null());
  EXPECT_TRUE(editor.session().wants_mesh_check());
  open_meshes(editor);
  EXPECT_FALSE(editor.session().wants_mesh_check());
  ASSERT_FALSE(mesh_finding(editor).is_null());
  EXPECT_EQ(mesh_finding(editor)["range"]["start"]["line"], 2);
  EXPECT_EQ(editor.request("textDocument/diagnostic", editor.document("/ws/r.urdf"))["items"],
            editor.diagnostics("/ws/r.urdf"));

  // A line before the link moves it; a change of the link takes it away until the file is saved.
  std::string text(kMeshRobot);
  text.insert(text.find("  <link name='a'"), "  <!-- new -->\n");
  editor.change("/ws/r.urdf", text);
  ASSERT_FALSE(mesh_finding(editor).is_null());
  EXPECT_EQ(mesh_finding(editor)["range"]["start"]["line"], 3);
  text.replace(text.find("cut.stl"), 7, "cut.STL");
  editor.change("/ws/r.urdf", text);
  EXPECT_TRUE(mesh_finding(editor).is_null());
  text.replace(text.find("cut.STL"), 7, "cut.stl");
  editor.change("/ws/r.urdf", text);
  EXPECT_TRUE(mesh_finding(editor).is_null());
  editor.notify("textDocument/didSave", editor.document("/ws/r.urdf"));
  open_meshes(editor);
  EXPECT_FALSE(mesh_finding(editor).is_null());
}

/// A robot with three small boxes, one of ten meters, and a mesh.
std::string robot_with_a_hall() {
  std::string text = "<robot name='r'>\n";
  const auto link = [&text](const std::string& name, const std::string& shape) {
    text += "<link name='" + name + "'><collision><geometry>" + shape +
            "</geometry></collision></link>\n";
  };
  link("base", "<box size='0.1 0.1 0.1'/>");
  for (const char* name : {"a", "b"}) link(name, "<box size='0.1 0.1 0.1'/>");
  link("large", "<box size='10 10 10'/><!-- or less -->");
  link("hall", "<mesh filename='hall.obj'/>");
  for (const char* name : {"a", "b", "large", "hall"}) {
    text += std::string("<joint name='j_") + name + "' type='fixed'><parent link='base'/><child " +
            "link='" + name + "'/></joint>\n";
  }
  return text + "</robot>\n";
}

TEST(LspMeshFindings, ARobotIsNotJudgedByTheShapesThatAreNoMeshes) {
  // A tetrahedron of 10 m: beside it the large box is not odd.
  const std::string obj =
      "v 0 0 0\nv 10 0 0\nv 0 10 0\nv 0 0 10\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  MemoryDisk disk(test::Files{{"/ws/hall.obj", obj}});
  Editor editor(disk);
  const std::string path = "/ws/r.urdf";
  const auto finds = [&](std::string_view rule) {
    const std::vector<std::string> rules = editor.rules(path);
    return std::find(rules.begin(), rules.end(), rule) != rules.end();
  };
  editor.open(path, robot_with_a_hall());
  EXPECT_FALSE(finds("shape-exceeds-robot"));
  open_meshes(editor);
  EXPECT_FALSE(finds("shape-exceeds-robot"));

  // Without a mesh it is found at once; of a robot with a small one when that is opened.
  std::string text = robot_with_a_hall();
  const std::string mesh = "<mesh filename='hall.obj'/>";
  text.replace(text.find(mesh), mesh.size(), "<box size='0.1 0.1 0.1'/>");
  editor.change(path, text);
  EXPECT_TRUE(finds("shape-exceeds-robot"));
  text = robot_with_a_hall();
  text.replace(text.find(mesh), mesh.size(), "<mesh filename='hall.obj' scale='0.01 0.01 0.01'/>");
  editor.change(path, text);
  EXPECT_FALSE(finds("shape-exceeds-robot"));
  editor.notify("textDocument/didSave", editor.document(path));
  open_meshes(editor);
  EXPECT_TRUE(finds("shape-exceeds-robot"));
  // What is found then is fixed and suppressed as any other, until the text changes.
  const auto actions = [&] {
    const Json at = editor.position(path, "<box size='10 10 10'", 1);
    Json params = editor.document(path);
    params["range"] = {{"start", at}, {"end", at}};
    params["context"] = {{"diagnostics", Json::array()}};
    return editor.request("textDocument/codeAction", params).dump();
  };
  EXPECT_NE(actions().find("write it so"), std::string::npos) << actions();
  EXPECT_NE(actions().find("suppress shape-exceeds-robot here"), std::string::npos);
  editor.change(path, text + "\n");
  EXPECT_EQ(actions().find("shape-exceeds-robot"), std::string::npos);
}

TEST(LspMeshFindings, WhatWasStoppedIsDoneAgain) {
  MemoryDisk disk(test::Files{{"/ws/cut.stl", kCut}});
  Editor editor(disk);
  editor.open("/ws/r.urdf", kMeshRobot);
  const auto check = editor.session().take_mesh_check();
  ASSERT_NE(check, nullptr);
  check->stop();
  check->run();
  editor.session().finish(*check);
  editor.work();
  EXPECT_TRUE(mesh_finding(editor).is_null());
  EXPECT_TRUE(editor.session().wants_mesh_check());
  open_meshes(editor);
  EXPECT_FALSE(mesh_finding(editor).is_null());
}

TEST(LspMeshFindings, AClientThatPullsIsAskedToDoSo) {
  MemoryDisk disk(test::Files{{"/ws/cut.stl", kCut}});
  Json capabilities = Editor::default_capabilities();
  capabilities["textDocument"]["diagnostic"] = Json::object();
  capabilities["workspace"]["diagnostics"]["refreshSupport"] = true;
  Editor editor(disk, capabilities);
  editor.open("/ws/r.urdf", kMeshRobot);
  const auto asked = [&editor] {
    return std::count_if(editor.log().begin(), editor.log().end(), [](const Json& message) {
      return text_at(message, "method") == "workspace/diagnostic/refresh";
    });
  };
  const auto before = asked();
  open_meshes(editor);
  EXPECT_EQ(asked(), before + 1);
  const Json report = editor.request("textDocument/diagnostic", editor.document("/ws/r.urdf"));
  EXPECT_NE(report["items"].dump().find("mesh-empty"), std::string::npos);
}

TEST(LspMeshFindings, APlaceFollowsChangesOutsideOfWhatItDependsOn) {
  MovingPlace place{10, 12, 8, 20};
  EXPECT_TRUE(place.follow({0, 2, 5}));  // three bytes more before it
  EXPECT_EQ(place.begin, 13U);
  EXPECT_EQ(place.guard_end, 23U);
  EXPECT_TRUE(place.follow({23, 23, 7}));  // right behind
  EXPECT_TRUE(place.follow({9, 11, 0}));   // up to its first byte
  EXPECT_EQ(place.guard_begin, 9U);
  EXPECT_FALSE(place.follow({20, 20, 1}));
  EXPECT_FALSE(place.follow({0, 30, 0}));
}

TEST(LspMeshFindings, AStoppedDiskGivesNothing) {
  const MemoryDisk below(test::Files{{"/a", "text"}});
  StoppableDisk disk(below);
  const auto open = disk.open("/a");
  ASSERT_NE(open, nullptr);
  char first = '\0';
  EXPECT_EQ(open->read(0, &first, 1), 1U);
  disk.stop();
  EXPECT_EQ(open->read(0, &first, 1), 0U);
  EXPECT_EQ(disk.open("/a"), nullptr);
  EXPECT_FALSE(disk.read("/a", 10).bytes.has_value());
  EXPECT_EQ(disk.kind("/a"), PathKind::kMissing);
}

}  // namespace
}  // namespace rigor::lsp
