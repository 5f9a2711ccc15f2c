// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <string>

#include <rigor/convert/mjcf/contact.h>
#include <rigor/convert/mjcf/draft.h>
#include <rigor/model/subject.h>
#include <rigor/read/values.h>

namespace rigor::convert {
namespace {

using model::Vector3;
using robot::Part;

/// How far the lines of a plane's grid are apart where it is drawn, m.
constexpr double kPlaneGrid = 1;

bool is_positive(const std::vector<double>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(),
                     [](double n) { return std::isfinite(n) && n > 0; });
}

/// The shortest rotation that brings z there.
model::Quaternion rotation_of_z(const Vector3& direction) {
  const double size = length(direction);
  if (!(size > 0)) return {};
  const Vector3 z{0, 0, 1}, n = 1 / size * direction;
  const Vector3 across = cross(z, n);
  if (length(across) == 0) return n.z > 0 ? model::Quaternion{} : model::Quaternion{0, 1, 0, 0};
  return model::normalized({1 + dot(z, n), across.x, across.y, across.z});
}

class MjcfGeomMaker {
 public:
  MjcfGeomMaker(MjcfDraft& draft, std::uint32_t body)
      : draft_(draft), index_(body), body_(draft.robot().bodies[body]) {}

  std::vector<MjcfElement> make() {
    for (const Part& part : body_.visuals) add_visual(part);
    for (const Part& part : body_.collisions) add_collision(part);
    return std::move(geoms_);
  }

 private:
  void add_visual(const Part& part) {
    const model::Visual* visual = draft_.entities.visual(part.span);
    if (visual == nullptr) return;
    subject_ = model::subject(draft_.root(), *visual);
    where_ = visual->geometry.site.span.nowhere() ? visual->site.name : visual->geometry.site.name;
    take(*visual);
    auto geom = shaped(part, "visual", NoteKind::kShapeLost);
    if (!geom) return;
    set_look(*geom, part, *visual);
    name(*geom, part.name, "visual", visual->name);
    geoms_.push_back(*std::move(geom));
  }

  void add_collision(const Part& part) {
    const model::Collision* collision = draft_.entities.collision(part.span);
    if (collision == nullptr) return;
    subject_ = model::subject(draft_.root(), *collision);
    where_ = collision->geometry.site.span.nowhere() ? collision->site.name
                                                     : collision->geometry.site.name;
    take(*collision);
    auto geom = shaped(part, "collision", NoteKind::kCollisionLost);
    if (!geom) return;
    set_contact(draft_, index_, *collision, *geom);
    name(*geom, part.name, "collision", collision->name);
    geoms_.push_back(*std::move(geom));
  }

  template <class T>
  void take(const T& written) {
    Ledger& ledger = draft_.ledger;
    ledger.take(written.site);
    ledger.take(written.name);
    ledger.take_all(written.pose.site);
    ledger.take_all(written.geometry.site);
  }

  /// A name that the author gave, in the scope of the body if another one has it. "collision" says no more than the
  /// class does.
  void name(MjcfElement& geom, const std::string& given, const std::string& kind,
            const model::Field<std::string>& written) {
    if (given.empty() || given == kind) return;
    auto& taken = draft_.names["geom"];
    const std::string scoped = body_.name + "_" + given;
    std::string chosen = taken.contains(given) ? scoped : given;
    chosen = draft_.name_for("geom", chosen);
    if (chosen != written.value) {
      draft_.ledger.take(written, Outcome::kRewritten);
      draft_.ledger.note({.kind = NoteKind::kRenamed,
                          .outcome = Outcome::kRewritten,
                          .where = written.span,
                          .subject = subject_,
                          .written = '"' + written.value + '"',
                          // The same words for all that are named so: one finding.
                          .instead = chosen == scoped ? "LINK_" + given : chosen});
    }
    geom.attributes.insert(geom.attributes.begin(), {"name", chosen});
  }

  std::optional<MjcfElement> lost(NoteKind kind, std::string_view shape) {
    draft_.ledger.note({.kind = kind,
                        .outcome = Outcome::kLost,
                        .where = where_,
                        .subject = subject_,
                        .written = std::string(shape)});
    return std::nullopt;
  }

