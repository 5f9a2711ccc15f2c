// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/link_body.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>
#include <variant>

#include <rigor/mass/mesh/survey.h>
#include <rigor/mass/polyline.h>
#include <rigor/mass/shapes.h>

namespace rigor::mass {
namespace {

// What libsdformat, MuJoCo and Drake take where nothing is written: water.
constexpr double kDefaultDensity = 1000;  // kg/m³

struct Answer {
  std::optional<Solid> solid;
  NoSolid why = NoSolid::kNone;
  MeshState mesh = MeshState::kSolid;
  BodyFrom from = BodyFrom::kMesh;
};

/// What a shape is as a solid, in its own frame.
struct Solve {
  const FindMesh& find_mesh;
  const model::Shape& shape;

  Answer operator()(const model::NoShape&) const { return {.why = NoSolid::kNoShape}; }
  Answer operator()(const model::Plane&) const { return {.why = NoSolid::kUnbounded}; }
  Answer operator()(const model::Heightmap&) const { return {.why = NoSolid::kUnbounded}; }
  Answer operator()(const model::Image&) const { return {.why = NoSolid::kUnbounded}; }
  Answer operator()(const model::Polyline& outline) const {
    return or_why(solid_of(outline), NoSolid::kOutline);
  }
  Answer operator()(const model::Mesh& mesh) const {
    const MeshSurvey* survey = find_mesh ? find_mesh(mesh) : nullptr;
    if (survey == nullptr) return {.why = NoSolid::kNoMesh};
    const model::Vector3& scale = mesh.scale.value;
    if (scale.x == 0 || scale.y == 0 || scale.z == 0) return {.why = NoSolid::kSize};
    const MeshBody body = body_of(*survey, scale);
    Answer answer = or_why(body.solid, NoSolid::kMesh);
    answer.mesh = body.state;
    answer.from = body.from;
    return answer;
  }
  template <class Primitive>
  Answer operator()(const Primitive&) const {
    return or_why(solid_of(shape), NoSolid::kSize);
  }

  static Answer or_why(std::optional<Solid> solid, NoSolid why) {
    if (!solid) return {.why = why};
    return {.solid = std::move(solid)};
  }
};

/// Collisions or visuals of one link.
template <class Part>
struct Parts {
  const model::Root& root;
  const model::Frames& frames;
  model::Id<model::Link> link;
  const std::vector<model::Id<Part>>& ids;

  /// As written, so that nothing is lost to a detour over other frames.
  std::optional<model::Pose> pose(model::Id<Part> id) const {
    const model::PoseField& field = root[id].pose;
    if (field.relative_to.value.empty()) return field.pose.value;
    const auto X_WL = frames.pose(link);
    const auto X_WP = frames.pose(id);
    if (!X_WL || !X_WP) return std::nullopt;
    return compose(inverse(*X_WL), *X_WP);
  }

  static std::string kind() {
    return std::is_same_v<Part, model::Collision> ? "collision" : "visual";
  }

  double density(const Part& part) const {
    if constexpr (std::is_same_v<Part, model::Collision>) {
      if (part.density.written) return part.density.value;
    }
    const model::Field<double>& of_link = root[link].inertial.density;
    return of_link.written ? of_link.value : kDefaultDensity;
  }

  PartBody body(model::Id<Part> id, const FindMesh& find_mesh) const {
    const Part& part = root[id];
    const Answer answer = std::visit(Solve{find_mesh, part.geometry.shape}, part.geometry.shape);
    PartBody result{.name = part.name.value,
                    .where = part.geometry.site.name,
                    .why = answer.why,
                    .mesh = answer.mesh,
                    .from = answer.from,
                    .density = density(part)};
    if (!answer.solid) return result;
    if (const auto X_LP = pose(id)) {
      result.unit = transformed(*X_LP, with_mass(*answer.solid, answer.solid->volume));
    } else {
      result.why = NoSolid::kFrame;
    }
    return result;
  }

