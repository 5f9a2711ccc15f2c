// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/consequences.h>

#include <algorithm>
#include <bitset>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace rigor::rules {
namespace {

constexpr Consequences kConsequences[] = {
    // An invalid mass gives no density and no tensor.
    {"mass-not-finite mass-negative mass-zero mass-not-written",
     "inertia-identity inertia-singular inertia-exceeds-shapes inertia-geometry-mismatch "
     "density-too-low density-too-high"},
    {"inertia-not-finite inertia-not-positive-definite inertia-triangle-inequality "
     "inertia-moment-missing inertia-not-written",
     "inertia-identity inertia-singular inertia-exceeds-shapes inertia-geometry-mismatch "
     "inertia-axes-swapped inertia-rotated-by-pose products-of-inertia-negated"},
    // A placeholder, or the right numbers in the wrong places, explains a wrong size.
    {"inertia-identity inertia-axes-swapped inertia-rotated-by-pose products-of-inertia-negated "
     "inertia-about-link-origin",
     "inertia-singular inertia-exceeds-shapes inertia-geometry-mismatch"},
    {"inertia-exceeds-shapes", "inertia-geometry-mismatch inertia-singular"},
    {"inertia-exceeds-shapes inertia-geometry-mismatch inertia-identity density-too-low "
     "density-too-high inertia-about-link-origin",
     "inertia-density-impossible inertia-placeholder"},
    {"inertia-density-impossible twin-value-differs", "inertia-placeholder"},
    {"inertia-geometry-mismatch", "inertia-singular"},
    // The size that an invalid number gives.
    {"value-malformed value-trailing-text value-decimal-comma value-missing-components "
     "value-negative value-not-finite size-not-positive mesh-scale-zero",
     "visual-collision-scale size-suspicious mesh-size-suspicious mesh-flat"},
    {"mesh-scale-zero", "mesh-scale-nonuniform"},
    // An invalid type, axis or limit, and what is derived from it.
    {"axis-zero axis-missing", "axis-not-unit wheel-axis-mismatch"},
    {"joint-type-unknown",
     "limit-missing axis-missing limit-without-effect fixed-joint-with-axis mimic-dof-mismatch "
     "controlled-joint-fixed"},
    {"joint-limit-inverted limit-looks-like-degrees limit-looks-like-millimeters",
     "limit-excludes-zero initial-position-outside-limits mimic-outside-limits "
     "safety-limits-outside"},
    {"limit-missing limit-range-missing",
     "limit-equal mimic-outside-limits effort-zero velocity-zero"},
    {"mimic-cycle mimic-self mimic-joint-missing",
     "mimic-rejected-by-ros2-control mimic-outside-limits mimic-dof-mismatch"},
    {"controlled-joint-fixed", "fixed-joint-with-axis"},
    {"model-far-from-origin", "model-in-ground"},
    // Where a part is, and how large it is, explains what it does not fit.
    {"shape-misplaced collision-of-another-link visual-collision-scale", "collision-beside-visual"},
    {"visual-collision-scale size-suspicious mesh-size-suspicious", "shape-size-slip"},
    {"shape-size-slip visual-collision-scale",
     "wheel-size-differs twin-value-differs collision-of-another-link"},
    {"wheel-size-differs shape-misplaced", "twin-value-differs"},
    {"link-misplaced twins-in-one-place", "twin-value-differs mirrored-sign-lost"},
    {"shape-misplaced visual-collision-origin shape-size-slip collision-of-another-link "
     "collision-file-of-another-link visual-collision-scale mesh-scale-differs size-suspicious "
     "origin-looks-like-millimeters pose-looks-like-degrees",
     "shape-origin-slip"},
    {"collision-file-of-another-link", "collision-of-another-link"},
    {"mesh-scale-differs visual-collision-scale shape-size-slip size-suspicious "
     "mesh-size-suspicious",
     "shape-exceeds-robot"},
    {"link-misplaced twins-in-one-place links-in-one-place origin-looks-like-millimeters "
     "sibling-value-differs twin-value-differs size-suspicious",
     "link-off-its-parent"},
    {"shape-rotation-slip",
     "inertia-axes-swapped inertia-geometry-mismatch visual-collision-origin shape-origin-slip "
     "shape-misplaced collision-beside-visual sibling-value-differs twin-value-differs "
     "pose-looks-like-degrees center-of-mass-outside-shapes links-overlap"},
    {"slider-limits-look-like-angles", "slider-looks-like-hinge"},
    {"sibling-value-differs twin-value-differs twin-axis-opposed", "limits-opposed"},
    {"limits-opposed limit-looks-like-degrees limit-looks-like-millimeters "
     "slider-limits-look-like-angles slider-looks-like-hinge joint-ends-swapped "
     "limit-excludes-zero joint-limit-inverted twin-value-differs twin-axis-opposed "
     "twin-axis-differs sibling-value-differs axis-not-unit link-off-its-parent link-misplaced "
     "links-in-one-place twins-in-one-place origin-looks-like-millimeters pose-looks-like-degrees "
     "shape-misplaced shape-origin-slip shape-size-slip shape-rotation-slip shape-exceeds-robot "
     "mesh-scale-differs",
     "limits-drive-into-parent"},
    {"center-of-mass-outside-shapes origin-looks-like-millimeters", "center-of-mass-mirrored"},
    // Of several parts that are alike one is odd, and what else is said of it.
    {"wheel-size-differs shape-size-slip shape-misplaced shape-origin-slip link-misplaced "
     "links-in-one-place twins-in-one-place visual-collision-origin visual-collision-scale "
     "mesh-scale-differs shape-exceeds-robot limit-equal joint-limit-inverted "
     "limit-looks-like-degrees velocity-looks-like-degrees axis-zero joint-type-unknown "
     "slider-looks-like-hinge slider-limits-look-like-angles axis-not-unit velocity-zero "
     "effort-zero "
     "effort-limit-negative center-of-mass-outside-shapes density-too-high density-too-low "
     "wheel-axis-mismatch limit-equal",
     "sibling-value-differs"},
    {"sibling-value-differs", "twin-value-differs"},
    {"density-too-high density-too-low inertia-exceeds-shapes", "twin-value-differs"},
    {"density-too-high density-too-low collision-of-another-link size-suspicious mass-zero "
     "effort-zero velocity-zero center-of-mass-outside-shapes inertia-identity "
     "inertia-axes-swapped inertia-rotated-by-pose inertia-about-link-origin "
     "inertia-not-positive-definite",
     "twin-value-differs"},
    {"inertia-triangle-inequality inertia-moment-missing", "twin-value-differs"},
    {"twin-value-differs", "inertia-geometry-mismatch inertia-density-impossible"},
    {"wheel-axis-mismatch", "twin-axis-differs"},
    // A mesh that cannot be read to its end is never closed.
    {"mesh-truncated mesh-malformed mesh-index-out-of-range mesh-not-finite",
     "mesh-not-watertight mesh-unreferenced-vertex mesh-size-suspicious"},
    // A part that is far from what it should touch.
    {"center-of-mass-outside-shapes shape-misplaced link-misplaced mesh-far-from-origin",
     "origin-looks-like-millimeters"},
    {"shape-misplaced origin-looks-like-millimeters pose-looks-like-degrees mesh-far-from-origin",
     "visual-collision-origin"},
    {"visual-collision-origin shape-origin-slip", "collision-beside-visual"},
    // A name that does not exist, and all that refer to it.
    {"joint-parent-missing joint-child-missing",
     "gazebo-reference-missing sensor-frame-missing relative-to-missing attached-to-missing "
     "canonical-link-missing placement-frame-missing",
     Link::kCause},
    {"joint-parent-missing", "joint-child-missing", Link::kCause},
    {"controlled-joint-missing",
     "plugin-joint-missing mimic-joint-missing gazebo-reference-missing", Link::kCause},
};

using Rows = std::bitset<std::size(kConsequences)>;

/// The rows that name a rule.
struct RowsOfRule {
  Rows as_root, as_follower;
};

using RowsByRule = std::unordered_map<std::string_view, RowsOfRule>;

/// Of names with blanks between.
void note_row(std::string_view names, std::size_t row, Rows RowsOfRule::*as, RowsByRule& rules) {
  while (!names.empty()) {
    const std::size_t end = std::min(names.find(' '), names.size());
    (rules[names.substr(0, end)].*as).set(row);
    names.remove_prefix(std::min(end + 1, names.size()));
  }
}

RowsByRule find_rows_by_rule() {
  RowsByRule rules;
  for (std::size_t row = 0; row < std::size(kConsequences); ++row) {
    note_row(kConsequences[row].roots, row, &RowsOfRule::as_root, rules);
    note_row(kConsequences[row].rules, row, &RowsOfRule::as_follower, rules);
  }
  return rules;
}

/// The table by rule: each file with findings asks for it.
const RowsByRule& rows_by_rule() {
  static const RowsByRule kRules = find_rows_by_rule();
  return kRules;
}

/// What the roots of a row are about.
class Roots {
 public:
  void add(const Diagnostic& finding, Link link) {
    std::string about = about_of(finding, link);
    // The entity, and those that it is a part of.
    while (!about.empty() && found_[finding.severity].insert(about).second) {
      const std::size_t slash = link == Link::kSubject ? about.rfind('/') : std::string::npos;
      about.resize(slash == std::string::npos ? 0 : slash);
    }
  }

