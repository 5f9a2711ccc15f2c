// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/scene/check.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace rigor::simulate {
namespace {

using model::JointType;

/// Unit vectors and quaternions are so long but for rounding.
constexpr double kUnitSlack = 1e-9;

bool all_finite(std::initializer_list<double> values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}
bool is_finite(const Vector3& v) { return all_finite({v.x, v.y, v.z}); }
bool is_finite(const Pose& X) {
  const Quaternion& q = X.rotation;
  return is_finite(X.translation) && all_finite({q.w, q.x, q.y, q.z});
}
bool is_unit(const Vector3& v) { return std::abs(length(v) - 1) < kUnitSlack; }
bool is_unit(const Quaternion& q) {
  return std::abs(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z - 1) < kUnitSlack;
}

/// Not negative, and infinite at most.
bool is_amount(double value) { return value >= 0; }
bool is_finite_amount(double value) { return value >= 0 && std::isfinite(value); }

struct SceneFault {
  FactKind kind;
  std::string name;
  double value = 0;
  double limit = 0;
};
using MaybeFault = std::optional<SceneFault>;

MaybeFault not_finite(std::string name) {
  return SceneFault{FactKind::kNotFinite, std::move(name)};
}
MaybeFault out_of_range(std::string name) {
  return SceneFault{FactKind::kTooLarge, std::move(name)};
}

MaybeFault fault_of_pose(const Pose& X) {
  if (!is_finite(X)) return not_finite("pose");
  if (!is_unit(X.rotation)) return not_finite("rotation");
  return std::nullopt;
}

MaybeFault fault_of_size(double least, std::string_view name) {
  if (std::isnan(least) || std::isinf(least)) return not_finite(std::string(name));
  if (least > 0) return std::nullopt;
  return SceneFault{FactKind::kShapeSize, std::string(name), least};
}

class SceneCheck {
 public:
  explicit SceneCheck(const Scene& scene) : scene_(scene) {}

  Facts check() {
    if (Facts counts = check_counts(scene_); !counts.empty()) return counts;
    if (!is_finite(scene_.gravity)) say({}, scene_.name, not_finite("gravity"));
    say({}, scene_.name, fault_of(scene_.solver));
    std::vector<MaybeFault> of_meshes;
    for (const mesh::TriangleMesh& mesh : scene_.meshes) of_meshes.push_back(fault_of(mesh));
    for (const SceneBody& body : scene_.bodies) say(body.where, body.name, fault_of(body));
    for (const SceneShape& shape : scene_.shapes) {
      MaybeFault fault = fault_of(shape);
      if (!fault) {
        if (const auto mesh = mesh_of_shape(shape)) fault = of_meshes[*mesh];
      }
      say(shape.where, shape.name, fault);
    }
    for (const SceneJoint& joint : scene_.joints) check(joint);
    return std::move(facts_);
  }

 private:
  void say(Span where, const std::string& subject, const MaybeFault& fault) {
    if (!fault) return;
    facts_.push_back({.kind = fault->kind,
                      .where = where,
                      .subject = subject,
                      .value = fault->value,
                      .limit = fault->limit,
                      .name = fault->name,
                      .test = {}});
  }

  MaybeFault fault_of(const SolverSettings& s) const {
    if (!(s.step > 0) || !std::isfinite(s.step)) return SceneFault{FactKind::kStep, "step", s.step};
    if (s.iterations < 1) return SceneFault{FactKind::kStep, "iterations", double(s.iterations)};
    if (!(s.sor > 0 && s.sor <= 2)) return SceneFault{FactKind::kStep, "sor", s.sor};
    if (!(s.erp >= 0 && s.erp <= 1)) return SceneFault{FactKind::kStep, "erp", s.erp};
    if (!is_finite_amount(s.cfm)) return SceneFault{FactKind::kStep, "cfm", s.cfm};
    if (!is_amount(s.max_correcting_velocity)) {
      return SceneFault{FactKind::kStep, "max_correcting_velocity", s.max_correcting_velocity};
    }
    if (!is_finite_amount(s.surface_layer)) {
      return SceneFault{FactKind::kStep, "surface_layer", s.surface_layer};
    }
    if (s.max_contacts < 1)
      return SceneFault{FactKind::kStep, "max_contacts", double(s.max_contacts)};
    return std::nullopt;
  }

  MaybeFault fault_of(const SceneBody& body) const {
    if (MaybeFault fault = fault_of_pose(body.X_WB)) return fault;
    if (body.model >= scene_.models.size()) return out_of_range("model");
    for (const std::uint32_t link : body.links) {
      if (link >= scene_.links.size()) return out_of_range("link");
    }
    if (!is_finite_amount(body.linear_damping) || !is_finite_amount(body.angular_damping)) {
      return not_finite("damping");
    }
    const mass::Verdict verdict = mass::judge(body.mass);
    if (!verdict.mass_finite) return not_finite("mass");
    if (!(body.mass.mass > 0)) return SceneFault{FactKind::kNoMass, {}, body.mass.mass};
    if (!is_finite(body.mass.com)) return not_finite("center of mass");
    if (!verdict.tensor_finite) return not_finite("inertia");
    if (!(verdict.principal[0] > 0)) {
      return SceneFault{FactKind::kInertiaImpossible, {}, verdict.principal[0]};
    }
    return std::nullopt;
  }

