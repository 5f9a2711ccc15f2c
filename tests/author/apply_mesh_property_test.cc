// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Whatever the mesh, its scale, its pose, the form they are written in and what is done to it: read
// back, the edited file places every vertex where it was, and what no edit names has its bytes.

#include <rigor/author/apply_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <rigor/model/frames.h>
#include <rigor/schema/value.h>

#include "author/model_text.h"
#include "support/part.h"

namespace rigor::author {
namespace {

using mesh::Vector3;
using test::ModelText;

constexpr const char* kMesh = "m/meshes/a.dae";

class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  int below(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }
  double number(double size) {
    return size * (2 * static_cast<double>(engine_()) / 4294967296.0 - 1);
  }
  /// In the digits that people write, or in all there are.
  std::string text(double size) {
    const double value = number(size);
    return schema::to_shortest(below(2) == 0 ? std::round(value * 1000) / 1000 : value);
  }
  std::string vector(double size) { return text(size) + ' ' + text(size) + "  " + text(size); }
  Vector3 point(double size) { return {number(size), number(size), number(size)}; }
  double factor() {
    constexpr double kUsual[] = {1, 0.001, 0.0254, 100, -1};
    return below(2) == 0 ? kUsual[below(5)] : 0.1 + std::abs(number(3));
  }
  std::string scale() {
    return schema::to_shortest(factor()) + ' ' + schema::to_shortest(factor()) + '\t' +
           schema::to_shortest(factor());
  }
  std::string angles(double quarter) {
    std::string text;
    for (int i = 0; i < 3; ++i) {
      text +=
          below(2) == 0 ? schema::to_shortest(quarter * (below(9) - 4)) : this->text(quarter * 2);
      text += ' ';
    }
    return text;
  }
  std::string quaternion() {
    Vector3 v = point(1);
    const auto q = model::normalized({number(1), v.x, v.y, v.z});
    return schema::to_shortest(q.x) + ' ' + schema::to_shortest(q.y) + ' ' +
           schema::to_shortest(q.z) + ' ' + schema::to_shortest(q.w);
  }