  std::optional<MjcfElement> shaped(const Part& part, const std::string& use, NoteKind if_lost) {
    const robot::Shape& shape = part.shape;
    MjcfElement geom{"geom"};
    geom.set("class", use);
    const auto& n = shape.numbers;
    if (shape.kind == "none") return lost(NoteKind::kMjcfLost, use + " without a shape");
    const bool sized = shape.kind != "mesh" && shape.kind != "plane" && shape.kind != "polyline";
    // Nothing touches it in any engine.
    if (sized && (n.empty() || !is_positive(n))) {
      return lost(NoteKind::kShapeLost, shape.kind + " of no size");
    }
    if (shape.kind == "plane") return plane(part, std::move(geom), if_lost);
    if (shape.kind == "box") {
      geom.set("type", "box");
      geom.set("size", mjcf_numbers({n[0] / 2, n[1] / 2, n[2] / 2}));
    } else if (shape.kind == "sphere") {
      geom.set("type", "sphere");
      geom.set("size", mjcf_number(n[0]));
    } else if (shape.kind == "cylinder" || shape.kind == "capsule") {
      geom.set("type", shape.kind);
      geom.set("size", mjcf_numbers({n[0], n[1] / 2}));
    } else if (shape.kind == "ellipsoid") {
      geom.set("type", "ellipsoid");
      geom.set("size", mjcf_numbers({n[0], n[1], n[2]}));
    } else if (shape.kind == "mesh" || shape.kind == "cone" || shape.kind == "polyline") {
      const std::string mesh = mjcf_mesh(draft_, part, use, subject_, where_);
      if (mesh.empty()) return std::nullopt;
      geom.set("type", "mesh");
      geom.set("mesh", mesh);
    } else {
      return lost(if_lost, shape.kind);
    }
    set_placement(geom, part.X_BS);
    return geom;
  }

  /// MuJoCo has planes on what never moves.
  std::optional<MjcfElement> plane(const Part& part, MjcfElement geom, NoteKind if_lost) {
    if (!draft_.fixed[index_]) return lost(if_lost, "plane on a moving body");
    const auto& n = part.shape.numbers;
    geom.set("type", "plane");
    geom.set("size", mjcf_numbers({0, 0, kPlaneGrid}));
    const model::Pose X_SN{{}, rotation_of_z({n[0], n[1], n[2]})};
    set_placement(geom, compose(part.X_BS, X_SN));
    return geom;
  }

  // --- looks ---

  void set_look(MjcfElement& geom, const Part& part, const model::Visual& visual) {
    take_material(visual);
    if (!part.color) return;
    const robot::Color& c = *part.color;
    const std::string rgba = mjcf_numbers({c.r, c.g, c.b, c.a});
    const std::string& name = visual.material.name.value;
    if (name.empty()) return geom.set("rgba", rgba);
    std::string& known = draft_.material_names[name + '\n' + rgba];
    if (known.empty()) {
      known = draft_.name_for("material", name);
      draft_.asset.add({"material", {{"name", known}, {"rgba", rgba}}});
    }
    geom.set("material", known);
  }

  void take_material(const model::Visual& visual) {
    Ledger& ledger = draft_.ledger;
    const model::Material& material = visual.material;
    if (!material.written || material.site.span.nowhere()) return;
    ledger.take(material.site);
    if (!material.script.span.nowhere()) {
      ledger.lose(material.script, {.kind = NoteKind::kMjcfLook,
                                    .subject = subject_,
                                    .written = "material script " + material.name.value});
    }
    ledger.take(material.name);
    ledger.take(visual.transparency);
    const xml::Element element = draft_.source.source.documents.element(material.site);
    for (const std::string_view part : {"color", "ambient", "diffuse"}) {
      if (const auto child = element.child(part)) ledger.take_all(*child);
    }
  }

  MjcfDraft& draft_;
  std::uint32_t index_;
  const robot::Body& body_;
  std::vector<MjcfElement> geoms_;
  std::string subject_;
  Span where_;
};

}  // namespace

std::vector<MjcfElement> mjcf_geoms(MjcfDraft& draft, std::uint32_t body) {
  return MjcfGeomMaker(draft, body).make();
}

}  // namespace rigor::convert