  bool explain(const Diagnostic& finding, Link link) const {
    const std::string about = about_of(finding, link);
    return std::any_of(found_.begin(), found_.end(), [&](const auto& of_severity) {
      return of_severity.first <= finding.severity && of_severity.second.contains(about);
    });
  }

 private:
  static std::string about_of(const Diagnostic& finding, Link link) {
    return link == Link::kSubject ? finding.subject : finding.cause;
  }

  std::map<Severity, std::unordered_set<std::string>> found_;
};

}  // namespace

std::span<const Consequences> consequences() { return kConsequences; }

Diagnostics without_consequences(Diagnostics found) {
  const std::vector<Diagnostic>& list = found.list();
  std::vector<RowsOfRule> named(list.size());
  RowsOfRule reported;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto rule = rows_by_rule().find(list[i].rule);
    if (rule == rows_by_rule().end()) continue;
    reported.as_root |= rule->second.as_root;
    reported.as_follower |= rule->second.as_follower;
    if (list[i].count == 1) named[i] = rule->second;
  }
  const Rows both = reported.as_root & reported.as_follower;
  if (both.none()) return found;
  std::vector<bool> follows(list.size(), false);
  for (std::size_t row = 0; row < both.size(); ++row) {
    if (!both[row]) continue;
    const Link link = kConsequences[row].link;
    Roots roots;
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (named[i].as_root[row]) roots.add(list[i], link);
    }
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (named[i].as_follower[row] && roots.explain(list[i], link)) follows[i] = true;
    }
  }
  if (std::count(follows.begin(), follows.end(), true) == 0) return found;
  Diagnostics left;
  for (std::size_t i = 0; i < follows.size(); ++i) {
    if (!follows[i]) left.add(list[i]);
  }
  return left;
}

}  // namespace rigor::rules