 private:
  std::mt19937 engine_;
};

constexpr double kQuarter = 1.5707963267948966;

std::string sdf_pose(Dice& dice, int version) {
  if (version == 0) {
    switch (dice.below(3)) {
      case 0: return "<origin pose='" + dice.vector(2) + ' ' + dice.angles(kQuarter) + "'/>";
      case 1: return "<origin/>";
      default: return "";
    }
  }
  if (version < 9) {
    switch (dice.below(4)) {
      case 0: return "<pose/>";
      case 1: return "";
      case 2: return "<pose frame=''>0 0 0 0 0 0</pose>";
      default: return "<pose>" + dice.vector(2) + ' ' + dice.angles(kQuarter) + "</pose>";
    }
  }
  switch (dice.below(6)) {
    case 0: return "<pose degrees='true'>" + dice.vector(2) + ' ' + dice.angles(90) + "</pose>";
    case 1:
      return "<pose rotation_format='quat_xyzw'>" + dice.vector(2) + ' ' + dice.quaternion() +
             "</pose>";
    case 2: return "<pose rotation_format='quat_xyzw'></pose>";
    case 3:
      return "<pose relative_to='f'> " + dice.vector(2) + "\n" + dice.angles(kQuarter) + "</pose>";
    case 4: return "";
    default: return "<pose><!-- c -->" + dice.vector(200) + ' ' + dice.angles(kQuarter) + "</pose>";
  }
}

std::string urdf_origin(Dice& dice) {
  switch (dice.below(5)) {
    case 0: return "<origin xyz='" + dice.vector(1) + "'/>";
    case 1: return "<origin rpy='" + dice.angles(kQuarter) + "' />";
    case 2: return "<origin xyz='" + dice.vector(1) + "' quat_xyzw='" + dice.quaternion() + "'/>";
    case 3: return "";
    default: return "<origin rpy='" + dice.angles(kQuarter) + "' xyz='" + dice.vector(1) + "'/>";
  }
}

std::string sdf_part(Dice& dice, int version, const std::string& kind) {
  std::string text = "      <" + kind + " name='" + kind + "'>\n        " +
                     sdf_pose(dice, version) + "\n        <geometry>\n          ";
  const bool scaled = dice.below(2) == 0;
  if (version == 0) {
    text +=
        "<mesh filename='meshes/a.dae'" + (scaled ? " scale='" + dice.scale() + '\'' : "") + "/>";
  } else {
    text += "<mesh>\n            <uri>model://m/meshes/a.dae</uri>";
    if (scaled) text += "<scale>" + dice.scale() + "</scale>";
    text += "\n          </mesh>";
  }
  return text + "\n        </geometry>\n      </" + kind + ">\n";
}

std::string sdf_text(Dice& dice) {
  constexpr int kVersions[] = {0, 4, 6, 9};
  const int version = kVersions[dice.below(4)];
  return "<sdf version='1." + std::to_string(version) + "'>\n  <model name='m'>\n" +
         (version == 9 ? "    <frame name='f'><pose>1 2 3 0.1 0.2 0.3</pose></frame>\n" : "") +
         "    <link name='l'>\n" + sdf_part(dice, version, "visual") +
         sdf_part(dice, version, "collision") + "    </link>\n  </model>\n</sdf>\n";
}

std::string urdf_text(Dice& dice) {
  std::string text = "<robot name='m' version='1.2'>\n  <link name='l'>\n";
  for (const std::string kind : {"visual", "collision"}) {
    text += "    <" + kind + ">\n      " + urdf_origin(dice) +
            "\n      <geometry><mesh filename='package://m/meshes/a.dae' " +
            (dice.below(2) == 0 ? "scale='" + dice.scale() + '\'' : "") + "/></geometry>\n    </" +
            kind + ">\n";
  }
  return text + "  </link>\n</robot>\n";
}

Vector3 scaled(const Vector3& s, const Vector3& v) { return {s.x * v.x, s.y * v.y, s.z * v.z}; }

/// Where each shape of the model places the points.
std::vector<Vector3> placed(const ModelText& model, const std::vector<Vector3>& points) {
  const model::Root& root = model.loaded.root;
  const model::Frames frames(root);
  std::vector<Vector3> result;
  const auto add = [&](const model::Geometry& geometry, const std::optional<model::Pose>& X) {
    ASSERT_TRUE(X);
    for (const Vector3& p : points) {
      result.push_back(transform(*X, scaled(std::get<model::Mesh>(geometry.shape).scale.value, p)));
    }
  };
  for (std::uint32_t i = 0; i < root.visuals.size(); ++i) {
    add(root.visuals[i].geometry, frames.pose(model::Id<model::Visual>{i}));
  }
  for (std::uint32_t i = 0; i < root.collisions.size(); ++i) {
    add(root.collisions[i].geometry, frames.pose(model::Id<model::Collision>{i}));
  }
  return result;
}

ModelText model_of(const std::string& text) {
  return {{{"m/model.config", "<model/>"}, {"m/package.xml", "<name>m</name>"}, {kMesh, ""}},
          "m/model.sdf",
          text};
}

mesh::Transform any_transform(Dice& dice) {
  mesh::Transform by{.unit = std::abs(dice.factor())};
  if (dice.below(2) == 0) by.scale = {dice.factor(), dice.factor(), dice.factor()};
  if (dice.below(2) == 0) by.up = mesh::UpAxis::kY;
  return by;
}

void expect_only_named_bytes_change(const std::string& before, const std::string& after,
                                    std::vector<Edit> edits) {
  std::sort(edits.begin(), edits.end(),
            [](const Edit& a, const Edit& b) { return a.span.begin < b.span.begin; });
  std::size_t from = 0;
  std::size_t to = 0;
  for (const Edit& edit : edits) {
    const std::size_t kept = edit.span.begin - from;
    EXPECT_EQ(before.substr(from, kept), after.substr(to, kept));
    to += kept;
    EXPECT_EQ(after.substr(to, edit.text.size()), edit.text);
    to += edit.text.size();
    from = edit.span.end;
  }
  EXPECT_EQ(before.substr(from), after.substr(to));
}

TEST(ApplyMeshProperty, EveryVertexStaysInItsPlace) {
  constexpr double kNanometer = 1e-9;
  double worst = 0;
  for (unsigned seed = 0; seed < 500 / test::parts(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const std::string text = seed % 3 == 0 ? urdf_text(dice) : sdf_text(dice);
    const mesh::Transform transform = any_transform(dice);
    const MeshReplacement by{kMesh, kMesh, transform, before_centering(transform, dice.point(20))};
    std::vector<Vector3> points;
    std::vector<Vector3> new_points;
    for (int i = 0; i < 10; ++i) {
      points.push_back(dice.point(1));
      new_points.push_back(before_centering(by.transform, points.back()) + by.translation);
    }

    const ModelText before = model_of(text);
    const ModelEdits result = apply_mesh(before.environment, before.sources, before.loaded, {by});
    ASSERT_TRUE(result.left.empty()) << text << words(result.left[0].why);
    ASSERT_EQ(result.uses, 2U) << text;
    const auto edited = apply_edits(text, result.edits);
    ASSERT_TRUE(edited) << text;
    expect_only_named_bytes_change(text, *edited, result.edits);

    const ModelText after = model_of(*edited);
    const std::vector<Vector3> old_places = placed(before, points);
    const std::vector<Vector3> new_places = placed(after, new_points);
    ASSERT_EQ(old_places.size(), new_places.size());
    for (std::size_t i = 0; i < old_places.size(); ++i) {
      worst = std::max(worst, length(old_places[i] - new_places[i]));
      ASSERT_LT(length(old_places[i] - new_places[i]), kNanometer) << text << *edited;
    }
    EXPECT_TRUE(apply_mesh(after.environment, after.sources, after.loaded, {{kMesh, kMesh, {}, {}}})
                    .edits.empty());
  }
  std::printf("worst displacement: %.3g m\n", worst);
}

}  // namespace
}  // namespace rigor::author
