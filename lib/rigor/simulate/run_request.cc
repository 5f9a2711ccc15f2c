// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/run_request.h>

#include <type_traits>
#include <utility>

#include <rigor/simulate/archive.h>

namespace rigor::simulate {
namespace {

struct RunRequestFields {
  template <class Archive, class T>
  static void visit(Archive& archive, T& whole) {
    using Kind = std::remove_const_t<T>;
    if constexpr (kIsOneOf<Kind, Phase, Command, Push, Tilt, Assertion, Scenario, SolverSettings>) {
      visit_scenario(archive, whole);
    } else if constexpr (std::is_same_v<Kind, mesh::TriangleMesh>) {
      archive(whole.positions, whole.triangles);
    } else if constexpr (std::is_same_v<Kind, HeightGrid>) {
      auto& [columns, rows, width, depth, heights] = whole;
      archive(columns, rows, width, depth, heights);
    } else if constexpr (kIsOneOf<Kind, SceneShape, ContactSurface>) {
      visit_shape(archive, whole);
    } else if constexpr (kIsOneOf<Kind, SceneJoint, SceneAxis>) {
      visit_joint(archive, whole);
    } else {
      visit_scene(archive, whole);
    }
  }

  template <class Archive, class T>
  static void visit_scenario(Archive& archive, T& whole) {
    using Kind = std::remove_const_t<T>;
    if constexpr (std::is_same_v<Kind, Phase>) {
      auto& [name, begin, end] = whole;
      archive(name, begin, end);
    } else if constexpr (std::is_same_v<Kind, Command>) {
      auto& [joint, axis, kind, value, begin, end, ramp, gains, control, effort] = whole;
      archive(joint, axis, kind, value, begin, end, ramp, gains, control, effort);
    } else if constexpr (std::is_same_v<Kind, Push>) {
      auto& [body, impulse_W, p_BP, at] = whole;
      archive(body, impulse_W, p_BP, at);
    } else if constexpr (std::is_same_v<Kind, Tilt>) {
      auto& [begin, end, angle, axis] = whole;
      archive(begin, end, angle, axis);
    } else if constexpr (std::is_same_v<Kind, Assertion>) {
      auto& [name, metric, quantity, at, least, most] = whole;
      archive(name, metric, quantity, at, least, most);
    } else if constexpr (std::is_same_v<Kind, SolverSettings>) {
      auto& [step, solver, iterations, sor, erp, cfm, max_correcting_velocity, surface_layer,
             max_contacts, stiffness, seed, engine, library] = whole;
      archive(step, solver, iterations, sor, erp, cfm, max_correcting_velocity, surface_layer,
              max_contacts, stiffness, seed, engine, library);
    } else {
      static_assert(std::is_same_v<Kind, Scenario>);
      auto& [name, duration, phases, commands, pushes, tilts, assertions, spawn, drop, base,
             gravity, ground, ground_mu, gravity_W, step, solver] = whole;
      archive(name, duration, phases, commands, pushes, tilts, assertions, spawn, drop, base,
              gravity, ground, ground_mu, gravity_W, step, solver);
    }
  }

  template <class Archive, class T>
  static void visit_shape(Archive& archive, T& whole) {
    if constexpr (std::is_same_v<std::remove_const_t<T>, ContactSurface>) {
      auto& [mu, mu2, fdir1, slip1, slip2, restitution, bounce_threshold, kp, kd, collide_bitmask,
             collide_without_contact, max_contacts] = whole;
      archive(mu, mu2, fdir1, slip1, slip2, restitution, bounce_threshold, kp, kd, collide_bitmask,
              collide_without_contact, max_contacts);
    } else {
      auto& [name, body, link, X_BS, kind, surface, extent, where] = whole;
      archive(name, body, link, X_BS, kind, surface, extent, where);
    }
  }

  template <class Archive, class T>
  static void visit_joint(Archive& archive, T& whole) {
    if constexpr (std::is_same_v<std::remove_const_t<T>, SceneAxis>) {
      auto& [direction_W, start, lower, upper, effort, velocity, damping, friction,
             spring_reference, spring_stiffness, stop_erp, stop_cfm, where, limit_where] = whole;
      archive(direction_W, start, lower, upper, effort, velocity, damping, friction,
              spring_reference, spring_stiffness, stop_erp, stop_cfm, where, limit_where);
    } else {
      auto& [name, type, parent, child, anchor_W, axes, screw_pitch, gearbox_ratio,
             gearbox_reference, mimics, model, where] = whole;
      archive(name, type, parent, child, anchor_W, axes, screw_pitch, gearbox_ratio,
              gearbox_reference, mimics, model, where);
    }
  }

  template <class Archive, class T>
  static void visit_scene(Archive& archive, T& whole) {
    using Kind = std::remove_const_t<T>;
    if constexpr (std::is_same_v<Kind, SceneBody>) {
      auto& [name, links, mass, X_WB, gravity, kinematic, self_collide, linear_damping,
             angular_damping, model, where] = whole;
      archive(name, links, mass, X_WB, gravity, kinematic, self_collide, linear_damping,
              angular_damping, model, where);
    } else if constexpr (std::is_same_v<Kind, SceneLink>) {
      auto& [name, body, X_BL, id, where, model] = whole;
      archive(name, body, X_BL, id, where, model);
    } else if constexpr (std::is_same_v<Kind, SceneModel>) {
      auto& [name, base, is_static, id, where, missing_shapes] = whole;
      archive(name, base, is_static, id, where, missing_shapes);
    } else {
      static_assert(std::is_same_v<Kind, Scene>);
      auto& [name, gravity, solver, alone, models, bodies, links, shapes, joints, meshes, size] =
          whole;
      archive(name, gravity, solver, alone, models, bodies, links, shapes, joints, meshes, size);
    }
  }
};

}  // namespace

std::string encode_run(const Scene& scene, const Scenario& scenario,
                       const SolverSettings& settings) {
  ArchiveWriter<RunRequestFields> writer;
  writer(scene, scenario, settings);
  return std::move(writer.bytes);
}

std::optional<RunRequest> decode_run(std::string_view bytes) {
  ArchiveReader<RunRequestFields> reader(bytes);
  RunRequest request;
  reader(request.scene, request.scenario, request.settings);
  if (!reader.done()) return std::nullopt;
  return request;
}

}  // namespace rigor::simulate
