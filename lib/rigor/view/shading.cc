// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/view/shading.h>

#include <algorithm>
#include <cmath>

namespace rigor::view {
namespace {

/// So fine that the darkest two values of eight bits are distinguished.
constexpr std::size_t kEncodingSteps = 8192;

// Shares of a white surface's light. The three are over one where all fall
// straight on it: then it is cut.
constexpr double kLampShare = 0.56;
constexpr double kSkyShare = 0.27;
constexpr double kEyeShare = 0.15;
/// What of the sky's light comes from below.
constexpr double kFloorShare = 0.45;
/// A faint gloss, which gives black parts their shape.
constexpr double kGloss = 0.10;
constexpr int kGlossDoublings = 5;  // to the 32nd power

float srgb_to_linear(float value) {
  const float v = std::clamp(value, 0.0F, 1.0F);
  return v <= 0.04045F ? v / 12.92F : std::pow((v + 0.055F) / 1.055F, 2.4F);
}

float linear_to_srgb(float light) {
  return light <= 0.0031308F ? 12.92F * light : 1.055F * std::pow(light, 1 / 2.4F) - 0.055F;
}

/// 0 to `count` - 1, repeated without end.
std::uint32_t wrapped(double at, std::uint32_t count) {
  const double rest = at - std::floor(at / count) * count;
  return std::min(static_cast<std::uint32_t>(rest), count - 1);
}

}  // namespace

Encoding::Encoding() : srgb_(kEncodingSteps + 1) {
  for (std::size_t i = 0; i < linear_.size(); ++i) {
    linear_[i] = srgb_to_linear(static_cast<float>(i) / 255);
  }
  for (std::size_t i = 0; i < srgb_.size(); ++i) {
    // The steps are those of the square root, which is nearly how the eye sees.
    const float root = static_cast<float>(i) / kEncodingSteps;
    srgb_[i] = static_cast<std::uint8_t>(std::lround(255 * linear_to_srgb(root * root)));
  }
}

std::uint8_t Encoding::to_srgb(float light) const {
  const float root = std::sqrt(std::clamp(light, 0.0F, 1.0F));
  return srgb_[static_cast<std::size_t>(root * kEncodingSteps + 0.5F)];
}

Light Encoding::to_linear(const Color& color) {
  return {srgb_to_linear(color.r), srgb_to_linear(color.g), srgb_to_linear(color.b)};
}

Paint sample(const Picture& picture, const Encoding& encoding, double u, double v) {
  if (!std::isfinite(u) || !std::isfinite(v)) return {{1, 1, 1}, 1};
  // The middle of a pixel is half a pixel from its edges; the first row is at
  // the top.
  const double x = (u - std::floor(u)) * picture.width - 0.5;
  const double y = (1 - (v - std::floor(v))) * picture.height - 0.5;
  const double left = std::floor(x);
  const double top = std::floor(y);
  Paint sum{{}, 0};
  for (const int down : {0, 1}) {
    for (const int across : {0, 1}) {
      const double share_x = across == 0 ? 1 - (x - left) : x - left;
      const double share_y = down == 0 ? 1 - (y - top) : y - top;
      const auto share = static_cast<float>(share_x * share_y);
      const Pixel& pixel =
          picture.at(wrapped(left + across, picture.width), wrapped(top + down, picture.height));
      sum.light =
          sum.light + share * Light{encoding.to_linear(pixel[0]), encoding.to_linear(pixel[1]),
                                    encoding.to_linear(pixel[2])};
      sum.opacity += share * static_cast<float>(pixel[3]) / 255;
    }
  }
  return sum;
}

Light lit(const Light& paint, const model::Vector3& normal, const model::Vector3& to_eye,
          float lamp) {
  const double facing_lamp = std::max(0.0, dot(normal, kTowardsLamp)) * static_cast<double>(lamp);
  const double facing_eye = std::max(0.0, dot(normal, to_eye));
  const double sky = kFloorShare + (1 - kFloorShare) * (0.5 + 0.5 * normal.z);
  const double dull = kLampShare * facing_lamp + kSkyShare * sky + kEyeShare * facing_eye;
  const model::Vector3 between = kTowardsLamp + to_eye;
  const double size = std::sqrt(dot(between, between));
  double gloss = size > 0 ? std::max(0.0, dot(normal, between) / size) : 0;
  for (int i = 0; i < kGlossDoublings; ++i) gloss *= gloss;
  gloss *= kGloss * static_cast<double>(lamp);
  const auto shine = static_cast<float>(gloss);
  return static_cast<float>(dull) * paint + Light{shine, shine, shine};
}

}  // namespace rigor::view
