// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <map>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::collision_duplicate {

/// Kind, numbers of pose and sizes, file: equal for shapes that fill the same space.
using Key = std::tuple<std::size_t, std::vector<double>, std::string>;

struct Describe {
  std::vector<double>& numbers;
  std::string& file;

  void add(const model::Field<double>& field) { numbers.push_back(field.value); }
  void add(const model::Field<model::Vector3>& field) {
    const model::Vector3& v = field.value;
    numbers.insert(numbers.end(), {v.x, v.y, v.z});
  }
  template <class Round>
  bool round(const Round& s) {
    add(s.radius);
    add(s.length);
    return s.radius.written && s.length.written;
  }
  bool operator()(const model::Box& s) { return add(s.size), s.size.written; }
  bool operator()(const model::Sphere& s) { return add(s.radius), s.radius.written; }
  bool operator()(const model::Ellipsoid& s) { return add(s.radii), s.radii.written; }
  bool operator()(const model::Cylinder& s) { return round(s); }
  bool operator()(const model::Capsule& s) { return round(s); }
  bool operator()(const model::Cone& s) { return round(s); }
  bool operator()(const model::Mesh& s) {
    add(s.scale);
    file = s.uri.value + '\n' + s.submesh.value + (s.center.value ? "\ncentred" : "");
    return !s.uri.value.empty();
  }
  /// Of the others two in one place are no likely slip, or not distinguished by so little.
  template <class Other>
  bool operator()(const Other&) {
    return false;
  }
};

bool describe(const model::Collision& collision, model::Id<model::Collision> id, Context& context,
              Key& key) {
  auto& [kind, numbers, file] = key;
  kind = collision.geometry.shape.index();
  const auto X_WC = context.frames().pose(id);
  if (!X_WC || !std::visit(Describe{numbers, file}, collision.geometry.shape)) return false;
  const auto& [p, q] = *X_WC;
  numbers.insert(numbers.end(), {p.x, p.y, p.z, q.w, q.x, q.y, q.z});
  return true;
}

void check(const model::Link& link, Context& context) {
  if (link.collisions.size() < 2) return;
  const model::Root& root = context.root();
  std::map<Key, const model::Collision*> seen;
  for (const auto id : link.collisions) {
    const model::Collision& collision = root[id];
    Key key;
    if (!describe(collision, id, context, key)) continue;
    const auto [first, is_new] = seen.emplace(std::move(key), &collision);
    if (is_new || !root.own(collision.site)) continue;
    const model::Collision& other = *first->second;
    context.report(
        {.where = collision.site.name,
         .message = fmt::format("the link '{}' has the same {} in the same place already{}",
                                link.name.value, model::shape_name(collision.geometry.shape),
                                other.name.value.empty() ? "" : ": '" + other.name.value + "'"),
         .subject = context.subject(collision),
         .related = {{other.site.name, "the first one"}},
         .fix = fix_of("remove it", Applicability::kUnsafe, removed(context, collision.site))});
  }
}

Rule rule() {
  return {
      .name = "collision-duplicate",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a link has the same collision shape twice in the same place",
      .why = "Both are there: contacts count twice, so they are twice as stiff and cost twice the "
             "time; where the mass is computed from the shapes, it counts twice as well. It was "
             "copied and not moved. The part that the copy was meant for has none.",
      .what_to_do = "Give the copy its own pose and size, or remove it.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::collision_duplicate
