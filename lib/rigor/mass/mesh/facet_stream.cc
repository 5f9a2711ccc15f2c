// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/mesh/facet_stream.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <optional>
#include <thread>
#include <vector>

#include <rigor/mesh/stl/stl.h>
#include <rigor/text/in_threads.h>

namespace rigor::mass {
namespace {

using mesh::Bounds;
using mesh::Facet;
using model::Vector3;

// Facets read at once: 200 kB, which stay in the second-level cache while they are added up.
constexpr std::uint64_t kBlock = 4096;

// Facets examined, all over the file, to learn where the mesh is.
constexpr std::uint64_t kSamples = 1024;

constexpr Bounds kNowhere{
    {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
     std::numeric_limits<double>::infinity()},
    {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
     -std::numeric_limits<double>::infinity()}};

void include(Bounds& bounds, const Vector3& p) {
  bounds.min = {std::min(bounds.min.x, p.x), std::min(bounds.min.y, p.y),
                std::min(bounds.min.z, p.z)};
  bounds.max = {std::max(bounds.max.x, p.x), std::max(bounds.max.y, p.y),
                std::max(bounds.max.z, p.z)};
}

std::uint64_t offset_of(std::uint64_t facet) {
  return mesh::kStlHeaderBytes + facet * mesh::kStlFacetBytes;
}

Bounds sampled_bounds(const OpenFile& file, std::uint64_t count) {
  Bounds bounds = kNowhere;
  const std::uint64_t step = std::max<std::uint64_t>(1, count / kSamples);
  std::array<char, mesh::kStlFacetBytes> bytes{};
  for (std::uint64_t i = 0; i < count; i += step) {
    if (file.read(offset_of(i), bytes.data(), bytes.size()) != bytes.size()) break;
    for (const Vector3& corner : mesh::stl_facet(bytes.data())) include(bounds, corner);
  }
  return bounds;
}

/// Of the facets from `first` on, a block at most.
FacetSums block_sums(const OpenFile& file, std::uint64_t first, std::uint64_t count,
                     const Bounds& around, std::vector<char>& buffer) {
  const std::uint64_t wanted = std::min(kBlock, count - first);
  const std::size_t got = file.read(offset_of(first), buffer.data(), wanted * mesh::kStlFacetBytes);
  FacetSums sums(around);
  for (std::size_t at = 0; at + mesh::kStlFacetBytes <= got; at += mesh::kStlFacetBytes) {
    sums.add(mesh::stl_facet(buffer.data() + at));
  }
  return sums;
}

}  // namespace

FacetSums::FacetSums(const Bounds& around)
    : bounds(kNowhere), polyhedron(0.5 * (around.min + around.max)), winding(around) {}

void FacetSums::add(const Facet& facet) {
  ++triangles;
  for (const Vector3& corner : facet) include(bounds, corner);
  polyhedron.add(facet);
  balance.add(facet);
  winding.add(facet);
}

void FacetSums::join(const FacetSums& later) {
  triangles += later.triangles;
  include(bounds, later.bounds.min);
  include(bounds, later.bounds.max);
  polyhedron.join(later.polyhedron);
  balance.join(later.balance);
  winding.join(later.winding);
}

FacetSums stream_stl(const OpenFile& file, std::uint64_t count, unsigned threads) {
  const Bounds around = sampled_bounds(file, count);
  const std::uint64_t blocks = (count + kBlock - 1) / kBlock;
  std::vector<std::optional<FacetSums>> done(blocks);
  std::atomic<std::uint64_t> next{0};
  const auto work = [&](std::size_t) {
    std::vector<char> buffer(kBlock * mesh::kStlFacetBytes);
    for (std::uint64_t block = next++; block < blocks; block = next++) {
      done[block] = block_sums(file, block * kBlock, count, around, buffer);
    }
  };
  const unsigned cores = threads == 0 ? std::max(1U, std::thread::hardware_concurrency()) : threads;
  in_threads(std::min<std::uint64_t>(cores, blocks), work);

  FacetSums sums = std::move(*done.front());
  for (std::size_t i = 1; i < done.size(); ++i) sums.join(*done[i]);
  return sums;
}

}  // namespace rigor::mass
