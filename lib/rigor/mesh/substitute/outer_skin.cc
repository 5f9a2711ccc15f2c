// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>

#include <rigor/mesh/substitute/substitute.h>

namespace rigor::mesh {
namespace {

/// A place this near to a plane is in it: of the step, far above the rounding of a hull's corners.
constexpr double kInPlane = 1e-4;

struct HullPlane {
  Vector3 normal;
  double offset = 0;
};

std::vector<HullPlane> planes_of(const TriangleMesh& hull) {
  std::vector<HullPlane> planes;
  for (const Triangle& t : hull.triangles) {
    const Facet f = facet(hull, t);
    const Vector3 along = area_vector(f);
    const double size = length(along);
    if (!(size > 0)) continue;
    const Vector3 normal = 1 / size * along;
    planes.push_back({normal, dot(normal, f[0])});
  }
  return planes;
}

/// Whether a place with that outward normal is inside. In a face of the hull it is only where the two face each other.
bool is_covered(const std::vector<HullPlane>& hull, const Vector3& p, const Vector3& normal,
                double tolerance) {
  return std::all_of(hull.begin(), hull.end(), [&](const HullPlane& plane) {
    const double outside = dot(plane.normal, p) - plane.offset;
    return outside < -tolerance || (outside <= tolerance && dot(plane.normal, normal) < 0);
  });
}

class SkinMaker {
 public:
  SkinMaker(const std::vector<TriangleMesh>& pieces, double step) : pieces_(pieces), step_(step) {
    for (const TriangleMesh& piece : pieces) planes_.push_back(planes_of(piece));
  }

  TriangleMesh make() {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      for (const Triangle& t : pieces_[i].triangles) add(facet(pieces_[i], t), i);
    }
    return std::move(skin_);
  }

 private:
  /// Cut in n² equal triangles.
  void add(const Facet& f, std::size_t piece) {
    const double longest =
        std::max({length(f[1] - f[0]), length(f[2] - f[1]), length(f[0] - f[2])});
    constexpr double kMaxSplits = 64;
    const int n = static_cast<int>(std::clamp(std::ceil(longest / step_), 1.0, kMaxSplits));
    const auto corner = [&](int i, int j) {
      return f[0] + (static_cast<double>(i) / n) * (f[1] - f[0]) +
             (static_cast<double>(j) / n) * (f[2] - f[0]);
    };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; i + j < n; ++j) {
        add_small({corner(i, j), corner(i + 1, j), corner(i, j + 1)}, piece);
        if (i + j + 1 < n)
          add_small({corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)}, piece);
      }
    }
  }

  void add_small(const Facet& f, std::size_t piece) {
    const Vector3 middle = (1.0 / 3) * (f[0] + f[1] + f[2]);
    const Vector3 normal = area_vector(f);
    for (std::size_t i = 0; i < planes_.size(); ++i) {
      if (i != piece && is_covered(planes_[i], middle, normal, kInPlane * step_)) return;
    }
    const auto first = static_cast<std::uint32_t>(skin_.positions.size());
    skin_.positions.insert(skin_.positions.end(), f.begin(), f.end());
    skin_.triangles.push_back({first, first + 1, first + 2});
  }

  const std::vector<TriangleMesh>& pieces_;
  double step_;
  std::vector<std::vector<HullPlane>> planes_;
  TriangleMesh skin_;
};

}  // namespace

TriangleMesh outer_skin(const std::vector<TriangleMesh>& pieces, double step) {
  return SkinMaker(pieces, step).make();
}

}  // namespace rigor::mesh
