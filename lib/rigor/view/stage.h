// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A drawing as Embree holds it: each mesh once, placed by each of its bodies.
// Coordinates are relative to the drawing's middle, and a mesh's to its own, so
// that 32-bit numbers do for a robot a kilometer off.
//
//   const Stage stage(embree, drawing, encoding);
//   if (const auto hit = stage.first_solid(ray)) shade(*hit);
//
// What is solid is kept apart from what lets light through or marks what is
// inside (frames, centers of mass), since these are also seen when they lie on
// or behind something solid.

#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <rigor/view/embree.h>
#include <rigor/view/shading.h>

namespace rigor::view {

/// Origin relative to the stage's middle; direction of length 1.
struct Ray {
  model::Vector3 origin;
  model::Vector3 direction;
};

/// Where a ray meets a body.
struct Hit {
  double t = 0;  ///< m along the ray
  std::uint32_t body = 0;
  std::uint32_t triangle = 0;
  double u = 0, v = 0;  ///< shares of the triangle's second and third corner
  bool back = false;    ///< it is met from inside, as the triangle is wound
};

/// Of the distance: so much apart, two surfaces are in one place.
inline constexpr double kInOnePlace = 1e-5;

/// What is seen there.
struct Touched {
  Paint paint;
  model::Vector3 normal;  ///< unit, smooth, on the eye's side
  model::Vector3 facet;   ///< unit, of the triangle itself, on the eye's side
};

class Stage {
 public:
  Stage(const Embree& embree, const Drawing& drawing, const Encoding& encoding);
  ~Stage();
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  const std::string& problem() const { return problem_; }  ///< why it cannot be used
  const model::Vector3& middle() const { return middle_; }
  double size() const { return size_; }  ///< m, the drawing's diagonal
  bool has_glass() const { return has_glass_; }
  bool has_marks() const { return has_marks_; }
  /// A ray that has met it meets no other glass.
  bool ground_is_all_glass() const { return ground_is_all_glass_; }

  /// The nearest. Of surfaces in one place that which faces the eye: exporters write a wall's two sides as
  /// triangles of their own, each with its color; of those that face the same way the first of the drawing. Safe
  /// across threads, as all here.
  std::optional<Hit> first_solid(const Ray& ray) const;
  /// The nearest from `from` to `to` along the ray.
  std::optional<Hit> first_glass(const Ray& ray, double from, double to) const;
  bool reaches_lamp(const model::Vector3& point) const;

  Touched touched(const Hit& hit, const Ray& ray) const;
  bool is_mark(const Hit& hit) const { return bodies_[hit.body].mark; }
  bool is_ground(const Hit& hit) const { return bodies_[hit.body].ground; }

  /// 1 in the ground's middle, 0 at its rim, which so does not end in a line.
  double ground_left(const model::Vector3& point) const;

 private:
  struct Look {
    Paint paint;
    const Picture* texture = nullptr;
    bool texture_opacity = false;
  };
  struct Placed {
    const mesh::TriangleMesh* mesh = nullptr;
    std::vector<Look> looks;
    std::array<model::Vector3, 3> normal_rows{};  ///< turn a mesh's normal into the stage's axes
    bool mark = false;
    bool ground = false;
    bool glass = false;

    model::Vector3 turned(const model::Vector3& normal) const {
      return {dot(normal_rows[0], normal), dot(normal_rows[1], normal),
              dot(normal_rows[2], normal)};
    }
  };
  struct MeshScene {
    RTCScene scene = nullptr;
    model::Vector3 middle;
  };

  void place(const Body& body, std::uint32_t index);
  const MeshScene& scene_of(const mesh::TriangleMesh& mesh);
  bool fill(const mesh::TriangleMesh& mesh, const model::Vector3& middle,
            RTCGeometry geometry) const;
  std::vector<Look> looks_of(const Body& body, bool& glass) const;
  void measure_ground(const Drawing& drawing);
  std::optional<Hit> first(RTCScene scene, RayQuery& query, const Ray& ray, double from,
                           double to) const;
  std::optional<Hit> first_front(RTCScene scene, const Ray& ray, double from, double to) const;
  std::optional<Hit> nearest_front(RTCScene scene, const Ray& ray, double from, double to) const;
  Hit first_drawn(RTCScene scene, const Ray& ray, const Hit& hit) const;
  /// Unit, as the triangle is wound; 0 where it has no area.
  model::Vector3 outward(std::uint32_t body, std::uint32_t triangle) const;
  struct OtherSide;
  struct FirstDrawn;
  const Look& look_of(const Placed& placed, std::uint32_t triangle) const;

  const Embree& embree_;
  const Encoding& encoding_;
  std::string problem_;
  model::Vector3 middle_;
  double size_ = 1;
  RTCDevice device_ = nullptr;
  RTCScene solid_ = nullptr;
  RTCScene glass_ = nullptr;
  std::size_t placed_ = 0;     // bodies
  bool may_coincide_ = false;  // there are several surfaces
  bool has_glass_ = false;
  bool has_marks_ = false;
  bool ground_is_all_glass_ = true;
  std::map<const mesh::TriangleMesh*, MeshScene> scenes_;
  std::vector<Placed> bodies_;
  std::map<std::pair<const mesh::TriangleMesh*, std::array<float, 12>>, unsigned> in_one_place_;
  model::Vector3 ground_middle_;
  double ground_radius_ = 0;
};

}  // namespace rigor::view
