// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/page_in_brief.h>

#include <algorithm>
#include <initializer_list>

#include <rigor/rules/mjcf/also_for_mjcf.h>

namespace rigor::rules {
namespace {

/// Up to the first full stop that ends one; "e.g. this" does not.
std::string_view first_sentence(std::string_view prose) {
  for (std::size_t stop = prose.find(". "); stop != prose.npos; stop = prose.find(". ", stop + 1)) {
    const bool shortened = stop >= 2 && prose[stop - 2] == '.';
    if (!shortened) return prose.substr(0, stop + 1);
  }
  return prose;
}

bool names_any(std::string_view sentence, std::initializer_list<std::string_view> names) {
  return std::any_of(names.begin(), names.end(), [sentence](std::string_view name) {
    return sentence.find(name) != sentence.npos;
  });
}

/// The first sentence, unless it is about readers of the other format, and a later one about those of this.
std::string_view sentence_for(model::Format format, std::string_view prose) {
  const bool urdf = format == model::Format::kUrdf;
  const auto is_about = [](std::string_view sentence, bool of_urdf) {
    return of_urdf ? names_any(sentence, {"urdfdom", "URDF", "RViz", "MuJoCo", "Drake", "Gazebo"})
                   : names_any(sentence, {"libsdformat", "SDF", "Gazebo"});
  };
  const std::string_view first = first_sentence(prose);
  if (is_about(first, urdf) || !is_about(first, !urdf)) return first;
  for (std::string_view rest = prose; rest.size() > first_sentence(rest).size();) {
    rest.remove_prefix(first_sentence(rest).size() + 1);
    const std::string_view next = first_sentence(rest);
    if (is_about(next, urdf)) return next;
  }
  return first;
}

}  // namespace

PageInBrief page_in_brief(const PageProse& prose, model::Format format) {
  if (format == model::Format::kMjcf) return brief_for_mjcf(prose);
  return {sentence_for(format, prose.why), sentence_for(format, prose.what_to_do)};
}

}  // namespace rigor::rules
