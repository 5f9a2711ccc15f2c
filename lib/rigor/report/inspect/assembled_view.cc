// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/inspect/assembled_view.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/mass/mesh/survey.h>
#include <rigor/report/json/values.h>
#include <rigor/report/number.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/report/tool.h>
#include <rigor/robot/assembled/assembled.h>
#include <rigor/robot/assembled/axles.h>
#include <rigor/robot/assembled/symmetry.h>
#include <rigor/robot/assembled/travel.h>
#include <rigor/robot/assembled/twins.h>

namespace rigor::report {
namespace {

using model::Id;

constexpr int kDigits = 4;
constexpr double kTouching = 1e-9;  // m

struct SeenPair {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::optional<bool> mirrored;  ///< nothing without a plane
};

struct SeenWheel {
  robot::Wheel wheel;
  std::optional<std::uint32_t> beside;  ///< the link of the other wheel on its axle
};

struct SeenDistance {
  std::uint32_t link = 0;
  std::uint32_t carrier = 0;  ///< link
  std::optional<double> gap;  ///< m; nothing when one of the two has no shape
  bool slides = false;        ///< whether positions are m, not rad
  std::vector<robot::Stand>
      positions;  ///< within the limits of the joint; of what is fixed to either, too
};

struct SeenModel {
  Id<model::Model> model;
  std::optional<mesh::Bounds> bounds;
  std::size_t unknown = 0;
  std::optional<robot::MirrorPlane> plane;
  std::vector<SeenPair> pairs;
  std::vector<SeenWheel> wheels;
  std::vector<SeenDistance> distances;
};

/// Between the shapes of two links.
std::optional<double> gap_between(const robot::Assembled& robot, std::uint32_t a, std::uint32_t b) {
  std::optional<double> least;
  for (const std::uint32_t s : robot.links[a].shapes) {
    for (const std::uint32_t t : robot.links[b].shapes) {
      const double gap =
          std::max(0.0, robot::separation(robot.shapes[s].box_W, robot.shapes[t].box_W));
      least = least ? std::min(*least, gap) : gap;
    }
  }
  return least;
}

class Viewer {
 public:
  explicit Viewer(const Inspection& inspection)
      : inspection_(inspection),
        root_(inspection.root),
        robot_(robot::assemble(
            root_, inspection.frames,
            [this](const model::Mesh& mesh, robot::ShapeRole) { return bounds_of(mesh); })),
        wheels_(robot::wheels(root_, inspection.frames, robot_)),
        rigid_(root_, inspection.frames, robot_) {}

  std::vector<SeenModel> all() const {
    std::vector<SeenModel> models;
    for (const Id<model::Model> top : top_models(root_)) models.push_back(look_at(top));
    return models;
  }

 private:
  std::optional<mesh::Bounds> bounds_of(const model::Mesh& mesh) const {
    const mass::MeshSurvey* survey = inspection_.find_mesh ? inspection_.find_mesh(mesh) : nullptr;
    if (survey == nullptr || !survey->usable() || survey->triangles == 0) return std::nullopt;
    return survey->bounds;
  }

  SeenModel look_at(Id<model::Model> top) const {
    SeenModel seen{top, {}, 0, {}, {}, {}, {}};
    robot::Links links;
    std::vector<std::string> names;
    for (std::uint32_t i = 0; i < robot_.links.size(); ++i) {
      if (robot_.links[i].top != top) continue;
      links.push_back(i);
      names.push_back(model::name_in(root_, top, Id<model::Link>{i}));
      seen.unknown += robot_.links[i].unknown;
    }
    seen.bounds = robot_.bounds_W(links);
    std::vector<robot::Twins> pairs =
        robot::twins({names.begin(), names.end()}, robot::Side::kAcross);
    for (robot::Twins& pair : pairs) pair = {links[pair.a], links[pair.b]};
    seen.plane = robot::symmetry_plane(robot_, pairs);
    for (const robot::Twins& pair : pairs)
      seen.pairs.push_back({pair.a, pair.b, are_mirrored(seen.plane, pair)});
    const auto axles = robot::axles(wheels_, robot_);
    for (std::size_t i = 0; i < wheels_.size(); ++i) {
      if (robot_.links[wheels_[i].link].top != top) continue;
      SeenWheel wheel{wheels_[i], {}};
      for (const robot::Axle& axle : axles) {
        if (axle.a == i) wheel.beside = wheels_[axle.b].link;
        if (axle.b == i) wheel.beside = wheels_[axle.a].link;
      }
      seen.wheels.push_back(wheel);
    }
    for (const std::uint32_t link : links) {
      const auto carrier = robot_.links[link].carrier;
      const auto parent = carrier ? inspection_.frames.ends(carrier).parent : Id<model::Link>{};
      if (parent)
        seen.distances.push_back({link, parent.value, gap_between(robot_, link, parent.value),
                                  root_[carrier].type == model::JointType::kPrismatic,
                                  positions_of(carrier)});
    }
    return seen;
  }