  MaybeFault fault_of(const mesh::TriangleMesh& mesh) const {
    if (mesh.triangles.empty()) return SceneFault{FactKind::kShapeSize, "triangles"};
    if (!std::all_of(mesh.positions.begin(), mesh.positions.end(),
                     [](const Vector3& p) { return is_finite(p); })) {
      return not_finite("vertex");
    }
    for (const mesh::Triangle& t : mesh.triangles) {
      for (const std::uint32_t corner : t) {
        if (corner >= mesh.positions.size()) {
          return SceneFault{FactKind::kTooLarge, "index of a vertex", double(corner),
                            double(mesh.positions.size())};
        }
      }
      if (!(model::length(mesh::area_vector(mesh::facet(mesh, t))) > 0)) {
        return SceneFault{FactKind::kShapeSize, "triangle without area"};
      }
    }
    return std::nullopt;
  }

  static std::optional<std::uint32_t> mesh_of_shape(const SceneShape& shape) {
    if (const auto* hull = std::get_if<ConvexHull>(&shape.kind)) return hull->mesh;
    if (const auto* soup = std::get_if<TriangleSoup>(&shape.kind)) return soup->mesh;
    return std::nullopt;
  }

  MaybeFault fault_of(const SceneShape& shape) const {
    if (MaybeFault fault = fault_of_pose(shape.X_BS)) return fault;
    if (!is_body(shape.body)) return out_of_range("body");
    if (shape.link != kWorld && shape.link >= scene_.links.size()) return out_of_range("link");
    const auto mesh = mesh_of_shape(shape);
    if (mesh && *mesh >= scene_.meshes.size()) return out_of_range("mesh");
    if (MaybeFault fault =
            std::visit([](const auto& kind) { return fault_of_kind(kind); }, shape.kind)) {
      return fault;
    }
    if (std::holds_alternative<HalfSpace>(shape.kind) && shape.body != kWorld) {
      return SceneFault{FactKind::kShapeSize, "a half space that moves"};
    }
    return fault_of(shape.surface);
  }

  static MaybeFault fault_of_kind(const mesh::Box& s) {
    if (!is_finite(s.size)) return not_finite("size");
    return fault_of_size(std::min({s.size.x, s.size.y, s.size.z}), "size");
  }
  static MaybeFault fault_of_kind(const mesh::Sphere& s) {
    return fault_of_size(s.radius, "radius");
  }
  static MaybeFault fault_of_kind(const mesh::Cylinder& s) {
    if (MaybeFault fault = fault_of_size(s.radius, "radius")) return fault;
    return fault_of_size(s.length, "length");
  }
  static MaybeFault fault_of_kind(const mesh::Capsule& s) {
    if (MaybeFault fault = fault_of_size(s.radius, "radius")) return fault;
    return fault_of_size(s.length, "length");
  }
  static MaybeFault fault_of_kind(const ConvexHull&) { return std::nullopt; }
  static MaybeFault fault_of_kind(const TriangleSoup&) { return std::nullopt; }
  static MaybeFault fault_of_kind(const HalfSpace& s) {
    if (!is_finite(s.normal)) return not_finite("normal");
    if (!is_unit(s.normal)) return SceneFault{FactKind::kAxisZero, "normal", length(s.normal)};
    return std::nullopt;
  }
  static MaybeFault fault_of_kind(const HeightGrid& s) {
    if (s.columns < 2 || s.rows < 2) return SceneFault{FactKind::kShapeSize, "samples"};
    if (s.heights.size() != std::size_t{s.columns} * s.rows) return out_of_range("samples");
    if (MaybeFault fault = fault_of_size(std::min(s.width, s.depth), "size")) return fault;
    const bool whole =
        std::all_of(s.heights.begin(), s.heights.end(), [](double h) { return std::isfinite(h); });
    return whole ? std::nullopt : not_finite("height");
  }

  static MaybeFault fault_of(const ContactSurface& s) {
    if (!is_amount(s.mu) || !is_amount(s.mu2)) return not_finite("mu");
    if (!is_finite(s.fdir1)) return not_finite("fdir1");
    if (!is_finite_amount(s.slip1) || !is_finite_amount(s.slip2)) return not_finite("slip");
    if (!is_finite_amount(s.restitution) || !is_amount(s.bounce_threshold)) {
      return not_finite("bounce");
    }
    if (!is_finite_amount(s.kp) || !is_finite_amount(s.kd)) return not_finite("kp, kd");
    if (s.max_contacts < 0) return SceneFault{FactKind::kShapeSize, "max_contacts"};
    return std::nullopt;
  }

