// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/convert/mjcf/contact.h>
#include <rigor/convert/mjcf/draft.h>
#include <rigor/convert/mjcf/look.h>
#include <rigor/model/subject.h>
#include <rigor/read/mjcf/mjcf_settings.h>
#include <rigor/read/values.h>
#include <rigor/text/path.h>

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
    look_ = look_of(*visual, part.color);
    auto geoms = shaped(part, visual, NoteKind::kShapeLost);
    take_material(*visual);
    for (MjcfElement& geom : geoms) set_look(geom, part, *visual);
    add(std::move(geoms), part.name, "visual", visual->name);
  }

  void add_collision(const Part& part) {
    const model::Collision* collision = draft_.entities.collision(part.span);
    if (collision == nullptr) return;
    subject_ = model::subject(draft_.root(), *collision);
    where_ = collision->geometry.site.span.nowhere() ? collision->site.name
                                                     : collision->geometry.site.name;
    take(*collision);
    auto geoms = shaped(part, nullptr, NoteKind::kCollisionLost);
    for (MjcfElement& geom : geoms) set_contact(draft_, index_, *collision, geom);
    add(std::move(geoms), part.name, "collision", collision->name);
  }

  /// The first has the name.
  void add(std::vector<MjcfElement> geoms, const std::string& given, const std::string& kind,
           const model::Field<std::string>& written) {
    if (!geoms.empty()) name(geoms[0], given, kind, written);
    std::move(geoms.begin(), geoms.end(), std::back_inserter(geoms_));
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

  std::vector<MjcfElement> lost(NoteKind kind, std::string_view shape) {
    draft_.ledger.note({.kind = kind,
                        .outcome = Outcome::kLost,
                        .where = where_,
                        .subject = subject_,
                        .written = std::string(shape)});
    return {};
  }

  /// One, but for a mesh of several looks. `visual` is null for a collision.
  std::vector<MjcfElement> shaped(const Part& part, const model::Visual* visual, NoteKind if_lost) {
    const robot::Shape& shape = part.shape;
    const std::string use = visual != nullptr ? "visual" : "collision";
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
      return of_meshes(mjcf_meshes(draft_, part, visual, subject_, where_), geom, part.X_BS);
    } else {
      return lost(if_lost, shape.kind);
    }
    set_placement(geom, part.X_BS);
    return {std::move(geom)};
  }

  std::vector<MjcfElement> of_meshes(const std::vector<MjcfMesh>& meshes, MjcfElement geom,
                                     const model::Pose& X_BS) {
    geom.set("type", "mesh");
    std::vector<MjcfElement> geoms;
    for (const MjcfMesh& mesh : meshes) {
      MjcfElement& each = geoms.emplace_back(geom);
      each.set("mesh", mesh.name);
      set_placement(each, X_BS);
      if (mesh.look) set_mjcf_look(draft_, each, mesh.material, *mesh.look);
    }
    return geoms;
  }

  /// MuJoCo has planes on what never moves.
  std::vector<MjcfElement> plane(const Part& part, MjcfElement geom, NoteKind if_lost) {
    if (!draft_.fixed[index_]) return lost(if_lost, "plane on a moving body");
    const auto& n = part.shape.numbers;
    geom.set("type", "plane");
    geom.set("size", mjcf_numbers({0, 0, kPlaneGrid}));
    const model::Pose X_SN{{}, rotation_of_z({n[0], n[1], n[2]})};
    set_placement(geom, compose(part.X_BS, X_SN));
    return {std::move(geom)};
  }

  // --- looks ---

  void set_look(MjcfElement& geom, const Part& part, const model::Visual& visual) {
    const auto has = [&geom](std::string_view name) {
      return std::any_of(geom.attributes.begin(), geom.attributes.end(),
                         [name](const auto& each) { return each.first == name; });
    };
    if (has("rgba") || has("material")) return;
    const std::string& name = visual.material.name.value;
    if (look_) return set_mjcf_look(draft_, geom, name, *look_);
    if (part.color) set_mjcf_look(draft_, geom, name, {*part.color});
  }

  /// What the model says of a shape's look, where `Lookups` say nothing of it: a picture, a script.
  std::optional<robot::Look> look_of(const model::Visual& visual,
                                     const std::optional<robot::Color>& color) const {
    if (!visual.material.written) return std::nullopt;
    const auto looks = draft_.looks_of(visual, mesh::TriangleMesh());
    if (looks.empty() || (color && looks[0].picture.empty())) return std::nullopt;
    return looks[0];
  }

  void take_material(const model::Visual& visual) {
    Ledger& ledger = draft_.ledger;
    const model::Material& material = visual.material;
    if (!material.written || material.site.span.nowhere()) return;
    ledger.take(material.site);
    if (!material.script.span.nowhere()) take_script(visual);
    ledger.take(material.name);
    ledger.take(visual.transparency);
    const xml::Element element = draft_.source.source.documents.element(material.site);
    for (const std::string_view part : {"color", "ambient", "diffuse"}) {
      if (const auto child = element.child(part)) ledger.take_all(*child);
    }
    tell_blend(visual, element);
    if (!look_ || look_->picture.empty()) return;
    if (const auto texture = element.child("texture")) take_picture(*texture);
    for (const model::RobotMaterial& named : draft_.root().materials) {
      if (named.name.value != material.name.value || material.name.value.empty()) continue;
      const auto texture = draft_.source.source.documents.element(named.site).child("texture");
      if (texture) take_picture(*texture);
    }
    const auto pbr = element.child("pbr");
    if (!pbr) return;
    ledger.take(*pbr);
    for (const xml::Element workflow : pbr->children()) {
      const auto map = workflow.child("albedo_map");
      if (!map) continue;
      ledger.take(workflow);
      take_picture(*map);
    }
  }

  /// MuJoCo has one color where SDF has one for each kind of light.
  void tell_blend(const model::Visual& visual, xml::Element material) {
    const auto numbers = [&material](std::string_view name) {
      const auto text = read::child_text(material, name);
      return text ? read::mjcf_numbers(text->text).value_or(std::vector<double>())
                  : std::vector<double>();
    };
    const std::vector<double> ambient = numbers("ambient"), diffuse = numbers("diffuse");
    if (ambient.size() < 3 || diffuse.size() < 3) return;
    if (std::equal(ambient.begin(), ambient.begin() + 3, diffuse.begin())) return;
    draft_.ledger.note({.kind = NoteKind::kMjcfLook,
                        .outcome = Outcome::kSubstituted,
                        .where = visual.material.site.name,
                        .subject = subject_,
                        .written = "ambient and diffuse of different colors",
                        .instead = "the color that both have in Gazebo's light"});
  }

  void take_script(const model::Visual& visual) {
    const model::Material& material = visual.material;
    Note note{.kind = NoteKind::kMjcfLook,
              .where = material.script.name,
              .subject = subject_,
              .written = "material script " + material.name.value};
    if (!look_) return draft_.ledger.lose(material.script, std::move(note));
    draft_.ledger.take_all(material.script, Outcome::kSubstituted);
    note.outcome = Outcome::kSubstituted;
    note.instead = look_->picture.empty() ? "its color" : "its color and texture";
    draft_.ledger.note(std::move(note));
  }

  /// The element is told once, however many visuals it is for.
  void take_picture(xml::Element element) {
    if (!draft_.told_pictures.insert({element.span().source, element.span().begin}).second) return;
    draft_.ledger.take_all(element, Outcome::kRewritten);
    draft_.ledger.note({.kind = NoteKind::kMjcfLook,
                        .outcome = Outcome::kRewritten,
                        .where = element.name_span(),
                        .subject = subject_,
                        .written = "texture " + std::string(file_name(look_->picture)),
                        .instead = "a PNG in assets/"});
  }

  MjcfDraft& draft_;
  std::uint32_t index_;
  const robot::Body& body_;
  std::vector<MjcfElement> geoms_;
  std::string subject_;
  Span where_;
  std::optional<robot::Look> look_;  ///< of the visual at hand
};

}  // namespace

std::vector<MjcfElement> mjcf_geoms(MjcfDraft& draft, std::uint32_t body) {
  return MjcfGeomMaker(draft, body).make();
}

}  // namespace rigor::convert
