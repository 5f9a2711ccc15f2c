// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>

#include <rigor/convert/comments.h>
#include <rigor/convert/number_text.h>
#include <rigor/convert/sdf/draft.h>
#include <rigor/convert/written_number.h>
#include <rigor/model/subject.h>
#include <rigor/model/unique_names.h>
#include <rigor/read/values.h>
#include <rigor/schema/value.h>

namespace rigor::convert {
namespace {

using model::Id;
using model::Link;

/// URDF needs no names of shapes, SDF does, and no two alike in one link: nor a visual's and a collision's.
class ShapeNames {
 public:
  /// `fallback` is for what has none.
  std::string add(const std::string& name, const std::string& fallback) {
    return names_.add(sdf_name(name.empty() ? fallback : name));
  }

 private:
  model::UniqueNames names_{1};
};

struct ToUrdfGeometry {
  SdfDraft& draft;
  const std::string& subject;

  Number number(const model::Field<double>& field) const {
    draft.ledger.take(field);
    return written_number(draft.source.documents, field);
  }
  Number3 vector(const model::Field<model::Vector3>& field) const {
    draft.ledger.take(field);
    return written_numbers(draft.source.documents, field);
  }

  std::optional<UrdfGeometry> operator()(const model::Box& s) const {
    return UrdfBox{vector(s.size)};
  }
  std::optional<UrdfGeometry> operator()(const model::Sphere& s) const {
    return UrdfSphere{number(s.radius)};
  }
  std::optional<UrdfGeometry> operator()(const model::Cylinder& s) const {
    return UrdfCylinder{number(s.radius), number(s.length)};
  }
  std::optional<UrdfGeometry> operator()(const model::Capsule& s) const {
    return UrdfCapsule{number(s.radius), number(s.length)};
  }
  std::optional<UrdfGeometry> operator()(const model::Mesh& s) const {
    if (s.uri.value.empty()) return std::nullopt;
    UrdfMesh mesh{sdf_uri(draft, s.uri, subject), {}};
    if (s.scale.written) mesh.scale = vector(s.scale);
    return mesh;
  }
  template <class Other>
  std::optional<UrdfGeometry> operator()(const Other&) const {
    return std::nullopt;
  }
};

class SdfLinkConverter {
 public:
  SdfLinkConverter(SdfDraft& draft, Id<Link> holder)
      : draft_(draft), ledger_(draft.ledger), root_(draft.source.root), holder_(holder) {}

  /// The link with all that it holds.
  SdfLink convert() {
    link_.name = draft_.node(holder_).name;
    link_.inertial = sdf_inertial(draft_, holder_);
    if (!link_.inertial || link_.inertial->mass.value == 0) {
      const UrdfInertial nothing = next_to_nothing(draft_);
      if (!link_.inertial) link_.inertial = nothing;
      link_.inertial->mass = nothing.mass;
      note_massless(holder_, Outcome::kSubstituted,
                    "a link of " + to_text(link_.inertial->mass) + " kg");
    }
    for (const Id<Link> id : draft_.node(holder_).held) {
      take_head(id);
      // Those on a link that is a frame are the frame's.
      if (id == holder_) link_.comments = comments_on(root_[id].site);
      // Sensors name collisions: these keep their names.
      for (const auto collision : root_[id].collisions) add_collision(id, root_[collision]);
      for (const auto visual : root_[id].visuals) add_visual(id, root_[visual]);
    }
    return std::move(link_);
  }

 private:
  void note_massless(Id<Link> id, Outcome outcome, std::string instead) {
    const Link& link = root_[id];
    const Id<model::Joint> carrier = draft_.node(id).carrier;
    const bool moves = outcome == Outcome::kSubstituted && carrier &&
                       root_[carrier].type != model::JointType::kFixed;
    ledger_.take_all(link.inertial.site, outcome);
    ledger_.note({.kind = moves ? NoteKind::kMasslessMoving : NoteKind::kMassless,
                  .outcome = outcome,
                  .where = link.site.name,
                  .subject = model::subject(root_, link),
                  .written = link.name.value,
                  .instead = std::move(instead)});
  }

