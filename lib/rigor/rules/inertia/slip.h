// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which slip of units makes a tensor too large or too small.

#pragma once

namespace rigor::rules {

/// What to do about moments that are `share` times what the shapes have.
inline const char* guess_slip(double share) {
  struct Slip {
    double share;
    const char* help;
  };
  // The shapes need not be the body, so a share is near when it is within this factor.
  constexpr double kNear = 2;
  constexpr Slip kSlips[] = {
      {1e3, "the moments look as if they were in g·m²: divide them by 1e3"},
      {1e4, "the moments look as if they were in kg·cm²: divide them by 1e4"},
      {1e6, "the moments look as if they were in kg·mm²: divide them by 1e6"},
      {1e7, "the moments look as if they were in g·cm²: divide them by 1e7"},
      {1e9, "the moments look as if they were in g·mm²: divide them by 1e9"},
      {1e-3, "the moments look as if they had been divided by 1e3 once too often"},
      {1e-4, "the sizes look as if they were in cm, or the moments divided by 1e4 twice"},
      {1e-6, "the sizes look as if they were in mm, or the moments divided by 1e6 twice"},
  };
  for (const Slip& slip : kSlips) {
    if (share < slip.share * kNear && share > slip.share / kNear) return slip.help;
  }
  return "compute the tensor again from the body's mass and size";
}

}  // namespace rigor::rules
