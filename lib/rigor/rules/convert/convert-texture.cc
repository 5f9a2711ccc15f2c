// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_texture {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, std::string("the texture is lost: SDF 1.9 lays none over a shape")));
}

Rule rule() {
  return {
      .name = "convert-texture",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .summary = "a texture is lost",
      .why =
          "URDF lays a picture over a shape; SDF 1.9 does that only through a material of "
          "physically based rendering.",
      .what_to_do = "Put the texture into a mesh file.",
      .checks = {on_conversion({convert::NoteKind::kTexture}, check)},
  };
}

}  // namespace rigor::rules::convert_texture
