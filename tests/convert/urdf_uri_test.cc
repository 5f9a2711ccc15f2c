// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf/uri.h>

#include <variant>

#include <gtest/gtest.h>

#include "convert/urdf_part.h"

namespace rigor::convert {
namespace {

using test::of_kind;
using test::UrdfPart;

const std::map<std::string, std::string> kModelFolder{
    {"/robots/arm/model.config", "<model><name>An arm</name></model>"},
    {"/robots/arm/meshes/a.stl", "solid"},
    {"/robots/loose.stl", "solid"},
};

struct Rewritten {
  std::string uri;
  Notes notes;
};

Rewritten rewritten(const std::string& uri, const MeshUri& policy = {},
                    const std::map<std::string, std::string>& files = kModelFolder,
                    const std::string& out = {}) {
  UrdfOptions options;
  options.mesh_uri = policy;
  UrdfPart part("<link name='base'><visual name='v'><geometry><mesh><uri>" + uri +
                    "</uri></mesh></geometry></visual></link>",
                "1.9", options, {}, files, out);
  Rewritten result{std::get<UrdfMesh>(part.link.visuals.at(0).geometry).filename, {}};
  for (const Note& note : part.account().notes) {
    if (note.kind == NoteKind::kUri || note.kind == NoteKind::kUriNotFound ||
        note.kind == NoteKind::kUriElsewhere) {
      result.notes.push_back(note);
    }
  }
  return result;
}

TEST(UrdfUri, AModelBecomesAPackage) {
  const Rewritten result = rewritten("model://arm/meshes/a.stl");
  EXPECT_EQ(result.uri, "package://arm/meshes/a.stl");
  ASSERT_EQ(result.notes.size(), 1U);
  EXPECT_EQ(result.notes[0].outcome, Outcome::kRewritten);
  EXPECT_EQ(result.notes[0].written, "model://arm/meshes/a.stl");
  EXPECT_EQ(result.notes[0].instead, "package://arm/meshes/a.stl");
  EXPECT_EQ(rewritten("model://arm/meshes/a.stl", {.package = "arm_description"}).uri,
            "package://arm_description/meshes/a.stl");
}

TEST(UrdfUri, ARelativePathBecomesOneOfItsModelsFolder) {
  EXPECT_EQ(rewritten("meshes/a.stl").uri, "package://arm/meshes/a.stl");
  EXPECT_EQ(rewritten("file://meshes/a.stl").uri, "package://arm/meshes/a.stl");
  EXPECT_EQ(rewritten("meshes/a.stl", {.package = "p"}).uri, "package://p/meshes/a.stl");
}

TEST(UrdfUri, ARelativePathBecomesOneOfItsPackage) {
  EXPECT_EQ(rewritten("../meshes/a.stl", {},
                      {{"/robots/package.xml", "<package><name> arm_pkg </name></package>"},
                       {"/robots/meshes/a.stl", "solid"}})
                .uri,
            "package://arm_pkg/meshes/a.stl");
}

TEST(UrdfUri, WhatIsInNoPackageStaysAndIsTold) {
  const Rewritten result = rewritten("../loose.stl");
  EXPECT_EQ(result.uri, "../loose.stl");
  ASSERT_EQ(result.notes.size(), 1U);
  EXPECT_EQ(result.notes[0].outcome, Outcome::kCarried);
}

TEST(UrdfUri, PackagesAndWholePathsStay) {
  for (const std::string uri : {"package://arm/meshes/a.stl", "file:///robots/arm/meshes/a.stl"}) {
    const Rewritten result = rewritten(uri);
    EXPECT_EQ(result.uri, uri);
    EXPECT_TRUE(result.notes.empty()) << uri;
  }
  EXPECT_EQ(rewritten("/robots/loose.stl").uri, "file:///robots/loose.stl");
}

TEST(UrdfUri, AFileThatIsNotThereIsTold) {
  const Rewritten result = rewritten("model://arm/meshes/b.stl");
  EXPECT_EQ(result.uri, "package://arm/meshes/b.stl");
  ASSERT_EQ(result.notes.size(), 2U);
  EXPECT_EQ(result.notes[1].kind, NoteKind::kUriNotFound);
}

TEST(UrdfUri, WhatLiesOnAServerIsNotLookedFor) {
  const Rewritten result = rewritten("https://fuel.gazebosim.org/1.0/o/models/m/1/files/a.stl");
  ASSERT_EQ(result.notes.size(), 1U);
  EXPECT_EQ(result.notes[0].kind, NoteKind::kUri);
  EXPECT_EQ(result.notes[0].outcome, Outcome::kCarried);
}

TEST(UrdfUri, FilesOnRequest) {
  const MeshUri file{.kind = MeshUri::Kind::kFile};
  EXPECT_EQ(rewritten("model://arm/meshes/a.stl", file).uri, "file:///robots/arm/meshes/a.stl");
  EXPECT_EQ(rewritten("meshes/a.stl", file).uri, "file:///robots/arm/meshes/a.stl");
  EXPECT_EQ(rewritten("model://nowhere/a.stl", file).uri, "model://nowhere/a.stl");
}

TEST(UrdfUri, KeptOnRequest) {
  const Rewritten result = rewritten("model://arm/meshes/a.stl", {.kind = MeshUri::Kind::kKeep});
  EXPECT_EQ(result.uri, "model://arm/meshes/a.stl");
  EXPECT_TRUE(result.notes.empty());
}

TEST(UrdfUri, IsFoundFromWhereTheResultStands) {
  const auto from = [](const std::string& out, const std::string& uri) {
    return rewritten(uri, {}, kModelFolder, out);
  };
  // In the model's folder its name leads there.
  EXPECT_EQ(from("/robots/arm/arm.urdf", "meshes/a.stl").uri, "package://arm/meshes/a.stl");
  EXPECT_EQ(from("/robots/arm.urdf", "meshes/a.stl").uri, "arm/meshes/a.stl");
  EXPECT_EQ(from("/robots/arm/arm.urdf", "../loose.stl").uri, "../loose.stl");
  // Elsewhere nothing says where a folder with no more than a model.config is.
  for (const std::string uri : {"meshes/a.stl", "model://arm/meshes/a.stl"}) {
    const Rewritten result = from("/home/me/x/arm.urdf", uri);
    EXPECT_EQ(result.uri, "../../../robots/arm/meshes/a.stl");
    ASSERT_EQ(result.notes.size(), 1U) << uri;
    EXPECT_EQ(result.notes[0].kind, NoteKind::kUri);
  }
  EXPECT_EQ(from("/home/arm.urdf", "../loose.stl").uri, "../robots/loose.stl");
  // From a relative place a whole path is all that leads there.
  EXPECT_EQ(from("out/arm.urdf", "meshes/a.stl").uri, "file:///robots/arm/meshes/a.stl");
}

TEST(UrdfUri, TheNameOfARosPackageIsKeptAndTold) {
  const std::map<std::string, std::string> package{
      {"/robots/arm/package.xml", "<package><name>arm</name></package>"},
      {"/robots/arm/meshes/a.stl", "solid"}};
  const Rewritten away = rewritten("meshes/a.stl", {}, package, "/home/me/x/arm.urdf");
  EXPECT_EQ(away.uri, "package://arm/meshes/a.stl");
  ASSERT_EQ(away.notes.size(), 2U);
  EXPECT_EQ(away.notes[1].kind, NoteKind::kUriElsewhere);
  EXPECT_EQ(rewritten("meshes/a.stl", {}, package, "/robots/arm/urdf/arm.urdf").notes.size(), 1U);
  // As is what the user has asked for.
  const Rewritten asked = rewritten("meshes/a.stl", {.package = "p"}, kModelFolder, "/x/arm.urdf");
  EXPECT_EQ(asked.uri, "package://p/meshes/a.stl");
  EXPECT_EQ(asked.notes.back().kind, NoteKind::kUriElsewhere);
}

}  // namespace
}  // namespace rigor::convert