  Remarks comments_on(const model::Site& site) const {
    return remarks_on(draft_.source.documents, site, CommentsFor::kSdf);
  }

  /// What a link that is none becomes, with the joint that fixed it.
  std::string frames_of(Id<Link> id) const {
    const SdfNode& node = draft_.node(id);
    const std::string holder = " of link " + draft_.node(holder_).name;
    if (!node.carrier) return "a frame" + holder;
    return "frames " + draft_.tree.joint_names[node.carrier.value] + " (its joint) and " +
           node.name + holder;
  }

  void take_head(Id<Link> id) {
    const Link& link = root_[id];
    const bool frame = draft_.node(id).role == SdfNode::Role::kFrame;
    const Outcome outcome = frame ? Outcome::kRewritten : Outcome::kConverted;
    if (frame) {
      if (is_massless(link)) note_massless(id, outcome, frames_of(id));
    }
    ledger_.take(link.site, outcome);
    ledger_.take(link.name, outcome);
    const xml::Element element = draft_.source.documents.element(link.site);
    if (const auto type = element.attribute("type")) {
      ledger_.pass_over_value(type->value_span(), model::subject(root_, link), "type of a link");
    }
  }

  /// A part's name and pose; of a link that became a frame the pose is in that.
  template <class Part>
  SdfShape head_of(Id<Link> id, const Part& part, const char* kind) {
    ledger_.take(part.site);
    ledger_.take(part.name);
    ledger_.take_all(part.pose.site);
    SdfShape shape;
    shape.comments = comments_on(part.site);
    shape.name = names_.add(part.name.value, root_[id].name.value + '_' + kind);
    shape.pose.origin = urdf_written_origin(draft_.source.documents, part.pose);
    if (id != holder_) shape.pose.relative_to = draft_.node(id).name;
    return shape;
  }

  enum class Use : std::uint8_t { kVisual, kCollision };

  /// Whether there is one that SDF has.
  bool set_geometry(SdfShape& shape, const model::Geometry& geometry, const std::string& subject,
                    Use use) {
    if (!geometry.written) return lose_geometry(geometry, subject, use);
    const xml::Element element = draft_.source.documents.element(geometry.site);
    const auto around = element.name() == "geometry" ? element : element.parent();
    if (const auto name = around ? around->attribute("name") : std::nullopt) {
      ledger_.pass_over_value(name->value_span(), subject, "name of a geometry");
    }
    auto converted = std::visit(ToUrdfGeometry{draft_, subject}, geometry.shape);
    if (converted) {
      ledger_.take(geometry.site);
      shape.geometry = *std::move(converted);
      return true;
    }
    return lose_geometry(geometry, subject, use);
  }

  bool lose_geometry(const model::Geometry& geometry, const std::string& subject, Use use) {
    const bool touches = use == Use::kCollision;
    if (geometry.written) ledger_.take_all(geometry.site, Outcome::kLost);
    const bool nothing = std::holds_alternative<model::NoShape>(geometry.shape) ||
                         std::holds_alternative<model::Mesh>(geometry.shape);
    ledger_.note({.kind = touches && !nothing ? NoteKind::kCollisionLost : NoteKind::kShapeLost,
                  .outcome = Outcome::kLost,
                  .where = geometry.site.name,
                  .subject = subject,
                  .written = std::string(model::shape_name(geometry.shape))});
    return false;
  }

  void add_visual(Id<Link> id, const model::Visual& visual) {
    SdfShape shape = head_of(id, visual, "visual");
    const std::string whose = model::subject(root_, visual);
    if (!set_geometry(shape, visual.geometry, whose, Use::kVisual)) return;
    add_material(shape, visual.material, whose);
    link_.visuals.push_back(std::move(shape));
  }

