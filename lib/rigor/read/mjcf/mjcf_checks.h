// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is wrong in an MJCF file beyond its schema: names, references, numbers, bodies, actuators. Each check walks
// the file with its includes once; `read_mjcf` calls them all.

#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/model/model.h>
#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/read/mjcf/mjcf_scope.h>

namespace rigor::read {

/// Names by kind: "joint", "body", "geom", "site", "mesh", …
using MjcfNames = std::map<std::string, std::set<std::string, std::less<>>, std::less<>>;

/// Whether names come from other files or recipes, so that what is not here may be there.
bool makes_names(const MjcfScope& scope);

/// What elements outside the bodies need.
void check_mjcf_elements(const MjcfScope& scope, MjcfFacts& facts);

MjcfNames check_mjcf_names(const MjcfScope& scope, MjcfFacts& facts);
void check_mjcf_references(const MjcfScope& scope, const MjcfNames& names, MjcfFacts& facts);
void check_mjcf_assets(const MjcfScope& scope, const Disk& disk, MjcfFacts& facts);
/// Soft bodies: the files that they are made of, which are not opened here, and whether the integrator takes them.
void check_mjcf_flexes(const MjcfScope& scope, const Disk& disk, MjcfFacts& facts);
void check_mjcf_plugins(const MjcfScope& scope, MjcfFacts& facts);
/// Of a model that the element attaches: options that MuJoCo cannot join with those of the file.
void check_mjcf_attached(const MjcfScope& scope, const MjcfScope& attached, xml::Element element,
                         MjcfFacts& facts);
void check_mjcf_bodies(const MjcfScope& scope, MjcfFacts& facts);
void check_mjcf_places(const MjcfScope& scope, MjcfFacts& facts);
void check_mjcf_values(const MjcfScope& scope, MjcfFacts& facts);
void check_mjcf_targets(const MjcfScope& scope, MjcfFacts& facts);
/// Of a joint or tendon: whether the switch, `limited`, goes with the range.
void check_mjcf_range(const MjcfValues& values, const MjcfSettings& settings,
                      std::string_view range, std::string_view limited, MjcfFacts& facts);
void check_mjcf_plausibility(const MjcfScope& scope, MjcfFacts& facts);
void check_mjcf_states(const MjcfScope& scope, MjcfFacts& facts);
void check_mjcf_contacts(const MjcfScope& scope, MjcfFacts& facts);
void check_mjcf_actuators(const MjcfScope& scope, MjcfFacts& facts);
/// Against the positions, velocities and controls that the bodies and actuators have.
void check_mjcf_keyframes(const MjcfScope& scope, MjcfFacts& facts);

/// The class that an element has: its own, else that of the bodies and frames around it.
/// So many digits of a number at most, independent of the locale.
std::string mjcf_digits(double value, int digits = 4);

std::size_t mjcf_class_of(const MjcfScope& scope, xml::Element element, std::size_t around);

/// Calls `use(section, element)` for all elements below the root, with the name of the section that they are in.
void for_each_mjcf_element(const MjcfTree& tree,
                           const std::function<void(std::string_view, xml::Element)>& use);

/// Calls `use(element, class_id)` for everything in the bodies, outermost first.
template <class Use>
void for_each_in_bodies(const MjcfScope& scope, xml::Element parent, std::size_t class_id,
                        const Use& use) {
  for (const xml::Element child : scope.tree.children(parent)) {
    const std::string_view tag = child.name();
    std::size_t inside = class_id;
    if (const auto childclass = mjcf_name(child, "childclass"); childclass.written) {
      inside = scope.defaults.find(childclass.value).value_or(class_id);
    }
    use(child, mjcf_class_of(scope, child, class_id));
    if (tag == "body" || tag == "frame" || tag == "replicate") {
      for_each_in_bodies(scope, child, inside, use);
    }
  }
}

template <class Use>
void for_each_in_bodies(const MjcfScope& scope, const Use& use) {
  for (const xml::Element section : scope.tree.children(scope.tree.root())) {
    if (section.name() == "worldbody") {
      for_each_in_bodies(scope, section, MjcfDefaults::kMain, use);
    }
  }
}

}  // namespace rigor::read
