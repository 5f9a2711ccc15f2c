// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/view/drawing/looks.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include <rigor/view/drawing/materials.h>
#include <rigor/view/drawing/source_elements.h>

namespace rigor::view {
namespace {

/// A picture may be one pixel high and millions wide.
constexpr std::uint32_t kMaxSide = 2048;

/// As wide as it is high, by the nearest pixels.
Picture squared(const Picture& picture) {
  const std::uint32_t side = std::min(std::max(picture.width, picture.height), kMaxSide);
  Picture square{side, side, {}};
  square.pixels.reserve(std::size_t{side} * side);
  for (std::uint64_t y = 0; y < side; ++y) {
    for (std::uint64_t x = 0; x < side; ++x) {
      square.pixels.push_back(picture.at(static_cast<std::uint32_t>(x * picture.width / side),
                                         static_cast<std::uint32_t>(y * picture.height / side)));
    }
  }
  return square;
}

/// The shortest decimal that is this 32-bit number: 0.7, not 0.699999988.
double shortest(float value) {
  std::array<char, 32> text{};
  const char* const end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  double result = value;
  std::from_chars(text.data(), end, result);
  return result;
}

robot::Look look_of(const Surface& surface) {
  const Color& c = surface.color;
  robot::Look look{{shortest(c.r), shortest(c.g), shortest(c.b), shortest(c.a)}};
  if (!surface.texture) return look;
  look.picture = surface.texture_path;
  if (look.picture.empty()) {
    look.picture = '#' + std::to_string(reinterpret_cast<std::uintptr_t>(surface.texture.get()));
  }
  look.png = [picture = surface.texture](robot::PictureShape shape) {
    const bool is_square = picture->width == picture->height;
    return to_png(shape == robot::PictureShape::kAsItIs || is_square ? *picture
                                                                     : squared(*picture));
  };
  return look;
}

class LookFinder {
 public:
  LookFinder(const model::Root& root, const Sources& sources, Files files)
      : root_(root),
        files_(std::move(files)),
        elements_(sources),
        materials_(root, elements_, files_) {}

  std::vector<robot::Look> looks(model::Id<model::Visual> id, const mesh::TriangleMesh& mesh) {
    std::vector<robot::Look> looks;
    bool known = false;
    for (const Surface& surface : materials_.of(root_[id], mesh)) {
      known |= surface.texture != nullptr || !(surface.color == Color());
      looks.push_back(look_of(surface));
    }
    if (!known) looks.clear();
    return looks;
  }

 private:
  const model::Root& root_;
  Files files_;
  SourceElements elements_;
  Materials materials_;
};

}  // namespace

robot::FindLooks looks_of(const model::Root& root, const Sources& sources, Files files) {
  const auto finder = std::make_shared<LookFinder>(root, sources, std::move(files));
  return [finder](model::Id<model::Visual> id, const mesh::TriangleMesh& mesh) {
    return finder->looks(id, mesh);
  };
}

}  // namespace rigor::view
