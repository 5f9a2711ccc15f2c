// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A drawing as a picture, by casting rays with Embree, which is opened with dlopen when it is first
// needed, so that no other command pays for loading it. Light falls from above and from the eye's
// side; what is nearer hides what is farther; opacity under one lets through what lies behind. The same
// bytes on every run and for every number of threads.
//
//   const auto traced = trace(drawing, camera, {.width = 960, .height = 640});
//   if (!traced.picture) say(traced.problem);

#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <rigor/view/camera.h>
#include <rigor/view/drawing/drawing.h>
#include <rigor/view/image/picture.h>

namespace rigor::view {

struct TraceOptions {
  std::uint32_t width = 960;
  std::uint32_t height = 640;
  unsigned samples = 3;  ///< rays a pixel, along each side: anti-aliasing
  unsigned threads = 0;  ///< 0: as many as there are cores
  Color background{1, 1, 1, 1};
};

struct Traced {
  std::optional<Picture> picture;
  std::string
      problem;  ///< why there is none: "libembree4.so.4 is not installed (apt install libembree4-4)"
};

Traced trace(const Drawing& drawing, const Camera& camera, const TraceOptions& options);

/// "Embree 3.13.5", or empty when it is not installed.
std::string tracer();

}  // namespace rigor::view
