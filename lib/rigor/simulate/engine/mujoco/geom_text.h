// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The scene's shapes as MuJoCo's geoms, and the pairs of them that touch. Every pair is written, with the surface that
// the two have together (contact_rules.h): MuJoCo itself would take the larger friction of a pair, and its masks know
// neither models nor joints. Private to the folder.
//
//   const GeomText geoms(scene, settings);
//   text += geoms.assets() + geoms.of(body) + geoms.pairs();

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

class GeomText {
 public:
  /// An EngineError for what MuJoCo cannot have.
  GeomText(const Scene& scene, const SolverSettings& settings);

  const std::string& assets() const { return assets_; }
  const std::string& pairs() const { return pairs_; }
  std::size_t pair_count() const { return pair_count_; }

  /// The geoms of a body (kWorld: of the world) that touch anything, and their shapes in the same order.
  std::string of(std::uint32_t body) const;
  std::vector<std::uint32_t> shapes_of(std::uint32_t body) const;

 private:
  bool is_still(std::uint32_t body) const;
  void add_pair(std::uint32_t a, std::uint32_t b);
  void add_asset(std::uint32_t shape);
  std::string geom(std::uint32_t index) const;

  const Scene& scene_;
  const SolverSettings& settings_;
  std::string assets_;
  std::string pairs_;
  std::size_t pair_count_ = 0;
  std::vector<bool> touches_;    ///< shape by shape
  std::vector<bool> has_asset_;  ///< mesh by mesh
};

/// The lowest height of a grid and the way from there to the highest, m, at least a micrometre.
struct GridRange {
  double low = 0;
  double range = 0;
};
GridRange range_of(const HeightGrid& grid);

}  // namespace rigor::simulate
