// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How much light a point sends to the eye. Colors of files are sRGB; light
// adds up in linear numbers, so that is what all of this computes in.
//
//   const Light paint = to_linear(surface.color);
//   const Light seen = lit(paint, normal, towards_eye, in_shadow ? 0 : 1);

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <rigor/model/pose.h>
#include <rigor/view/drawing/drawing.h>

namespace rigor::view {

/// Red, green and blue, linear: twice the number is twice the light.
struct Light {
  float r = 0, g = 0, b = 0;
};

inline Light operator+(const Light& a, const Light& b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
inline Light operator*(float factor, const Light& c) {
  return {factor * c.r, factor * c.g, factor * c.b};
}
inline Light operator*(const Light& a, const Light& b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }

/// Between the numbers of pictures and light, by tables.
class Encoding {
 public:
  Encoding();

  float to_linear(std::uint8_t value) const { return linear_[value]; }
  std::uint8_t to_srgb(float light) const;
  static Light to_linear(const Color& color);

 private:
  std::array<float, 256> linear_{};
  std::vector<std::uint8_t> srgb_;
};

/// Light and opacity.
struct Paint {
  Light light;
  float opacity = 1;
};

/// The picture at (u, v), v upward, repeated without end; between its pixels,
/// their mean by distance.
Paint sample(const Picture& picture, const Encoding& encoding, double u, double v);

/// Towards the lamp: unit. Above, ahead and to the left, so that the views from
/// there are lit.
inline constexpr model::Vector3 kTowardsLamp{0.36, 0.48, 0.8};

/// What a dull surface sends to the eye: lamp, sky, and a little from where the
/// eye is. Both vectors are unit; `lamp` is the part of the lamp's light that
/// reaches it.
Light lit(const Light& paint, const model::Vector3& normal, const model::Vector3& to_eye,
          float lamp);

}  // namespace rigor::view
