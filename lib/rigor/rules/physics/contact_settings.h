// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What contacts of links are given, in either format: the `<surface>` of an SDF's collision, or what the
// `<gazebo reference>` of a URDF's link says.
//
//   for (const ContactSettings& contact : contact_settings(context)) check(contact.kp, contact.link);

#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <rigor/model/model.h>
#include <rigor/rules/context.h>
#include <rigor/write/numbers.h>

namespace rigor::rules {

struct ContactSettings {
  model::Id<model::Link> link;
  const model::Collision* collision = nullptr;  ///< of an SDF
  std::string subject;
  model::Field<double> mu = {}, mu2 = {};  ///< written ones only, as all that follow
  model::Field<double> kp = {};            ///< N/m
  model::Field<double> kd = {};            ///< N·s/m
  model::Field<double> min_depth = {};     ///< m
};

/// Of the file itself.
inline std::vector<ContactSettings> contact_settings(const Context& context) {
  const model::Root& root = context.root();
  std::vector<ContactSettings> all;
  for (const model::Collision& collision : root.collisions) {
    const model::Surface& surface = collision.surface;
    if (!context.is_sdf() || !root.own(collision.site) || !collision.link) continue;
    if (!surface.mu.written && !surface.kp.written && !surface.kd.written &&
        !surface.min_depth.written) {
      continue;
    }
    all.push_back({collision.link, &collision, context.subject(collision), surface.mu, surface.mu2,
                   surface.kp, surface.kd, surface.min_depth});
  }
  if (!context.is_urdf() || root.gazebo_blocks.empty()) return all;
  std::unordered_map<std::string_view, std::uint32_t> links;
  for (std::uint32_t i = 0; i < root.links.size(); ++i) links.emplace(root.links[i].name.value, i);
  for (const model::GazeboBlock& block : root.gazebo_blocks) {
    const auto link = links.find(block.reference.value);
    if (link == links.end() || !root.own(block.site)) continue;
    ContactSettings contact{.link = {link->second},
                            .subject = context.subject(root.links[link->second])};
    const auto take = [&](const model::Parameter& given, model::Field<double>& field) {
      const auto number = write::number_in(given.value.value);
      if (number) field = {*number, given.value.span, true};
    };
    for (const model::Parameter& given : block.content) {
      if (given.name == "mu1" || given.name == "mu") take(given, contact.mu);
      if (given.name == "mu2") take(given, contact.mu2);
      if (given.name == "kp") take(given, contact.kp);
      if (given.name == "kd") take(given, contact.kd);
      if (given.name == "minDepth" || given.name == "min_depth") take(given, contact.min_depth);
    }
    all.push_back(std::move(contact));
  }
  return all;
}

}  // namespace rigor::rules
