// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/spatial/predicate.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>

namespace rigor::mesh {
namespace {

// Half the gap between 1 and the next double: the most that one rounding does, and Shewchuk's epsilon.
constexpr double kRounding = std::numeric_limits<double>::epsilon() / 2;

// Shewchuk 1997, figures 20 and 21: the most that roundings do to either determinant, as a share of
// what its terms add up to without their signs.
constexpr double kTurnBound = (3 + 16 * kRounding) * kRounding;
constexpr double kSideBound = (7 + 56 * kRounding) * kRounding;

int sign(double x) { return (x > 0) - (x < 0); }

struct Sum {
  double rounded;
  double rest;  ///< exactly what rounding took away
};

/// D. Knuth's two-sum.
Sum sum(double a, double b) {
  const double rounded = a + b;
  const double b_part = rounded - a;
  return {rounded, (a - (rounded - b_part)) + (b - b_part)};
}

/// T. Dekker's product, with each factor split into halves of 26 bits.
Sum exact_product(double a, double b) {
  constexpr double kSplitter = 0x1p27 + 1;
  const auto upper = [](double x) { return kSplitter * x - (kSplitter * x - x); };
  const double a_high = upper(a);
  const double b_high = upper(b);
  const double a_low = a - a_high;
  const double b_low = b - b_high;
  const double rounded = a * b;
  const double rest = a_high * b_high - rounded + a_high * b_low + a_low * b_high + a_low * b_low;
  return {rounded, rest};
}

/// A sum of doubles, kept as terms of which no two have digits of the same place, in rising size: the
/// last one has the sign of all (Shewchuk's expansions, grown term by term; his theorem 10).
template <std::size_t kCapacity>
class Exact {
 public:
  void add(double b) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const Sum s = sum(b, terms_[i]);
      b = s.rounded;
      if (s.rest != 0) terms_[kept++] = s.rest;
    }
    if (b != 0) terms_[kept++] = b;
    size_ = kept;
  }

  void add_product(double a, double b) {
    if (a == 0 || b == 0) return;
    const Sum p = exact_product(a, b);
    add(p.rest);
    add(p.rounded);
  }

  const double* begin() const { return terms_.data(); }
  const double* end() const { return terms_.data() + size_; }
  int sign() const { return size_ == 0 ? 0 : mesh::sign(terms_[size_ - 1]); }

 private:
  std::array<double, kCapacity> terms_;
  std::size_t size_ = 0;
};

/// a - b, in two terms of which the second is the greater.
using Difference = std::array<double, 2>;
using DifferenceRow = std::array<Difference, 3>;

Difference difference(double a, double b) {
  const Sum s = sum(a, -b);
  return {s.rest, s.rounded};
}

DifferenceRow difference(const Vector3& a, const Vector3& b) {
  return {difference(a.x, b.x), difference(a.y, b.y), difference(a.z, b.z)};
}

/// ad - bc
Exact<16> minor(const Difference& a, const Difference& b, const Difference& c,
                const Difference& d) {
  Exact<16> result;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      result.add_product(a[i], d[j]);
      result.add_product(-b[i], c[j]);
    }
  }
  return result;
}

int sign_of_determinant(const DifferenceRow& u, const DifferenceRow& v, const DifferenceRow& w) {
  Exact<192> det;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const std::size_t last = (k + 2) % 3;
    for (const double term : minor(u[next], u[last], v[next], v[last])) {
      det.add_product(term, w[k][0]);
      det.add_product(term, w[k][1]);
    }
  }
  return det.sign();
}

__extension__ using Wide = __int128;
using Whole = std::array<Wide, 3>;

/// The most that numbers may have for their determinant to fit into 128 bits: six products of three.
constexpr int kWholeBits = 41;

/// The same, as multiples of 2^-exponent, when each is one and has no second term.
std::optional<Whole> as_whole(const DifferenceRow& row, int exponent) {
  Whole result;
  for (std::size_t k = 0; k < 3; ++k) {
    const double scaled = std::ldexp(row[k][1], exponent);
    const auto number = static_cast<std::int64_t>(scaled);
    if (row[k][0] != 0 || static_cast<double>(number) != scaled) return std::nullopt;
    result[k] = number;
  }
  return result;
}

/// Quick, and nearly always enough for places of a file that holds floats.
std::optional<int> sign_in_integers(const DifferenceRow& u, const DifferenceRow& v,
                                    const DifferenceRow& w) {
  double most = 0;
  for (const DifferenceRow* row : {&u, &v, &w}) {
    for (const Difference& d : *row) most = std::max(most, std::abs(d[1]));
  }
  const int exponent = kWholeBits - 1 - std::ilogb(most);
  const std::optional<Whole> a = as_whole(u, exponent);
  const std::optional<Whole> b = as_whole(v, exponent);
  const std::optional<Whole> c = as_whole(w, exponent);
  if (!a || !b || !c) return std::nullopt;
  Wide det = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const std::size_t last = (k + 2) % 3;
    det += ((*a)[next] * (*b)[last] - (*a)[last] * (*b)[next]) * (*c)[k];
  }
  return (det > 0) - (det < 0);
}