  void check(const SceneJoint& joint) {
    if (const MaybeFault fault = fault_of(joint)) return say(joint.where, joint.name, fault);
    for (const SceneAxis& axis : joint.axes) {
      const MaybeFault fault = fault_of(axis);
      if (!fault) continue;
      const bool limits = fault->kind == FactKind::kLimitsCrossed && !axis.limit_where.nowhere();
      return say(limits ? axis.limit_where : axis.where, joint.name, fault);
    }
  }

  MaybeFault fault_of(const SceneJoint& joint) const {
    if (!is_body(joint.parent) || !is_body(joint.child)) return out_of_range("body");
    if (joint.parent == joint.child) {
      return SceneFault{FactKind::kUnreadable, "both ends are one body"};
    }
    if (!is_finite(joint.anchor_W)) return not_finite("anchor");
    if (!has_its_axes(joint))
      return SceneFault{FactKind::kAxisZero, "axes", double(joint.axes.size())};
    if (joint.axes.size() == 2 && joint.type != JointType::kGearbox) {
      const Vector3 across = cross(joint.axes[0].direction_W, joint.axes[1].direction_W);
      if (!(length(across) > 0)) return SceneFault{FactKind::kAxisZero, "axis2 along axis"};
    }
    if (!all_finite({joint.screw_pitch, joint.gearbox_ratio})) return not_finite("ratio");
    if (!is_body(joint.gearbox_reference)) return out_of_range("gearbox_reference");
    if (joint.mimics.size() > joint.axes.size()) return out_of_range("mimics");
    for (const SceneMimic& mimic : joint.mimics) {
      if (mimic.joint >= scene_.joints.size()) return out_of_range("mimic");
      if (mimic.axis >= scene_.joints[mimic.joint].axes.size()) return out_of_range("mimic");
      if (!all_finite({mimic.multiplier, mimic.offset, mimic.reference})) {
        return not_finite("mimic");
      }
    }
    return std::nullopt;
  }

  static bool has_its_axes(const SceneJoint& joint) {
    const std::size_t n = joint.axes.size();
    switch (joint.type) {
      case JointType::kRevolute:
      case JointType::kPrismatic:
      case JointType::kScrew: return n == 1;
      case JointType::kGearbox: return n == 1 || n == 2;
      case JointType::kUniversal:
      case JointType::kRevolute2: return n == 2;
      case JointType::kBall:
      case JointType::kFixed: return n == 0;
      default: return false;
    }
  }

  static MaybeFault fault_of(const SceneAxis& axis) {
    if (!is_finite(axis.direction_W)) return not_finite("axis");
    if (!is_unit(axis.direction_W)) {
      return SceneFault{FactKind::kAxisZero, "axis", length(axis.direction_W)};
    }
    if (!std::isfinite(axis.start)) return not_finite("start");
    if (std::isnan(axis.lower) || std::isnan(axis.upper)) return not_finite("limit");
    if (axis.lower > axis.upper || axis.lower == kInfinity || axis.upper == -kInfinity) {
      return SceneFault{FactKind::kLimitsCrossed, {}, axis.lower, axis.upper};
    }
    if (!is_amount(axis.effort) || !is_amount(axis.velocity)) return not_finite("effort");
    if (!is_finite_amount(axis.damping) || !is_finite_amount(axis.friction)) {
      return not_finite("dynamics");
    }
    if (!std::isfinite(axis.spring_reference) || !is_finite_amount(axis.spring_stiffness)) {
      return not_finite("spring");
    }
    if (!(axis.stop_erp >= 0 && axis.stop_erp <= 1) || !is_finite_amount(axis.stop_cfm)) {
      return not_finite("stop");
    }
    return std::nullopt;
  }

  bool is_body(std::uint32_t body) const { return body == kWorld || body < scene_.bodies.size(); }

  const Scene& scene_;
  Facts facts_;
};

}  // namespace

Facts check_counts(const Scene& scene) {
  std::size_t triangles = 0;
  for (const mesh::TriangleMesh& mesh : scene.meshes) triangles += mesh.triangles.size();
  Facts facts;
  const auto say = [&](std::string_view name, std::size_t count, std::size_t most) {
    if (count <= most) return;
    facts.push_back({.kind = FactKind::kTooLarge,
                     .where = scene.models.empty() ? Span{} : scene.models.front().where,
                     .subject = scene.name,
                     .value = static_cast<double>(count),
                     .limit = static_cast<double>(most),
                     .name = std::string(name),
                     .test = {}});
  };
  say("bodies", scene.bodies.size(), kMaxBodies);
  say("shapes", scene.shapes.size(), kMaxShapes);
  say("joints", scene.joints.size(), kMaxJoints);
  say("triangles", triangles, kMaxSceneTriangles);
  return facts;
}

Facts check_scene(const Scene& scene) { return SceneCheck(scene).check(); }

}  // namespace rigor::simulate
