// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/image/embedded_pictures.h>

#include <map>
#include <string_view>
#include <utility>

namespace rigor::mesh {
namespace {

constexpr std::string_view kPngBegin = "\x89PNG\r\n\x1A\n";
constexpr std::string_view kJpegBegin = "\xFF\xD8\xFF";

}  // namespace

PictureKind kind_of(const std::shared_ptr<const std::string>& picture) {
  if (!picture || picture->empty()) return PictureKind::kNone;
  if (picture->starts_with(kPngBegin)) return PictureKind::kPng;
  return picture->starts_with(kJpegBegin) ? PictureKind::kJpeg : PictureKind::kOther;
}

NamedPictures named_pictures(std::vector<Material> materials, const std::string& stem) {
  NamedPictures result{std::move(materials), {}};
  std::map<std::shared_ptr<const std::string>, std::string> names;
  for (Material& material : result.materials) {
    const auto picture = std::exchange(material.embedded_picture, nullptr);
    const PictureKind kind = kind_of(picture);
    if (kind != PictureKind::kPng && kind != PictureKind::kJpeg) continue;
    std::string& name = names[picture];
    if (name.empty()) {
      name =
          stem + '-' + std::to_string(names.size()) + (kind == PictureKind::kPng ? ".png" : ".jpg");
      result.files.push_back({name, *picture});
    }
    material.texture = name;
  }
  return result;
}

}  // namespace rigor::mesh
