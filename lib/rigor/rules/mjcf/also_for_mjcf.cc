// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mjcf/also_for_mjcf.h>

#include <algorithm>
#include <array>

namespace rigor::rules {
namespace {

/// On files of meshes, on files as such, and on the model whatever its format.
constexpr std::array<std::string_view, 21> kAlsoForMjcf{"center-of-mass-outside-shapes",
                                                        "inertia-density-impossible",
                                                        "inertia-geometry-mismatch",
                                                        "link-misplaced",
                                                        "mesh-size-suspicious",
                                                        "file-too-large",
                                                        "file-unreadable",
                                                        "mesh-buffer-missing",
                                                        "mesh-buffer-too-short",
                                                        "mesh-decimal-comma",
                                                        "mesh-index-out-of-range",
                                                        "mesh-inverted",
                                                        "mesh-lfs-pointer",
                                                        "mesh-malformed",
                                                        "mesh-no-endsolid",
                                                        "mesh-not-finite",
                                                        "mesh-self-intersection",
                                                        "mesh-trailing-bytes",
                                                        "mesh-truncated",
                                                        "mesh-too-few-vertices",
                                                        "mesh-mujoco-faces"};

bool names_another_reader(std::string_view sentence) {
  constexpr std::array<std::string_view, 7> kOthers{"libsdformat", "urdfdom", "Gazebo", "SDF",
                                                    "URDF",        "RViz",    "Drake"};
  return std::any_of(kOthers.begin(), kOthers.end(), [sentence](std::string_view name) {
    return sentence.find(name) != std::string_view::npos;
  });
}

std::string_view sentence_on_mujoco(std::string_view prose) {
  std::string_view general;
  for (std::size_t at = 0; at < prose.size();) {
    const std::size_t stop = prose.find(". ", at);
    const std::size_t end = stop == std::string_view::npos ? prose.size() : stop + 1;
    const std::string_view sentence = prose.substr(at, end - at);
    if (!names_another_reader(sentence)) {
      if (sentence.find("MuJoCo") != std::string_view::npos) return sentence;
      if (general.empty()) general = sentence;
    }
    at = end + 1;
  }
  return general;
}

}  // namespace

bool holds_for_mjcf(const Rule& rule) {
  if (rule.formats == Formats::kMjcf) return true;
  if (rule.formats != Formats::kAny) return false;
  if (rule.category == Category::kXml || rule.category == Category::kSuppression) return true;
  if (rule.category == Category::kConvert) return true;  // on notes that only a conversion has
  return std::find(kAlsoForMjcf.begin(), kAlsoForMjcf.end(), rule.name) != kAlsoForMjcf.end();
}

PageInBrief brief_for_mjcf(const PageProse& prose) {
  return {sentence_on_mujoco(prose.why), sentence_on_mujoco(prose.what_to_do)};
}

}  // namespace rigor::rules