int exact_side(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& p) {
  const DifferenceRow u = difference(b, a);
  const DifferenceRow v = difference(c, a);
  const DifferenceRow w = difference(p, a);
  const std::optional<int> quick = sign_in_integers(u, v, w);
  return quick ? *quick : sign_of_determinant(u, v, w);
}

int exact_turn(const Flat& a, const Flat& b, const Flat& c) {
  return minor(difference(b[0], a[0]), difference(b[1], a[1]), difference(c[0], a[0]),
               difference(c[1], a[1]))
      .sign();
}

/// Whether a line along a side of `a`, which is convex and counter-clockwise, has all of it on one side
/// and all of `b` strictly on the other. Two corners are a segment, seen as two sides.
bool parted_by_edge(std::span<const Flat> a, std::span<const Flat> b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Flat& next = a[(i + 1) % a.size()];
    bool beyond = true;
    for (const Flat& p : b) beyond = beyond && turn(a[i], next, p) < 0;
    if (beyond) return true;
  }
  return false;
}

/// For what lies in the plane of f. Convex figures are apart when a side of either parts them.
template <std::size_t kCorners>
bool meet_in_plane(const std::array<Vector3, kCorners>& g, const Facet& f) {
  const int axis = axis_of_view(f);
  const auto seen = [axis](const auto& corners, auto flat) {
    for (std::size_t i = 0; i < flat.size(); ++i) flat[i] = seen_along(axis, corners[i]);
    if (flat.size() == 3 && turn(flat[0], flat[1], flat[2]) < 0) std::swap(flat[0], flat[1]);
    return flat;
  };
  const auto a = seen(f, std::array<Flat, 3>{});
  const auto b = seen(g, std::array<Flat, kCorners>{});
  return !parted_by_edge(a, b) && !parted_by_edge(b, a);
}

/// For a segment with ends on the sides `s0` and `s1` of the plane of f.
bool meet_between(const Segment& s, int s0, int s1, const Facet& f) {
  if (s0 * s1 > 0) return false;
  if (s0 == 0 && s1 == 0) return meet_in_plane(s, f);
  bool left = false;
  bool right = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const int passes = side(s[0], s[1], f[i], f[(i + 1) % 3]);
    left = left || passes > 0;
    right = right || passes < 0;
    if (left && right) return false;
  }
  return true;
}

using Sides = std::array<int, 3>;

Sides sides(const Facet& f, const Facet& g) {
  return {side(f, g[0]), side(f, g[1]), side(f, g[2])};
}

bool all_on_one_side(const Sides& s) { return s[0] != 0 && s[0] == s[1] && s[1] == s[2]; }

bool an_edge_meets(const Facet& g, const Sides& s, const Facet& f) {
  return meet_between({g[0], g[1]}, s[0], s[1], f) || meet_between({g[1], g[2]}, s[1], s[2], f) ||
         meet_between({g[2], g[0]}, s[2], s[0], f);
}

}  // namespace

int side(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& p) {
  const Vector3 u{b.x - a.x, b.y - a.y, b.z - a.z};
  const Vector3 v{c.x - a.x, c.y - a.y, c.z - a.z};
  const Vector3 w{p.x - a.x, p.y - a.y, p.z - a.z};
  const double yz = u.y * v.z;
  const double zy = u.z * v.y;
  const double zx = u.z * v.x;
  const double xz = u.x * v.z;
  const double xy = u.x * v.y;
  const double yx = u.y * v.x;
  const double det = (yz - zy) * w.x + (zx - xz) * w.y + (xy - yx) * w.z;
  const double terms = (std::abs(yz) + std::abs(zy)) * std::abs(w.x) +
                       (std::abs(zx) + std::abs(xz)) * std::abs(w.y) +
                       (std::abs(xy) + std::abs(yx)) * std::abs(w.z);
  if (std::abs(det) > kSideBound * terms) return sign(det);
  return terms == 0 ? 0 : exact_side(a, b, c, p);
}

int turn(const Flat& a, const Flat& b, const Flat& c) {
  const double left = (b[0] - a[0]) * (c[1] - a[1]);
  const double right = (b[1] - a[1]) * (c[0] - a[0]);
  const double det = left - right;
  const double terms = std::abs(left) + std::abs(right);
  if (std::abs(det) > kTurnBound * terms) return sign(det);
  return terms == 0 ? 0 : exact_turn(a, b, c);
}

int axis_of_view(const Facet& f) {
  int axis = 0;
  while (axis < 3 &&
         turn(seen_along(axis, f[0]), seen_along(axis, f[1]), seen_along(axis, f[2])) == 0) {
    ++axis;
  }
  return axis;
}

bool meet(const Segment& s, const Facet& f) {
  return meet_between(s, side(f, s[0]), side(f, s[1]), f);
}

bool meet(const Facet& f, const Facet& g) {
  const Sides g_to_f = sides(f, g);
  if (all_on_one_side(g_to_f)) return false;
  if (g_to_f == Sides{}) return meet_in_plane(g, f);
  const Sides f_to_g = sides(g, f);
  if (all_on_one_side(f_to_g)) return false;
  return an_edge_meets(g, g_to_f, f) || an_edge_meets(f, f_to_g, g);
}

}  // namespace rigor::mesh
