// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/simplify/rest_contacts.h>

#include <set>

#include <rigor/robot/collision/self_collisions.h>

namespace rigor::author {
namespace {

class BodiesAtRest {
 public:
  BodiesAtRest(const robot::Robot& robot, const robot::FindSurface& surfaces)
      : bodies_(robot, surfaces),
        poses_(bodies_.placed(body_poses(robot, robot::rest_positions(robot)))) {}

  bool has_shape(std::uint32_t body) const { return bodies_.has_shape(body); }
  bool touch(const BodyPair& pair) const {
    return bodies_.collide(pair.first, pair.second, poses_);
  }

 private:
  robot::CollisionBodies bodies_;
  robot::CollisionPoses poses_;
};

}  // namespace

RestContacts::RestContacts(const robot::Robot& before, const robot::FindSurface& surfaces,
                           std::vector<bool> has_collision) {
  const BodiesAtRest bodies(before, surfaces);
  for (std::uint32_t i = 0; i < has_collision.size(); ++i)
    has_collision[i] = has_collision[i] || bodies.has_shape(i);
  std::set<BodyPair> adjacent;
  for (const robot::LinkPair& pair : adjacent_pairs(before, has_collision))
    adjacent.insert({pair.a, pair.b});
  for (std::uint32_t a = 0; a < has_collision.size(); ++a) {
    for (std::uint32_t b = a + 1; b < has_collision.size(); ++b) {
      if (!has_collision[a] || !has_collision[b] || adjacent.contains({a, b})) continue;
      pairs_.emplace_back(a, b);
      touched_.push_back(bodies.touch({a, b}));
    }
  }
}

std::vector<BodyPair> RestContacts::added(const robot::Robot& after,
                                          const robot::FindSurface& surfaces) const {
  const BodiesAtRest bodies(after, surfaces);
  std::vector<BodyPair> found;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (!touched_[i] && bodies.touch(pairs_[i])) found.push_back(pairs_[i]);
  }
  return found;
}

}  // namespace rigor::author
