// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/rest_inertia.h>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace rigor::robot {
namespace {

using model::Pose;
using model::Vector3;

/// Bounds the work: a file of a line can bring very deep trees.
constexpr std::size_t kMaxProducts = 500'000'000;

/// Of a rigid body, by what goes through the origin of the model: angular and linear.
struct Motion {
  Vector3 turn;   // rad/s
  Vector3 shift;  // m/s, of the point at the origin
};

Vector3 product(const mass::Inertia& i, const Vector3& v) {
  return {i.ixx * v.x + i.ixy * v.y + i.ixz * v.z, i.ixy * v.x + i.iyy * v.y + i.iyz * v.z,
          i.ixz * v.x + i.iyz * v.y + i.izz * v.z};
}

/// The power of the momentum that a body has in one motion, in another: the entry of the mass matrix.
double entry(const Moments& body, const Motion& a, const Motion& b) {
  const Vector3 angular = product(body.second, a.turn) + cross(body.first, a.shift);
  const Vector3 linear = body.mass * a.shift + cross(a.turn, body.first);
  return dot(b.turn, angular) + dot(b.shift, linear);
}

Motion motion_of(const Axis& axis, const Pose& X_MA) {
  const Vector3 n = rotate(X_MA.rotation, axis.direction);
  if (axis.motion == Axis::Motion::kSlide) return {{}, n};
  const Vector3 shift = cross(X_MA.translation, n);
  return {n, axis.motion == Axis::Motion::kScrew ? shift + axis.slide * n : shift};
}

/// One degree of freedom. `row` is that of the mass matrix: of the freedoms that carry this one, from the root
/// on, and of itself. `factor` makes of it that of L, with D at its end, of M = Lᵀ D L.
struct Freedom {
  std::uint32_t parent = kNoIndex;  ///< the freedom next to it on the way to the root
  std::uint32_t body = kNoIndex;    ///< that it moves, with all that it carries
  Motion motion;
  double armature = 0;
  double* result = nullptr;  ///< none of a root's
  std::vector<double> row;
};

class RestInertia {
 public:
  RestInertia(const Robot& robot, const std::vector<double>& armature)
      : robot_(robot), armature_(armature) {
    for (const Joint& joint : robot.joints) result_.emplace_back(joint.axes.size());
  }

  AxisValues run() {
    const std::vector<Pose> X_MB = body_poses(robot_, {});
    add_freedoms(X_MB);
    if (is_too_much()) return std::move(result_);
    fill(X_MB);
    for (std::size_t i = freedoms_.size(); i-- > 0;) factor(freedoms_[i]);
    for (const Freedom& freedom : freedoms_) {
      if (freedom.result != nullptr) *freedom.result = inverse(freedom);
    }
    return std::move(result_);
  }

 private:
  void add(std::uint32_t body, const Motion& motion, double armature, double* result) {
    const std::uint32_t parent = last_[body];
    const std::size_t carriers = parent == kNoIndex ? 0 : freedoms_[parent].row.size();
    last_[body] = static_cast<std::uint32_t>(freedoms_.size());
    freedoms_.push_back(
        {parent, body, motion, armature, result, std::vector<double>(carriers + 1)});
  }

  void add_freedoms(const std::vector<Pose>& X_MB) {
    last_.assign(robot_.bodies.size(), kNoIndex);
    for (const std::uint32_t b : robot_.order) {
      const Body& body = robot_.bodies[b];
      if (body.carrier == kNoIndex) {
        if (body.name == kWorldBody) continue;
        for (const Vector3& n : {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}) {
          add(b, {n, {}}, 0, nullptr);
          add(b, {{}, n}, 0, nullptr);
        }
        continue;
      }
      const Joint& joint = robot_.joints[body.carrier];
      last_[b] = last_[joint.parent];
      for (std::size_t k = 0; k < joint.axes.size(); ++k) {
        add(b, motion_of(joint.axes[k], X_MB[b]), armature_[body.carrier],
            &result_[body.carrier][k]);
      }
    }
  }

  bool is_too_much() const {
    std::size_t products = 0;
    for (const Freedom& freedom : freedoms_) products += freedom.row.size() * freedom.row.size();
    return products > kMaxProducts;
  }

  void fill(const std::vector<Pose>& X_MB) {
    std::vector<Moments> carried(robot_.bodies.size());
    for (auto b = robot_.order.rbegin(); b != robot_.order.rend(); ++b) {
      const mass::MassProperties body = mass::transformed(X_MB[*b], robot_.bodies[*b].mass);
      const auto add = [&carried](std::uint32_t to, const Moments& more) {
        Moments& sum = carried[to];
        sum = {sum.mass + more.mass, sum.first + more.first, sum.second + more.second};
      };
      add(*b, {body.mass, body.mass * body.com, mass::about_origin(body)});
      const std::uint32_t carrier = robot_.bodies[*b].carrier;
      if (carrier != kNoIndex) add(robot_.joints[carrier].parent, carried[*b]);
    }
    for (Freedom& one : freedoms_) {
      one.row.back() = entry(carried[one.body], one.motion, one.motion) + one.armature;
      std::size_t k = one.row.size() - 1;
      for (std::uint32_t i = one.parent; i != kNoIndex; i = freedoms_[i].parent) {
        one.row[--k] = entry(carried[one.body], one.motion, freedoms_[i].motion);
      }
    }
  }

  /// Featherstone's LᵀDL, one step: takes the freedom out of the rows of those that carry it.
  void factor(Freedom& one) {
    const double own = one.row.back();
    std::size_t k = one.row.size() - 1;
    for (std::uint32_t i = one.parent; i != kNoIndex; i = freedoms_[i].parent) {
      const double share = own > 0 ? one.row[--k] / own : 0;
      std::vector<double>& row = freedoms_[i].row;
      for (std::size_t j = 0; j < row.size(); ++j) row[j] -= share * one.row[j];
    }
    for (std::size_t j = 0; j + 1 < one.row.size(); ++j)
      one.row[j] = own > 0 ? one.row[j] / own : 0;
  }

  /// eᵀ M⁻¹ e, e being one at the freedom: Σ x²/D with Lᵀ x = e, where those that do not carry it are zero.
  double inverse(const Freedom& one) const {
    std::vector<double> x(one.row.size());
    x.back() = 1;
    double sum = 0;
    const Freedom* at = &one;
    for (std::size_t k = x.size(); k-- > 0;) {
      if (!(at->row[k] > 0)) return 0;
      sum += x[k] * x[k] / at->row[k];
      for (std::size_t j = 0; j < k; ++j) x[j] -= x[k] * at->row[j];
      if (k > 0) at = &freedoms_[at->parent];
    }
    return sum;
  }

  const Robot& robot_;
  const std::vector<double>& armature_;
  std::vector<Freedom> freedoms_;    // each after those that carry it
  std::vector<std::uint32_t> last_;  // by body: the freedom next to it on the way to the root
  AxisValues result_;
};

}  // namespace

AxisValues inverse_inertias(const Robot& robot, const std::vector<double>& armature) {
  return RestInertia(robot, armature).run();
}

}  // namespace rigor::robot