  std::vector<robot::Stand> positions_of(Id<model::Joint> joint) const {
    const auto sides = robot::sides_of(joint, root_, inspection_.frames, robot_, rigid_);
    const auto range = robot::limited_range(root_[joint]);
    if (!sides || !range) return {};
    return sides->between(*range);
  }

  std::optional<bool> are_mirrored(const std::optional<robot::MirrorPlane>& plane,
                                   const robot::Twins& pair) const {
    const auto& X_WA = robot_.links[pair.a].X_WL;
    const auto& X_WB = robot_.links[pair.b].X_WL;
    if (!plane || !X_WA || !X_WB) return std::nullopt;
    return robot::are_mirrored(*plane, X_WA->translation, X_WB->translation);
  }

  const Inspection& inspection_;
  const model::Root& root_;
  robot::Assembled robot_;
  std::vector<robot::Wheel> wheels_;
  robot::RigidGroups rigid_;
};

const char* axis_name(const robot::MirrorPlane& plane) {
  return plane.axis == 0 ? "x" : plane.axis == 1 ? "y" : "z";
}

/// Names as seen from the model.
struct Names {
  const model::Root& root;
  Id<model::Model> model;

  std::string link(std::uint32_t i) const { return name_in(root, model, Id<model::Link>{i}); }
  std::string quoted(std::uint32_t i) const { return '"' + printable(link(i)) + '"'; }
};

/// What the limits of the joint change: the widest gap, and the largest share that is inside the parent.
std::string range_text(const SeenDistance& distance) {
  std::string text;
  if (distance.positions.empty()) return text;
  const auto [nearest, farthest] =
      std::minmax_element(distance.positions.begin(), distance.positions.end(),
                          [](const auto& a, const auto& b) { return a.gap < b.gap; });
  const auto deepest =
      std::max_element(distance.positions.begin(), distance.positions.end(),
                       [](const auto& a, const auto& b) { return a.inside < b.inside; });
  const char* unit = distance.slides ? "m" : "rad";
  if (farthest->gap > nearest->gap) {
    text += fmt::format(", {} to {} m apart within its limits", number(nearest->gap, kDigits),
                        number(farthest->gap, kDigits));
  }
  if (deepest->inside > 0) {
    text += fmt::format(", {:.0f} % inside at {} {}", 100 * deepest->inside,
                        number(deepest->position, kDigits), unit);
  }
  return text;
}

std::string seen_text(const SeenModel& seen, const model::Root& root) {
  const Names names{root, seen.model};
  std::string text = fmt::format("model \"{}\"\n", printable(scoped_name(root, seen.model)));
  if (seen.bounds) {
    text += fmt::format("  size {} m, from {} to {} m\n",
                        numbers(seen.bounds->max - seen.bounds->min, kDigits),
                        numbers(seen.bounds->min, kDigits), numbers(seen.bounds->max, kDigits));
  }
  if (seen.unknown > 0) text += fmt::format("  {} not checked\n", counted(seen.unknown, "shape"));
  if (seen.plane) {
    text += fmt::format("  symmetry plane {} = {} m: {} of {} mirrored\n", axis_name(*seen.plane),
                        number(seen.plane->at, kDigits), seen.plane->pairs,
                        counted(seen.pairs.size(), "pair"));
  }
  for (const SeenPair& pair : seen.pairs) {
    text += fmt::format("  pair {} {}{}\n", names.quoted(pair.a), names.quoted(pair.b),
                        !pair.mirrored   ? ""
                        : *pair.mirrored ? ": mirrored"
                                         : ": not mirrored");
  }
  for (const SeenWheel& seen_wheel : seen.wheels) {
    const robot::Wheel& wheel = seen_wheel.wheel;
    text += fmt::format(
        "  wheel {}: radius {} m, axis {}{}\n", names.quoted(wheel.link),
        number(wheel.radius(), kDigits), numbers(wheel.axis_W, kDigits),
        seen_wheel.beside ? ", on one axle with " + names.quoted(*seen_wheel.beside) : "");
  }
  for (const SeenDistance& distance : seen.distances) {
    text += fmt::format("  link {}: {} {}{}\n", names.quoted(distance.link),
                        !distance.gap               ? std::string("distance unknown to")
                        : *distance.gap < kTouching ? std::string("touches")
                                                    : number(*distance.gap, kDigits) + " m from",
                        names.quoted(distance.carrier), range_text(distance));
  }
  return text;
}

Json seen_json(const SeenModel& seen, const model::Root& root) {
  const Names names{root, seen.model};
  Json pairs = Json::array(), wheels = Json::array(), distances = Json::array();
  for (const SeenPair& pair : seen.pairs) {
    pairs.push_back({{"links", {names.link(pair.a), names.link(pair.b)}},
                     {"mirrored", pair.mirrored ? Json(*pair.mirrored) : Json(nullptr)}});
  }
  for (const SeenWheel& seen_wheel : seen.wheels) {
    const robot::Wheel& wheel = seen_wheel.wheel;
    wheels.push_back(
        {{"link", names.link(wheel.link)},
         {"joint", root.joints[wheel.joint].name.value},
         {"radius", finite(wheel.radius())},
         {"center", vector_of(wheel.center_W)},
         {"axis", vector_of(wheel.axis_W)},
         {"beside", seen_wheel.beside ? Json(names.link(*seen_wheel.beside)) : Json(nullptr)}});
  }
  for (const SeenDistance& distance : seen.distances) {
    Json positions = Json::array();
    for (const robot::Stand& stand : distance.positions) {
      positions.push_back({{"position", finite(stand.position)},
                           {"distance", finite(stand.gap)},
                           {"inside", finite(stand.inside)}});
    }
    distances.push_back({{"link", names.link(distance.link)},
                         {"parent", names.link(distance.carrier)},
                         {"distance", distance.gap ? Json(finite(*distance.gap)) : Json(nullptr)},
                         {"positions", std::move(positions)}});
  }
  Json bounds = nullptr;
  if (seen.bounds)
    bounds = {{"min", vector_of(seen.bounds->min)}, {"max", vector_of(seen.bounds->max)}};
  Json plane = nullptr;
  if (seen.plane) plane = {{"normal", axis_name(*seen.plane)}, {"at", finite(seen.plane->at)}};
  return {{"name", scoped_name(root, seen.model)},
          {"bounds", std::move(bounds)},
          {"shapes_not_checked", seen.unknown},
          {"symmetry_plane", std::move(plane)},
          {"pairs", std::move(pairs)},
          {"wheels", std::move(wheels)},
          {"distances", std::move(distances)}};
}

}  // namespace

std::string assembled_text(const Inspection& inspection) {
  std::string text;
  for (const SeenModel& seen : Viewer(inspection).all()) text += seen_text(seen, inspection.root);
  return text;
}

std::string assembled_json(const Inspection& inspection) {
  Json models = Json::array();
  for (const SeenModel& seen : Viewer(inspection).all())
    models.push_back(seen_json(seen, inspection.root));
  const Json all{{"tool", {{"name", kToolName}, {"version", tool_version()}}},
                 {"schema_version", kSchemaVersion},
                 {"path", inspection.path},
                 {"models", std::move(models)}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace rigor::report
