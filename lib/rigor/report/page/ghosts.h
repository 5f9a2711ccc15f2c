// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where parts of a model would be, and how large, with the fix of a finding: what a page shows beside what is
// written when somebody chooses the finding.
//
//   page.ghosts = ghosts_between(drawing, drawing_with_the_fix, finding);

#pragma once

#include <cstddef>
#include <vector>

#include <rigor/model/pose.h>
#include <rigor/view/drawing/drawing.h>

namespace rigor::report {

/// A visual or collision in another place or size.
struct PageGhost {
  std::size_t finding = 0;  ///< index in the page's findings
  std::size_t body = 0;     ///< index in the page's drawing, whose mesh it has
  model::Pose pose;         ///< in the file's frame, joints at zero
  model::Vector3 scale;     ///< of the mesh
};

/// Those visuals and collisions of `now` that are elsewhere, or of another size, in `then`, which has the same in
/// the same order. None when it has others.
std::vector<PageGhost> ghosts_between(const view::Drawing& now, const view::Drawing& then,
                                      std::size_t finding);

}  // namespace rigor::report