  void add_collision(Id<Link> id, const model::Collision& collision) {
    SdfShape shape = head_of(id, collision, "collision");
    const xml::Element element = draft_.source.documents.element(collision.site);
    const std::string whose = model::subject(root_, collision);
    for (const char* idle : {"material", "verbose"}) {
      if (const auto child = element.child(idle)) {
        ledger_.pass_over(*child, whose, std::string(idle) + " of a collision");
      }
    }
    if (!set_geometry(shape, collision.geometry, whose, Use::kCollision)) return;
    link_.collisions.push_back(std::move(shape));
  }

  /// The first that uses a name tells that SDF has none; the shape that it represents is in each.
  void take_material_name(const model::Field<std::string>& name, const std::string& subject) {
    ledger_.take(name, Outcome::kRewritten);
    if (!name.written || !draft_.used_materials.insert(name.value).second) return;
    ledger_.note({.kind = NoteKind::kMaterialLook,
                  .outcome = Outcome::kRewritten,
                  .where = name.span,
                  .subject = subject,
                  .written = "name " + name.value,
                  .instead = "the shape that it represents"});
  }

  void add_material(SdfShape& shape, const model::Material& material, const std::string& subject) {
    if (!material.written) return;
    ledger_.take(material.site);
    take_material_name(material.name, subject);
    const auto defined = draft_.materials.find(material.name.value);
    const xml::Element own = draft_.source.documents.element(material.site);
    const xml::Element element = defined != draft_.materials.end() ? defined->second : own;
    if (!(element == own)) {
      for (const xml::Element child : own.children()) {
        ledger_.pass_over(child, subject,
                          std::string(child.name()) + " of a material that is defined before");
      }
    }
    const auto color = element.child("color");
    const auto rgba = color ? read::attribute_text(*color, "rgba") : std::nullopt;
    if (!rgba) return;
    const auto parsed =
        schema::parse_pose("0 0 0 " + std::string(rgba->text), schema::RotationFormat::kQuatXyzw);
    if (!std::holds_alternative<schema::PoseNumbers>(parsed)) return;
    ledger_.take_all(*color);
    const std::string text = color_digits(rgba->text, std::get<schema::PoseNumbers>(parsed));
    SdfElement look{.name = "material"};
    look.set("ambient", text);
    look.set("diffuse", text);
    shape.rest.push_back(std::move(look));
  }

  static std::string color_digits(std::string_view written, const schema::PoseNumbers& values) {
    std::array<Number, 4> color;
    for (std::size_t i = 0; i < color.size(); ++i) {
      const std::size_t begin = written.find_first_not_of(" \t\r\n");
      written.remove_prefix(begin);
      const std::string word(written.substr(0, written.find_first_of(" \t\r\n")));
      color[i] = {values.numbers[i + 3], word};
      written.remove_prefix(word.size());
    }
    return number_texts(color);
  }

  SdfDraft& draft_;
  Ledger& ledger_;
  const model::Root& root_;
  Id<Link> holder_;
  SdfLink link_;
  ShapeNames names_;
};

}  // namespace

UrdfOrigin urdf_written_origin(const read::Documents& documents, const model::PoseField& pose) {
  if (!pose.pose.written || pose.site.span.nowhere()) return {};
  const xml::Element origin = documents.element(pose.site);
  if (origin.attribute("quat_xyzw")) return origin_of(pose.pose.value);
  const auto vector = [&](std::string_view name) {
    return written_numbers(documents, read::vector_field(read::attribute_text(origin, name), {}));
  };
  return {vector("xyz"), vector("rpy")};
}

void add_sdf_links(SdfDraft& draft) {
  draft.links.resize(draft.tree.nodes.size());
  for (const Id<Link> id : draft.tree.order) {
    if (draft.node(id).role != SdfNode::Role::kLink) continue;
    draft.links[id.value] = SdfLinkConverter(draft, id).convert();
  }
}

}  // namespace rigor::convert