  std::vector<PartBody> bodies(const FindMesh& find_mesh) const {
    std::vector<PartBody> result;
    for (const model::Id<Part> id : ids) {
      result.push_back(body(id, find_mesh));
      std::string& name = result.back().name;
      if (name.empty()) name = kind() + ' ' + std::to_string(result.size());
    }
    return result;
  }

  /// A part with a volume, and where it is.
  struct Ball {
    std::size_t part = 0;
    model::Pose pose;
    double reach = 0;
  };

  /// By x.
  std::vector<Ball> balls() const {
    std::vector<Ball> result;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const double reach = reach_of(root[ids[i]].geometry.shape);
      const auto at = pose(ids[i]);
      if (at && reach > 0 && std::isfinite(at->translation.x)) result.push_back({i, *at, reach});
    }
    std::stable_sort(result.begin(), result.end(), [](const Ball& a, const Ball& b) {
      return a.pose.translation.x < b.pose.translation.x;
    });
    return result;
  }

  PartOverlaps overlaps() const {
    const std::vector<Ball> all = balls();
    std::vector<std::pair<std::size_t, std::size_t>> near;  // places in `all`, part by part
    double most = 0;
    for (const Ball& ball : all) most = std::max(most, ball.reach);
    PartOverlaps result;
    for (std::size_t a = 0; a < all.size() && result.complete; ++a) {
      const model::Vector3& at = all[a].pose.translation;
      for (std::size_t b = a + 1; b < all.size(); ++b) {
        const model::Vector3& other = all[b].pose.translation;
        if (other.x - at.x > all[a].reach + most) break;
        if (length(other - at) > all[a].reach + all[b].reach) continue;
        near.emplace_back(a, b);
        result.complete = near.size() <= kMaxCompared;
        if (!result.complete) break;
      }
    }
    near.resize(std::min(near.size(), kMaxCompared));
    for (const auto& [a, b] : near) {
      const Ball& first = all[a].part < all[b].part ? all[a] : all[b];
      const Ball& second = all[a].part < all[b].part ? all[b] : all[a];
      const double share = overlap({root[ids[first.part]].geometry.shape, first.pose},
                                   {root[ids[second.part]].geometry.shape, second.pose});
      if (share > 0) result.list.push_back({first.part, second.part, share});
    }
    std::sort(result.list.begin(), result.list.end(), [](const auto& a, const auto& b) {
      return std::pair(a.first, a.second) < std::pair(b.first, b.second);
    });
    return result;
  }
};

/// `use` of the parts that `from` names.
auto with_parts(const model::Root& root, const model::Frames& frames, model::Id<model::Link> link,
                From from, const auto& use) {
  if (from == From::kVisuals) {
    return use(Parts<model::Visual>{root, frames, link, root[link].visuals});
  }
  return use(Parts<model::Collision>{root, frames, link, root[link].collisions});
}

}  // namespace

bool LinkBody::complete() const {
  return !parts.empty() && std::all_of(parts.begin(), parts.end(), [](const PartBody& part) {
    return part.why == NoSolid::kNone;
  });
}

LinkBody link_body(const model::Root& root, const model::Frames& frames,
                   model::Id<model::Link> link, From from, const FindMesh& find_mesh) {
  const auto bodies = [&find_mesh](const auto& parts) { return parts.bodies(find_mesh); };
  return {from, with_parts(root, frames, link, from, bodies)};
}

PartOverlaps overlaps_in(const model::Root& root, const model::Frames& frames,
                         model::Id<model::Link> link, From from) {
  return with_parts(root, frames, link, from, [](const auto& parts) { return parts.overlaps(); });
}

MassProperties of_density(const LinkBody& body, double density) {
  MassProperties sum;
  for (const PartBody& part : body.parts)
    sum = add(sum, with_mass(part.unit, density * part.unit.mass));
  return sum;
}

MassProperties of_own_densities(const LinkBody& body) {
  MassProperties sum;
  for (const PartBody& part : body.parts) {
    sum = add(sum, with_mass(part.unit, part.density * part.unit.mass));
  }
  return sum;
}

}  // namespace rigor::mass
