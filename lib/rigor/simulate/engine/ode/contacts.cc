// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How the surfaces of two shapes make a contact, after Gazebo 11 (physics/ode/ODEPhysics.cc): as
// contact_rules.h has it, with the direction of the smaller mu.

#include <algorithm>
#include <cmath>
#include <utility>

#include <rigor/simulate/engine/ode/world.h>

namespace rigor::simulate {
namespace {

/// fdir1 nearer than this to the normal gives no direction to slide along: the engine chooses.
constexpr double kMinAcross = 1e-3;

}  // namespace

EngineContacts::EngineContacts(const Scene& scene, const SolverSettings& settings,
                               const OdeWorld& ode)
    : ode_(ode), settings_(settings), rules_(scene) {
  for (const SceneShape& shape : scene.shapes) {
    Shape known{.body = shape.body, .surface = &shape.surface};
    if (shape.link < scene.links.size()) known.R_BL = scene.links[shape.link].X_BL.rotation;
    shapes_.push_back(known);
  }
}

Vector3 EngineContacts::first_direction(const Shape& a, const Shape& b) const {
  const auto written = [](const Shape& s) { return dot(s.surface->fdir1, s.surface->fdir1) > 0; };
  const Shape* chosen = written(a) ? &a : nullptr;
  if (written(b) && (chosen == nullptr || a.surface->mu > b.surface->mu)) chosen = &b;
  if (chosen == nullptr) return {};
  return in_world(ode_.body(chosen->body), model::rotate(chosen->R_BL, chosen->surface->fdir1));
}

dContact EngineContacts::surface_of(const Shape& a, const Shape& b) const {
  const ContactSurface both = combined(*a.surface, *b.surface);
  dContact contact{};
  dSurfaceParameters& s = contact.surface;
  s.mode = dContactApprox1 | dContactMu2;
  s.mu = both.mu;
  s.mu2 = both.mu2;
  s.slip1 = both.slip1;
  s.slip2 = both.slip2;
  if (s.slip1 > 0) s.mode |= dContactSlip1;
  if (s.slip2 > 0) s.mode |= dContactSlip2;
  s.bounce = both.restitution;
  s.bounce_vel = both.bounce_threshold;
  if (s.bounce > 0) s.mode |= dContactBounce;
  if (settings_.stiffness) {
    const double h = settings_.step;
    const double give = h * both.kp + both.kd;
    if (give > 0) {
      s.mode |= dContactSoftERP | dContactSoftCFM;
      s.soft_erp = h * both.kp / give;
      s.soft_cfm = 1 / give;
    }
  }
  return contact;
}

/// Brings those to the front that hold best: the deepest, then each time the one farthest from those
/// that are there. (Gazebo keeps the deepest and the first that were found.)
int EngineContacts::choose(int found, int wanted) {
  if (found <= wanted) return found;
  const auto begin = found_.begin();
  const auto end = begin + found;
  const auto shallower = [](const dContactGeom& a, const dContactGeom& b) {
    return a.depth < b.depth;
  };
  std::iter_swap(begin, std::max_element(begin, end, shallower));
  std::array<double, kFound> distance{};
  distance.fill(kInfinity);
  for (int kept = 1; kept < wanted; ++kept) {
    const Vector3 last = vector_of(found_[static_cast<std::size_t>(kept - 1)].pos);
    int farthest = kept;
    for (int i = kept; i < found; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const Vector3 d = vector_of(found_[at].pos) - last;
      distance[at] = std::min(distance[at], dot(d, d));
      if (distance[at] > distance[static_cast<std::size_t>(farthest)]) farthest = i;
    }
    const auto to = static_cast<std::size_t>(kept);
    const auto from = static_cast<std::size_t>(farthest);
    std::swap(found_[to], found_[from]);
    std::swap(distance[to], distance[from]);
  }
  return wanted;
}

void EngineContacts::near(void* self, dGeomID a, dGeomID b) {
  static_cast<EngineContacts*>(self)->touch(a, b);
}

void EngineContacts::touch(dGeomID a, dGeomID b) {
  const auto index = [](dGeomID geom) {
    return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(dGeomGetData(geom)));
  };
  const std::uint32_t shape_a = index(a);
  const std::uint32_t shape_b = index(b);
  const Shape& one = shapes_[shape_a];
  const Shape& two = shapes_[shape_b];
  if (!rules_.may_touch(shape_a, shape_b)) return;
  const int wanted = std::min(
      {settings_.max_contacts, one.surface->max_contacts, two.surface->max_contacts, kFound});
  if (wanted <= 0) return;
  const int found = dCollide(a, b, kFound, found_.data(), sizeof(dContactGeom));
  if (found == 0) return;
  const int kept = choose(found, wanted);
  dContact contact = surface_of(one, two);
  const Vector3 along = first_direction(one, two);
  const bool directed = dot(along, along) > 0;
  const dBodyID body_a = ode_.body(one.body);
  const dBodyID body_b = ode_.body(two.body);
  for (int i = 0; i < kept; ++i) {
    contact.geom = found_[static_cast<std::size_t>(i)];
    const Vector3 normal = vector_of(contact.geom.normal);
    contacts_->push_back({.shape_a = shape_a,
                          .shape_b = shape_b,
                          .point = vector_of(contact.geom.pos),
                          .normal = normal,
                          .depth = contact.geom.depth,
                          .force = {}});
    if (join_ == Join::kNo) continue;
    if (directed) {
      const Vector3 across = along - dot(along, normal) * normal;
      const double size = model::length(across);
      contact.surface.mode &= ~dContactFDir1;
      if (size > kMinAcross * model::length(along)) {
        contact.surface.mode |= dContactFDir1;
        contact.fdir1[0] = across.x / size;
        contact.fdir1[1] = across.y / size;
        contact.fdir1[2] = across.z / size;
      }
    }
    const dJointID joint = dJointCreateContact(ode_.world(), ode_.contacts(), &contact);
    dJointAttach(joint, body_a, body_b);
    joints_.push_back(joint);
  }
}

void EngineContacts::find(Join join, Forces forces, std::vector<ContactState>& contacts) {
  join_ = join;
  contacts_ = &contacts;
  contacts.clear();
  joints_.clear();
  dSpaceCollide(ode_.space(), this, &EngineContacts::near);
  if (forces == Forces::kNone) return;
  feedback_.resize(joints_.size());
  for (std::size_t i = 0; i < joints_.size(); ++i) dJointSetFeedback(joints_[i], &feedback_[i]);
}

void EngineContacts::read_forces(std::vector<ContactState>& contacts) const {
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    // f1 is on the joint's first body, which is b's when a's is the world.
    const bool on_a = shapes_[contacts[i].shape_a].body != kWorld;
    contacts[i].force = (on_a ? 1.0 : -1.0) * vector_of(feedback_[i].f1);
  }
}

}  // namespace rigor::simulate
