// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where the links of a model are seen: a painter of triangles with a depth for each pixel, and
// shapes as triangles, written anew, to hold the tracer and the drawing against.
//
//   LinkSilhouettes seen(camera, 480, 320);
//   for (const Facet& facet : facets_of(visual.geometry, mesh)) seen.add(link, moved(facet));
//   const PixelSum wheel = seen.of(link);

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <variant>
#include <vector>

#include <rigor/mesh/triangle_mesh.h>
#include <rigor/model/geometry.h>
#include <rigor/view/camera.h>

namespace rigor::judge {

struct PixelSum {
  double count = 0, x = 0, y = 0;

  void add(double at_x, double at_y) {
    ++count;
    x += at_x;
    y += at_y;
  }
  std::array<double, 2> centroid() const { return {x / count, y / count}; }
};

class LinkSilhouettes {
 public:
  LinkSilhouettes(const view::Camera& camera, std::uint32_t width, std::uint32_t height)
      : camera_(camera),
        width_(width),
        height_(height),
        owner_(std::size_t{width} * height, kNobody),
        nearness_(owner_.size(), 0) {}

  void add(std::uint32_t link, const mesh::Facet& facet) {
    std::array<Corner, 3> c{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto seen = view::project(camera_, double(width_) / height_, facet[i]);
      if (!seen) return;
      c[i] = {(seen->x + 1) / 2 * width_, (1 - seen->y) / 2 * height_, 1 / seen->depth};
    }
    const double whole = side(c[0], c[1], c[2].x, c[2].y);
    if (whole == 0) return;
    const auto [left, right] = pixels(c[0].x, c[1].x, c[2].x, width_);
    const auto [top, bottom] = pixels(c[0].y, c[1].y, c[2].y, height_);
    for (std::uint32_t y = top; y < bottom; ++y) {
      for (std::uint32_t x = left; x < right; ++x) {
        const double a = side(c[1], c[2], x + 0.5, y + 0.5) / whole;
        const double b = side(c[2], c[0], x + 0.5, y + 0.5) / whole;
        if (a < 0 || b < 0 || a + b > 1) continue;
        // Through a pinhole one over the depth is what is linear in the picture.
        const double nearness = a * c[0].nearness + b * c[1].nearness + (1 - a - b) * c[2].nearness;
        const std::size_t at = std::size_t{y} * width_ + x;
        // Of what lies in one place the first that was added is seen.
        if (nearness <= nearness_[at] * (1 + 1e-5)) continue;
        nearness_[at] = nearness;
        owner_[at] = link;
      }
    }
  }

  /// The middles of the pixels in which nothing is nearer than this link.
  PixelSum of(std::uint32_t link) const {
    PixelSum sum;
    for (std::size_t i = 0; i < owner_.size(); ++i) {
      if (owner_[i] == link) sum.add(double(i % width_) + 0.5, double(i / width_) + 0.5);
    }
    return sum;
  }

 private:
  static constexpr std::uint32_t kNobody = ~0U;
  struct Corner {
    double x, y, nearness;
  };

  static double side(const Corner& a, const Corner& b, double x, double y) {
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
  }
  static std::pair<std::uint32_t, std::uint32_t> pixels(double a, double b, double c,
                                                        std::uint32_t count) {
    const auto in_picture = [count](double at) { return std::clamp(at, 0.0, double(count)); };
    return {static_cast<std::uint32_t>(in_picture(std::floor(std::min({a, b, c})))),
            static_cast<std::uint32_t>(in_picture(std::ceil(std::max({a, b, c}))))};
  }

  const view::Camera& camera_;
  std::uint32_t width_, height_;
  std::vector<std::uint32_t> owner_;
  std::vector<double> nearness_;  ///< 1/m
};

/// A line of radii and heights turned about z.
inline std::vector<mesh::Facet> turned_about_z(const std::vector<std::array<double, 2>>& line) {
  constexpr int kSides = 96;
  std::vector<mesh::Facet> facets;
  const auto at = [&line](std::size_t i, int side) {
    const double angle = 2 * std::numbers::pi * side / kSides;
    return mesh::Vector3{line[i][0] * std::cos(angle), line[i][0] * std::sin(angle), line[i][1]};
  };
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    for (int s = 0; s < kSides; ++s) {
      facets.push_back({at(i, s), at(i, s + 1), at(i + 1, s + 1)});
      facets.push_back({at(i, s), at(i + 1, s + 1), at(i + 1, s)});
    }
  }
  return facets;
}

inline std::vector<mesh::Facet> box_facets(const mesh::Vector3& size) {
  std::vector<mesh::Facet> facets;
  const auto corner = [&size](unsigned i) {
    return mesh::Vector3{size.x * ((i & 1U) != 0 ? 0.5 : -0.5),
                         size.y * ((i & 2U) != 0 ? 0.5 : -0.5),
                         size.z * ((i & 4U) != 0 ? 0.5 : -0.5)};
  };
  for (const auto& [a, b] : {std::pair{1U, 2U}, {2U, 4U}, {4U, 1U}}) {
    for (const unsigned from : {0U, 7U - a - b}) {
      facets.push_back({corner(from), corner(from + a), corner(from + a + b)});
      facets.push_back({corner(from), corner(from + a + b), corner(from + b)});
    }
  }
  return facets;
}

/// Boxes, balls, cylinders, and meshes (`mesh` is then what the file holds); nothing of other shapes.
inline std::vector<mesh::Facet> facets_of(const model::Geometry& geometry,
                                          const mesh::TriangleMesh* mesh) {
  if (const auto* box = std::get_if<model::Box>(&geometry.shape))
    return box_facets(box->size.value);
  if (const auto* rod = std::get_if<model::Cylinder>(&geometry.shape)) {
    const double r = rod->radius.value;
    const double half = rod->length.value / 2;
    return turned_about_z({{0, -half}, {r, -half}, {r, half}, {0, half}});
  }
  if (const auto* ball = std::get_if<model::Sphere>(&geometry.shape)) {
    std::vector<std::array<double, 2>> line;
    for (int i = 0; i <= 48; ++i) {
      const double angle = std::numbers::pi * i / 48;
      line.push_back({ball->radius.value * std::sin(angle), ball->radius.value * std::cos(angle)});
    }
    return turned_about_z(line);
  }
  const auto* shape = std::get_if<model::Mesh>(&geometry.shape);
  if (shape == nullptr || mesh == nullptr) return {};
  std::vector<mesh::Facet> facets;
  const mesh::Vector3& s = shape->scale.value;
  for (const mesh::Triangle& t : mesh->triangles) {
    mesh::Facet& facet = facets.emplace_back(mesh::facet(*mesh, t));
    for (mesh::Vector3& p : facet) p = {s.x * p.x, s.y * p.y, s.z * p.z};
  }
  return facets;
}

}  // namespace rigor::judge
