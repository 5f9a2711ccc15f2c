// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Words for links of one model that are in each other at the start (robot/link_overlaps.h), and which of
// them may collide.

#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/read/values.h>
#include <rigor/robot/link_overlaps.h>
#include <rigor/rules/context.h>

namespace rigor::rules {

/// Links whose `self_collide` (in URDF a `<gazebo>` block's) is true, and those of models where it is.
class SelfColliding {
 public:
  SelfColliding(const model::Root& root, const Context& context) : root_(root), context_(context) {
    if (!context.is_urdf()) {
      for (const model::Model& model : root.models) {
        models_.push_back(root.own(model.site) && model.self_collide.value);
      }
      return;
    }
    for (const model::GazeboBlock& block : root.gazebo_blocks) {
      if (!root.own(block.site) || !is_flagged(block)) continue;
      if (block.reference.value.empty()) all_ = true;
      blocks_.push_back(block.reference.value);
    }
  }

  bool any() const {
    for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
      if ((*this)(model::Id<model::Link>{i})) return true;
    }
    return false;
  }

  bool operator()(model::Id<model::Link> id) const {
    const model::Link& link = root_[id];
    if (context_.is_urdf()) {
      return all_ || std::find(blocks_.begin(), blocks_.end(), link.name.value) != blocks_.end();
    }
    if (!root_.own(link.site)) return false;
    return link.self_collide.written ? link.self_collide.value : models_[link.model.value];
  }

 private:
  static bool is_flagged(const model::GazeboBlock& block) {
    for (const std::string_view name : {"self_collide", "selfCollide"}) {
      const auto* flag = find(block.content, name);
      if (flag != nullptr && read::bool_field(*flag).value) return true;
    }
    return false;
  }

  const model::Root& root_;
  const Context& context_;
  bool all_ = false;
  std::vector<std::string_view> blocks_;
  std::vector<bool> models_;
};

/// Whether the two may touch: one that collides with its own model is enough.
inline bool self_collide(const robot::LinkOverlap& pair, const SelfColliding& self_colliding) {
  return self_colliding(pair.a->link) || self_colliding(pair.b->link);
}

/// One finding for a model, which names the pair that is deepest in each other.
inline void report_overlaps(const model::Model& model, const std::vector<robot::LinkOverlap>& pairs,
                            std::string_view where, Context& context) {
  if (pairs.empty()) return;
  const model::Root& root = context.root();
  const robot::LinkOverlap& worst = *std::max_element(
      pairs.begin(), pairs.end(),
      [](const robot::LinkOverlap& a, const robot::LinkOverlap& b) { return a.depth < b.depth; });
  const std::string others = pairs.size() == 1
                                 ? std::string()
                                 : fmt::format("; {} more pair{} too", pairs.size() - 1,
                                               pairs.size() == 2 ? " does" : "s do");
  Finding finding{
      .where = model.site.name,
      .message = fmt::format(
          "the links '{}' and '{}' overlap by {:.2g} m {}, and no joint connects them{}",
          root[worst.a->link].name.value, root[worst.b->link].name.value, worst.depth, where,
          others),
      .subject = context.subject(model)};
  for (const model::Collision* collision : {worst.a, worst.b}) {
    if (!root.own(collision->site)) continue;
    finding.related.push_back(
        {collision->geometry.site.name, fmt::format("of '{}'", root[collision->link].name.value)});
  }
  context.report(std::move(finding));
}

}  // namespace rigor::rules
