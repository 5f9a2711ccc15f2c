// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Elements that MuJoCo takes in some bodies only: joints and inertials not in the world, planes only in what
// never moves.

#include <rigor/read/mjcf/mjcf_checks.h>

namespace rigor::read {
namespace {

bool has_a_joint(const MjcfTree& tree, xml::Element parent) {
  for (const xml::Element child : tree.children(parent)) {
    const std::string_view tag = child.name();
    if (tag == "joint" || tag == "freejoint") return true;
    if ((tag == "frame" || tag == "replicate") && has_a_joint(tree, child)) return true;
  }
  return false;
}

enum class MjcfBodyState : std::uint8_t { kIsWorld, kStatic, kMoves };

class MjcfPlaceCheck {
 public:
  MjcfPlaceCheck(const MjcfScope& scope, MjcfFacts& facts) : scope_(scope), facts_(facts) {}

  void check(xml::Element parent, std::size_t class_id, MjcfBodyState state) {
    for (const xml::Element child : scope_.tree.children(parent)) {
      const std::string_view tag = child.name();
      if (tag == "geom" && state == MjcfBodyState::kMoves) check_plane(child, class_id);
      const bool moves = tag == "joint" || tag == "freejoint";
      if (state == MjcfBodyState::kIsWorld && (moves || tag == "inertial")) {
        facts_.push_back({.kind = MjcfFactKind::kWorldPart,
                          .where = child.tag_span(),
                          .name = std::string(tag)});
      }
      if (tag != "body" && tag != "frame" && tag != "replicate") continue;
      MjcfBodyState inside = state;
      if (tag == "body" && state != MjcfBodyState::kMoves) {
        inside = has_a_joint(scope_.tree, child) ? MjcfBodyState::kMoves : MjcfBodyState::kStatic;
      }
      const auto childclass = mjcf_name(child, "childclass");
      check(child, scope_.defaults.find(childclass.value).value_or(class_id), inside);
    }
  }

 private:
  void check_plane(xml::Element geom, std::size_t class_id) {
    const MjcfValues values =
        scope_.defaults.values(geom, "geom", mjcf_class_of(scope_, geom, class_id));
    if (values.string("type").value != "plane") return;
    const std::string name = mjcf_name(geom, "name").value;
    facts_.push_back({.kind = MjcfFactKind::kShapeRejected,
                      .where = geom.tag_span(),
                      .subject = name.empty() ? name : "geom " + name,
                      .detail = "a plane on a body that moves"});
  }

  const MjcfScope& scope_;
  MjcfFacts& facts_;
};

}  // namespace

void check_mjcf_places(const MjcfScope& scope, MjcfFacts& facts) {
  for (const xml::Element section : scope.tree.children(scope.tree.root())) {
    if (section.name() != "worldbody") continue;
    MjcfPlaceCheck(scope, facts).check(section, MjcfDefaults::kMain, MjcfBodyState::kIsWorld);
  }
}

}  // namespace rigor::read
