// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/convex/hull.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

#include <rigor/mesh/select.h>

extern "C" {
#include <libqhull_r/libqhull_r.h>
}

namespace rigor::mesh {
namespace {

/// What a run of qhull allocated, given back.
struct Free {
  void operator()(qhT* qh) const {
    qh_freeqhull(qh, !qh_ALL);
    int left = 0;
    int left_long = 0;
    qh_memfreeshort(qh, &left, &left_long);
    delete qh;
  }
};

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// qhull wants somewhere to complain to; what it says of flat input is of no use to anybody.
std::unique_ptr<std::FILE, CloseFile> nowhere() {
  return std::unique_ptr<std::FILE, CloseFile>(std::fopen("/dev/null", "w"));
}

/// Corners of a facet in the order that makes it face outward.
Triangle corners(qhT* qh, facetT* facet) {
  Triangle result{};
  std::size_t i = 0;
  vertexT* vertex = nullptr;
  vertexT** vertexp = nullptr;
  FOREACHvertex_(facet->vertices) {
    if (i < 3) result[i++] = static_cast<std::uint32_t>(qh_pointid(qh, vertex->point));
  }
  // Vertices are sorted by number; `toporient` says whether that is the way round or against it.
  if ((facet->toporient == True) == (qh_ORIENTclock == 0)) std::swap(result[0], result[1]);
  return result;
}

Facet facet_of(const std::vector<Vector3>& points, const Triangle& t) {
  return {points[t[0]], points[t[1]], points[t[2]]};
}

double signed_volume(const std::vector<Vector3>& points, const std::vector<Triangle>& triangles) {
  double sum = 0;
  for (const Triangle& t : triangles) {
    const Facet f = facet_of(points, t);
    const Vector3& o = points[triangles.front()[0]];
    sum += dot(f[0] - o, cross(f[1] - o, f[2] - o));
  }
  return sum / 6;
}

}  // namespace

std::optional<TriangleMesh> convex_hull(const std::vector<Vector3>& points) {
  const auto finite = [](const Vector3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  };
  if (points.size() < 4 || points.size() > std::numeric_limits<int>::max() / 3) return std::nullopt;
  if (!std::all_of(points.begin(), points.end(), finite)) return std::nullopt;

  std::vector<coordT> coordinates;
  coordinates.reserve(points.size() * 3);
  for (const Vector3& p : points) coordinates.insert(coordinates.end(), {p.x, p.y, p.z});

  const auto errors = nowhere();
  std::unique_ptr<qhT, Free> qh(new qhT{});
  qh_zero(qh.get(), errors.get());
  // Qt: facets of more than three corners are cut into triangles.
  char options[] = "qhull Qt";
  const int failed = qh_new_qhull(qh.get(), 3, static_cast<int>(points.size()), coordinates.data(),
                                  False, options, nullptr, errors.get());
  if (failed != 0) return std::nullopt;

  std::vector<Triangle> triangles;
  facetT* facet = nullptr;
  for (facet = qh->facet_list; facet != nullptr && facet->next != nullptr; facet = facet->next) {
    triangles.push_back(corners(qh.get(), facet));
  }
  if (triangles.empty()) return std::nullopt;
  // With all facets turned the same way, only the sign of the whole is left to be put right.
  if (signed_volume(points, triangles) < 0) {
    for (Triangle& t : triangles) std::swap(t[0], t[1]);
  }
  TriangleMesh hull = compacted(points, std::move(triangles));
  hull.parts.front().name = "hull";
  return hull;
}

}  // namespace rigor::mesh
