// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf/shape.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include <rigor/convert/number_text.h>
#include <rigor/convert/urdf/shape_file.h>
#include <rigor/convert/urdf/uri.h>
#include <rigor/convert/written_number.h>
#include <rigor/read/documents.h>
#include <rigor/write/numbers.h>
#include <rigor/xml/document.h>

namespace rigor::convert {
namespace {

using model::Pose;
using model::Vector3;

/// m, of the box for a plane: thick enough that a step of a simulator does not pass it, and as wide as
/// models of a ground are.
constexpr double kPlaneThickness = 0.02;
constexpr double kPlaneSize = 100;

/// m: libsdformat draws a plane without a size so.
constexpr double kDrawnPlaneSize = 1;

bool is_side(double number) { return std::isfinite(number) && number > 0; }

/// Whether the shape is a visual's.
bool is_drawn(xml::Element shape) {
  const auto geometry = shape.parent();
  const auto part = geometry ? geometry->parent() : std::nullopt;
  return part && part->name() == "visual";
}

/// The shortest rotation that takes z to the unit vector.
model::Quaternion turn_z_to(const Vector3& up) {
  if (up.z <= -1 + 1e-12) return model::from_rpy(std::numbers::pi, 0, 0);
  const double w = std::sqrt((1 + up.z) / 2);
  return {w, -up.y / (2 * w), up.x / (2 * w), 0};
}

class ShapeConverter {
 public:
  ShapeConverter(UrdfDraft& draft, const model::Geometry& geometry, const std::string& subject)
      : draft_(draft), geometry_(geometry), subject_(subject) {}

  std::vector<UrdfShape> operator()(const model::NoShape& /*none*/) const { return {}; }

  std::vector<UrdfShape> operator()(const model::Box& box) const {
    return {{UrdfBox{take(box.size)}}};
  }
  std::vector<UrdfShape> operator()(const model::Sphere& sphere) const {
    return {{UrdfSphere{take(sphere.radius)}}};
  }
  std::vector<UrdfShape> operator()(const model::Cylinder& cylinder) const {
    return {{UrdfCylinder{take(cylinder.radius), take(cylinder.length)}}};
  }

  std::vector<UrdfShape> operator()(const model::Capsule& capsule) const {
    if (draft_.options.urdf_version >= 1) {
      return {{UrdfCapsule{take(capsule.radius), take(capsule.length)}}};
    }
    const Outcome outcome = Outcome::kSubstituted;
    const Number radius = take(capsule.radius, outcome);
    const Number length = take(capsule.length, outcome);
    tell(outcome, "cylinder and 2 spheres");
    const Vector3 end{0, 0, capsule.length.value / 2};
    return {{UrdfCylinder{radius, length}},
            {UrdfSphere{radius}, Pose{end, {}}, "_top"},
            {UrdfSphere{radius}, Pose{-1 * end, {}}, "_bottom"}};
  }

  std::vector<UrdfShape> operator()(const model::Mesh& mesh) const {
    if (!mesh.submesh.value.empty()) return from_file();
    if (mesh.uri.value.empty()) return {};
    UrdfMesh result{urdf_uri(draft_, mesh.uri, subject_), std::nullopt};
    if (mesh.scale.written && mesh.scale.value != Vector3{1, 1, 1}) {
      result.scale = written_numbers(draft_.source.documents, mesh.scale);
    }
    draft_.ledger.take(mesh.scale);
    return {{std::move(result)}};
  }

  std::vector<UrdfShape> operator()(const model::Ellipsoid& /*shape*/) const { return from_file(); }
  std::vector<UrdfShape> operator()(const model::Cone& /*shape*/) const { return from_file(); }
  std::vector<UrdfShape> operator()(const model::Polyline& /*shape*/) const {
    auto shapes = from_file();
    if (shapes.empty()) return shapes;
    // Its holes are further polylines beside it.
    for (const xml::Element child :
         draft_.source.documents.element(geometry_.site).parent()->children()) {
      if (child.name() == "polyline") draft_.ledger.take_all(child, Outcome::kSubstituted);
    }
    return shapes;
  }

  /// A thin box has an end, and lets through what is below it: only where it is asked for.
  std::vector<UrdfShape> operator()(const model::Plane& plane) const {
    const Vector3& normal = plane.normal.value;
    const double size = length(normal);
    if (draft_.options.planes != PlanePolicy::kBox || !(size > 0)) return {};
    draft_.ledger.take_all(geometry_.site, Outcome::kSubstituted);
    // What is drawn has a size; what collides has no end.
    double x = kPlaneSize, y = kPlaneSize;
    const xml::Element element = draft_.source.documents.element(geometry_.site);
    const auto written = element.child("size");
    const auto sides = written ? write::numbers_in(written->text()) : std::nullopt;
    const bool has_size =
        sides && sides->size() == 2 && is_side((*sides)[0]) && is_side((*sides)[1]);
    if (is_drawn(element)) {
      x = has_size ? (*sides)[0] : kDrawnPlaneSize;
      y = has_size ? (*sides)[1] : kDrawnPlaneSize;
    } else if (has_size) {
      x = std::max(x, (*sides)[0]);
      y = std::max(y, (*sides)[1]);
    }
    const Vector3 up = (1 / size) * normal;
    UrdfBox box{numbers({x, y, kPlaneThickness})};
    tell(Outcome::kSubstituted, "a box of " + number_texts(box.size) + " m");
    return {{std::move(box), Pose{(-kPlaneThickness / 2) * up, turn_z_to(up)}}};
  }
  std::vector<UrdfShape> operator()(const model::Heightmap& /*shape*/) const { return {}; }
  std::vector<UrdfShape> operator()(const model::Image& /*shape*/) const { return {}; }

 private:
  std::vector<UrdfShape> from_file() const {
    if (draft_.options.shapes != ShapePolicy::kMesh) return {};
    const auto name = shape_file(draft_, geometry_);
    if (!name) return {};
    UrdfMesh result{*name, std::nullopt};
    if (const auto* mesh = std::get_if<model::Mesh>(&geometry_.shape)) {
      if (mesh->scale.value != Vector3{1, 1, 1}) {
        result.scale = written_numbers(draft_.source.documents, mesh->scale);
      }
    }
    draft_.ledger.take_all(geometry_.site, Outcome::kSubstituted);
    tell(Outcome::kSubstituted, *name);
    return {{std::move(result)}};
  }

  void tell(Outcome outcome, std::string instead) const {
    draft_.ledger.note({.kind = NoteKind::kShape,
                        .outcome = outcome,
                        .where = geometry_.site.name,
                        .subject = subject_,
                        .written = std::string(shape_name(geometry_.shape)),
                        .instead = std::move(instead)});
  }

  Number take(const model::Field<double>& field, Outcome outcome = Outcome::kConverted) const {
    draft_.ledger.take(field, outcome);
    return written_number(draft_.source.documents, field);
  }
  Number3 take(const model::Field<Vector3>& field) const {
    draft_.ledger.take(field);
    return written_numbers(draft_.source.documents, field);
  }

  UrdfDraft& draft_;
  const model::Geometry& geometry_;
  const std::string& subject_;
};

}  // namespace

std::vector<UrdfShape> urdf_shapes(UrdfDraft& draft, const model::Geometry& geometry,
                                   const std::string& subject) {
  auto shapes = std::visit(ShapeConverter(draft, geometry, subject), geometry.shape);
  if (!shapes.empty()) draft.ledger.take(geometry.site);
  return shapes;
}

}  // namespace rigor::convert
