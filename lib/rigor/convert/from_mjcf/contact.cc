// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/from_mjcf/contact.h>

#include <map>
#include <string>

#include <rigor/read/values.h>

namespace rigor::convert {
namespace {

struct Masks {
  std::uint32_t type = 0, affinity = 0;
  auto operator<=>(const Masks&) const = default;
};

/// By the class of the element, or the nearest `childclass` around it.
Masks masks_of(const MjcfPlan& plan, xml::Element geom) {
  std::string name = mjcf_word(geom, "class");
  for (auto at = geom.parent(); name.empty() && at; at = at->parent()) {
    name = mjcf_word(*at, "childclass");
  }
  const auto id = plan.scope.defaults.find(name);
  const read::MjcfValues values =
      plan.scope.defaults.values(geom, "geom", id.value_or(read::MjcfDefaults::kMain));
  const auto bits = [&](std::string_view attribute) {
    const double value = values.number(attribute, 1).value;
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(value));
  };
  return {bits("contype"), bits("conaffinity")};
}

bool touch(const Masks& a, const Masks& b) {
  return (a.type & b.affinity) != 0 || (b.type & a.affinity) != 0;
}

}  // namespace

std::vector<std::uint32_t> links_that_touch_others(const MjcfPlan& plan) {
  std::map<std::uint32_t, Masks> links;
  std::map<Masks, int> counts;
  for (std::uint32_t i = 0; i < plan.root().links.size(); ++i) {
    if (i == plan.world || !plan.chosen[i]) continue;
    Masks all;
    for (const auto id : plan.link(i).collisions) {
      const Masks one = masks_of(plan, plan.source.source.documents.element(plan.root()[id].site));
      all.type |= one.type;
      all.affinity |= one.affinity;
    }
    if ((all.type | all.affinity) == 0) continue;
    links.emplace(i, all);
    ++counts[all];
  }
  std::map<std::uint32_t, int> others;  // that it may touch
  for (const auto& [i, own] : links) {
    others[i] = touch(own, own) ? -1 : 0;
    for (const auto& [masks, count] : counts) others[i] += touch(own, masks) ? count : 0;
  }
  for (const auto& [i, own] : links) {
    const auto parent = links.find(plan.is_carried(i) ? plan.parent_of(i) : robot::kNoIndex);
    if (parent == links.end() || !touch(own, parent->second)) continue;
    --others[i];
    --others[parent->first];
  }
  std::vector<std::uint32_t> result;
  for (const auto& [i, count] : others) {
    if (count > 0) result.push_back(i);
  }
  return result;
}

}  // namespace rigor::convert
