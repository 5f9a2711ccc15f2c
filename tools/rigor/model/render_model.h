// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Models from paths to pictures, for the commands that draw them.
//
//   ModelPainter painter(disk, environment);
//   const DrawnModel drawn = painter.draw("my_robot", {}, layers);
//   const view::Picture picture = painter.picture(drawn.drawing, camera, size);

#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include <rigor/mass/mesh/reads.h>
#include <rigor/read/load.h>
#include <rigor/rules/environment.h>
#include <rigor/view/drawing/drawing.h>
#include <rigor/view/trace.h>

namespace rigor::tool {

struct DrawnModel {
  std::string path;  ///< as it was named
  view::Drawing drawing;
  std::string problem;  ///< why there is nothing to see; empty when there is
};

/// What pictures are made with, besides what is on them.
struct PictureOptions {
  std::uint32_t width = 960;
  std::uint32_t height = 640;
  unsigned threads = 0;
};

class ModelPainter {
 public:
  ModelPainter(const Disk& disk, const Environment& environment);

  /// `joints` are words NAME=VALUE. What is not drawn is said on stderr. A
  /// UsageError when the path cannot be read.
  DrawnModel draw(const std::string& path, const std::vector<std::string>& joints,
                  const std::set<view::Layer>& layers);

  /// A UsageError when Embree is not there.
  static view::Picture picture(const view::Drawing& drawing, view::View view,
                               const PictureOptions& options);

  /// The same from where all of `bounds` is seen.
  static view::Picture picture(const view::Drawing& drawing, view::View view,
                               const mesh::Bounds& bounds, const PictureOptions& options);

 private:
  const Disk& disk_;
  const Environment& environment_;
  mass::MeshReads reads_;
};

/// Why nothing is on a drawing but the ground; empty when there is something.
std::string why_nothing_is_seen(const read::Loaded& loaded, const view::Drawing& drawing);

/// On stderr: `most` of what is not drawn, how many more there are, and why nothing is.
void say_what_is_missing(const DrawnModel& drawn, std::size_t most);

/// Of both.
mesh::Bounds around(const mesh::Bounds& a, const mesh::Bounds& b);

}  // namespace rigor::tool
