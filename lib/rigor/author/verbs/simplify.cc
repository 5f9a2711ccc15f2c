// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/simplify.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include <rigor/author/mesh_uri.h>
#include <rigor/author/verbs/block.h>
#include <rigor/author/verbs/draft.h>
#include <rigor/mass/mesh/reads.h>
#include <rigor/mesh/select.h>
#include <rigor/mesh/substitute/substitute.h>
#include <rigor/mesh/write/write.h>
#include <rigor/robot/collision/self_collisions.h>
#include <rigor/robot/collision/surfaces.h>
#include <rigor/text/path.h>
#include <rigor/write/numbers.h>
#include <rigor/write/safe_name.h>
#include <rigor/xml/edit.h>
#include <rigor/xml/style.h>

namespace rigor::author {
namespace {

using mesh::Substitute;
using mesh::SubstituteKind;
using model::Id;
using model::Pose;
using model::Vector3;

constexpr int kFirstWithCapsules = 8;

using PartId = std::variant<Id<model::Collision>, Id<model::Visual>>;

/// A mesh to be replaced: a collision's, or a visual's of a link without one.
struct Simplification {
  std::uint32_t body = 0;
  std::size_t index = 0;  ///< among the body's collisions, or visuals
  PartId part;
  const model::PoseField* pose = nullptr;
  const model::Geometry* geometry = nullptr;
  model::Site site;
  std::string name;  ///< "collision arm/hull"
  SubstituteKind first = SubstituteKind::kPrimitive;
  std::shared_ptr<const Substitute> found;
  std::vector<std::string> uris;  ///< of the new meshes
  std::string why;                ///< it is left as it is
  double link_size = 0;           ///< m
  std::size_t triangles = 0;      ///< before

  const model::Mesh& mesh() const { return std::get<model::Mesh>(geometry->shape); }
  bool is_new() const { return std::holds_alternative<Id<model::Visual>>(part); }
};

/// Coordinates times the factors; what is mirrored is wound the other way round.
mesh::TriangleMesh stretched(const mesh::TriangleMesh& from, const Vector3& by) {
  mesh::TriangleMesh result;
  result.positions = from.positions;
  result.triangles = from.triangles;
  for (Vector3& p : result.positions) p = {by.x * p.x, by.y * p.y, by.z * p.z};
  if (by.x * by.y * by.z < 0) {
    for (mesh::Triangle& t : result.triangles) std::swap(t[1], t[2]);
  }
  return result;
}

robot::Shape shape_of(const mesh::Primitive& primitive) {
  struct Numbers {
    robot::Shape operator()(const mesh::Box& s) const {
      return {"box", {s.size.x, s.size.y, s.size.z}};
    }
    robot::Shape operator()(const mesh::Sphere& s) const { return {"sphere", {s.radius}}; }
    robot::Shape operator()(const mesh::Cylinder& s) const {
      return {"cylinder", {s.radius, s.length}};
    }
    robot::Shape operator()(const mesh::Capsule& s) const {
      return {"capsule", {s.radius, s.length}};
    }
  };
  return std::visit(Numbers{}, primitive);
}

/// With six digits: what a fit is good for, and what can be read.
double readable(double value) {
  return write::number_in(fmt::format("{:.6g}", value)).value_or(value);
}

/// With sizes of so many digits.
mesh::Primitive rounded(mesh::Primitive primitive) {
  struct Rounder {
    void operator()(mesh::Box& s) const {
      s.size = {readable(s.size.x), readable(s.size.y), readable(s.size.z)};
    }
    void operator()(mesh::Sphere& s) const { s.radius = readable(s.radius); }
    void operator()(mesh::Cylinder& s) const {
      s.radius = readable(s.radius);
      s.length = readable(s.length);
    }
    void operator()(mesh::Capsule& s) const {
      s.radius = readable(s.radius);
      s.length = readable(s.length);
    }
  };
  std::visit(Rounder{}, primitive);
  return primitive;
}

class Simplifier {
 public:
  Simplifier(const EditedModel& edited, const SimplifyRequest& request)
      : edited_(edited),
        root_(edited.root()),
        request_(request),
        reads_(edited.environment.disk, edited.environment.workers),
        draft_(edited) {}

  Change simplify() {
    find_parts();
    if (parts_.empty()) return refusal("no link collides as a mesh that is its own");
    for (Simplification& part : parts_) find_shape(part);
    avoid_contacts();
    Change change;
    for (Simplification& part : parts_) {
      notes_.push_back(note(part));
      if (part.found) rewrite(part);
    }
    if (std::none_of(parts_.begin(), parts_.end(), [](const auto& p) { return p.found; })) {
      return refusal(fmt::format("none of {} collisions gets a simpler shape: {}", parts_.size(),
                                 note(parts_.front())));
    }
    say_masses();
    change.steps = draft_.take();
    change.expected = law();
    change.notes = std::move(notes_);
    change.new_files = std::move(files_);
    if (!draft_.problem().empty()) return refusal(draft_.problem());
    change.asks_for_setting = [](const robot::Difference& difference) {
      return difference.a.empty();
    };
    return change;
  }

 private:
  // --- What there is ---

  void find_parts() {
    for (std::uint32_t i = 0; i < edited_.robot.bodies.size(); ++i) {
      const robot::Body& body = edited_.robot.bodies[i];
      const Id<model::Link> id = edited_.link(body.name);
      if (!id || !root_.own(root_[id].site)) continue;
      const model::Link& link = root_[id];
      const std::size_t first = parts_.size();
      for (std::size_t k = 0; k < link.collisions.size(); ++k) add(i, k, link.collisions[k]);
      if (link.collisions.empty() && request_.missing == MissingCollisions::kFromVisuals) {
        for (std::size_t k = 0; k < link.visuals.size(); ++k) add(i, k, link.visuals[k]);
      }
      measure_link(first);
      if (!link.inertial.automatic.value) continue;
      for (std::size_t k = first; k < parts_.size(); ++k)
        parts_[k].why = "the link's inertial is computed from its collisions";
    }
  }

  template <class T>
  void add(std::uint32_t body, std::size_t index, Id<T> id) {
    const T& part = root_[id];
    if (!root_.own(part.site) || !std::holds_alternative<model::Mesh>(part.geometry.shape)) return;
    Simplification each;
    each.body = body;
    each.index = index;
    each.part = id;
    each.pose = &part.pose;
    each.geometry = &part.geometry;
    each.site = part.site;
    const std::string name = part.name.value.empty() ? std::to_string(index + 1) : part.name.value;
    each.name = fmt::format("{} {}/{}", each.is_new() ? "visual" : "collision",
                            edited_.robot.bodies[body].name, name);
    parts_.push_back(std::move(each));
  }

  const robot::Shape& shape(const Simplification& part) const {
    const robot::Body& body = edited_.robot.bodies[part.body];
    return (part.is_new() ? body.visuals : body.collisions)[part.index].shape;
  }

  /// In the link's axes, meshes whole: what the error is a share of.
  void measure_link(std::size_t first) {
    std::vector<Vector3> corners;
    for (std::size_t k = first; k < parts_.size(); ++k) {
      Simplification& part = parts_[k];
      part.why = unreadable(part);
      if (!part.why.empty()) continue;
      const mesh::TriangleMesh& read = reads_.find(shape(part).path)->mesh;
      part.triangles = read.triangles.size();
      const Vector3 s = part.mesh().scale.value;
      for (const Vector3& p : mesh::used_positions(read))
        corners.push_back(transform(part.pose->pose.value, {s.x * p.x, s.y * p.y, s.z * p.z}));
    }
    const double size = corners.empty() ? 0 : mesh::diagonal(mesh::bounds_of(corners));
    for (std::size_t k = first; k < parts_.size(); ++k) parts_[k].link_size = size;
  }

  std::string unreadable(const Simplification& part) {
    const robot::Shape& of = shape(part);
    if (of.path.empty()) return of.uri + " is not found";
    if (!of.submesh.empty()) return "it is a part of a mesh";
    if (!part.geometry->more.empty()) return "it has several shapes";
    const Vector3 s = part.mesh().scale.value;
    if (!(std::abs(s.x * s.y * s.z) > 0) || !std::isfinite(s.x * s.y * s.z))
      return "its scale is zero";
    const auto loaded = reads_.find(of.path);
    if (!loaded->usable() || loaded->mesh.triangles.empty()) return of.uri + " cannot be read";
    return {};
  }

  // --- What becomes of it ---

  void find_shape(Simplification& part) {
    part.found = nullptr;
    if (!part.why.empty()) return;
    const robot::Shape& of = shape(part);
    const double bound = request_.max_error * part.link_size;
    const bool capsules = !edited_.is_urdf() && root_[edited_.model].version >= kFirstWithCapsules;
    std::shared_ptr<const Substitute>& known =
        known_[{of.path, of.numbers, bound, static_cast<int>(part.first)}];
    if (!known) {
      const auto found = mesh::find_substitute(
          stretched(reads_.find(of.path)->mesh, part.mesh().scale.value),
          {.max_error = bound,
           .capsules = capsules ? mesh::Capsules::kAllowed : mesh::Capsules::kRefused,
           .first = part.first});
      known = std::make_shared<Substitute>(found.value_or(Substitute{}));
    }
    if (!known->primitive && known->meshes.empty()) {
      part.why = fmt::format("no simpler shape is within {:.3g} m of it", bound);
      return;
    }
    part.found = known;
    if (!name_files(part)) part.found = nullptr;
  }

  static std::string_view suffix(SubstituteKind kind) {
    switch (kind) {
      case SubstituteKind::kHull: return "hull";
      case SubstituteKind::kPieces: return "piece";
      default: return "reduced";
    }
  }

  /// Whether URIs of the collision's form lead to the new meshes.
  bool name_files(Simplification& part) {
    part.uris.clear();
    const robot::Shape& of = shape(part);
    const Vector3& s = part.mesh().scale.value;
    const std::string folder(parent_path(of.path));
    const std::string_view old = file_name(of.path);
    const std::string stem(old.substr(0, old.rfind('.')));
    for (std::size_t i = 0; i < part.found->meshes.size(); ++i) {
      const std::string ending =
          part.found->meshes.size() == 1 ? std::string() : '_' + std::to_string(i + 1);
      const mesh::TriangleMesh in_file =
          stretched(part.found->meshes[i], {1 / s.x, 1 / s.y, 1 / s.z});
      const std::string bytes = mesh::write_stl(in_file);
      const std::string path =
          free_path(folder, fmt::format("{}_{}{}", stem, suffix(part.found->kind), ending), bytes);
      auto uri = renamed_uri(edited_.environment.resolver, part.mesh().uri.value, edited_.path(),
                             of.path, path);
      if (!uri) {
        part.why = "no URI of the form of " + part.mesh().uri.value + " leads to " + path;
        return false;
      }
      surfaces_[*uri] = std::make_shared<mesh::TriangleMesh>(in_file);
      bytes_[*uri] = {path, bytes};
      part.uris.push_back(*std::move(uri));
    }
    return true;
  }

  /// A name of no file, or of one with these bytes.
  std::string free_path(const std::string& folder, const std::string& name,
                        const std::string& bytes) {
    for (int i = 1;; ++i) {
      const std::string numbered = i == 1 ? name : fmt::format("{}_{}", name, i);
      std::string path = join_path(folder, write::safe_name(numbered) + ".stl");
      const auto [taken, is_new] = taken_.try_emplace(path, bytes);
      if (!is_new) {
        if (taken->second == bytes) return path;
        continue;
      }
      const Disk& disk = edited_.environment.disk;
      if (disk.kind(path) == PathKind::kMissing ||
          disk.read(path, bytes.size() + 1).bytes == bytes)  // an earlier run
        return path;
      taken->second.clear();
    }
  }

  // --- Self-collisions ---

  robot::FindSurface surfaces() {
    return [this, read = robot::surface_finder(reads_)](const robot::Shape& of) {
      const auto own = surfaces_.find(of.uri);
      if (own != surfaces_.end()) return robot::FoundSurface{own->second, {}};
      return read(of);
    };
  }

  void avoid_contacts() {
    if (const std::string problem = mesh::collider_problem(); !problem.empty()) {
      notes_.push_back("self-collisions at rest are not checked: " + problem);
      return;
    }
    const robot::Robot& before = edited_.robot;
    const robot::CollisionBodies old_bodies(before, surfaces());
    const robot::CollisionPoses old_poses =
        old_bodies.placed(body_poses(before, robot::rest_positions(before)));
    std::vector<bool> has_shape(before.bodies.size());
    for (std::uint32_t i = 0; i < has_shape.size(); ++i) {
      has_shape[i] = old_bodies.has_shape(i) ||
                     std::any_of(parts_.begin(), parts_.end(),
                                 [i](const auto& part) { return part.body == i && part.is_new(); });
    }
    std::set<std::pair<std::uint32_t, std::uint32_t>> adjacent;
    for (const robot::LinkPair& pair : adjacent_pairs(before, has_shape))
      adjacent.insert({pair.a, pair.b});
    const std::size_t all = before.bodies.size();
    for (bool again = true; again;) {
      again = false;
      const robot::Robot after = law();
      const robot::CollisionBodies bodies(after, surfaces());
      const robot::CollisionPoses poses =
          bodies.placed(body_poses(after, robot::rest_positions(after)));
      pairs_ = 0;
      for (std::uint32_t a = 0; a < all; ++a) {
        for (std::uint32_t b = a + 1; b < all; ++b) {
          if (!has_shape[a] || !has_shape[b] || adjacent.contains({a, b})) continue;
          ++pairs_;
          if (!bodies.collide(a, b, poses) || old_bodies.collide(a, b, old_poses)) continue;
          again = step_back(a, b) || again;
        }
      }
    }
    if (pairs_ == 0) return;
    notes_.push_back(fmt::format(
        "no new self-collision at rest in {} pairs of links that no joint connects", pairs_));
  }

  /// The next shape of the list, for what the two links have.
  bool step_back(std::uint32_t a, std::uint32_t b) {
    bool changed = false;
    for (Simplification& part : parts_) {
      if ((part.body != a && part.body != b) || !part.found) continue;
      changed = true;
      if (part.found->kind == SubstituteKind::kReduced) {
        part.found = nullptr;
        part.why = fmt::format("links {} and {} would touch at rest", edited_.robot.bodies[a].name,
                               edited_.robot.bodies[b].name);
        continue;
      }
      part.first = static_cast<SubstituteKind>(static_cast<int>(part.found->kind) + 1);
      find_shape(part);
    }
    return changed;
  }

  // --- The file ---

  std::string primitive_text(const mesh::Fit& fit) const {
    const robot::Shape of = shape_of(rounded(fit.shape));
    const auto number = [&](std::size_t i) { return write::joined({of.numbers[i]}); };
    const bool urdf = edited_.is_urdf();
    if (of.kind == "box") {
      const std::string size = write::joined(of.numbers);
      return urdf ? "<box size=\"" + size + "\"/>" : "<box>\n  <size>" + size + "</size>\n</box>";
    }
    std::string text = urdf ? '<' + of.kind : '<' + of.kind + ">\n";
    const auto add = [&](const char* name, std::size_t i) {
      text += urdf ? fmt::format(" {}=\"{}\"", name, number(i))
                   : fmt::format("  <{0}>{1}</{0}>\n", name, number(i));
    };
    add("radius", 0);
    if (of.numbers.size() > 1) add("length", 1);
    return text + (urdf ? "/>" : "</" + of.kind + '>');
  }

  std::string mesh_text(const std::string& uri, const Vector3& scale) const {
    const std::string factors = write::joined({scale.x, scale.y, scale.z});
    const bool scaled = scale != Vector3{1, 1, 1};
    if (edited_.is_urdf()) {
      return "<mesh filename=\"" + xml::escaped(uri) + '"' +
             (scaled ? " scale=\"" + factors + '"' : "") + "/>";
    }
    return "<mesh>\n  <uri>" + xml::escaped(uri) + "</uri>\n" +
           (scaled ? "  <scale>" + factors + "</scale>\n" : "") + "</mesh>";
  }

  void rewrite(Simplification& part) {
    for (const std::string& uri : part.uris) {
      const NewFile& file = bytes_.at(uri);
      if (std::none_of(files_.begin(), files_.end(),
                       [&](const NewFile& each) { return each.path == file.path; }))
        files_.push_back(file);
    }
    if (part.is_new()) return add_collisions(part);
    const xml::Document& document = edited_.document();
    const xml::Element element = edited_.element(part.site);
    if (part.found->primitive) {
      const mesh::Fit& fit = *part.found->primitive;
      draft_.add(xml::replace_element(document, edited_.element(part.geometry->site),
                                      primitive_text(fit)));
      draft_.set_pose(*part.pose, element, compose(part.pose->pose.value, fit.pose));
      return;
    }
    draft_.add({{part.mesh().uri.span, xml::escaped(part.uris.front())}});
    std::string copies;
    for (std::size_t i = 1; i < part.uris.size(); ++i) {
      std::vector<Edit> edits{{part.mesh().uri.span, xml::escaped(part.uris[i])}};
      if (const auto name = element.attribute("name"))
        edits.push_back({name->value_span(), xml::escaped(piece_name(part, i))});
      copies += std::string(xml::line_end(document, 0)) + xml::indentation(document, element) +
                part_after(document, element.span().begin, element.span().end, std::move(edits));
    }
    const Span span = element.span();
    if (!copies.empty()) draft_.add({{{span.source, span.end, span.end}, copies}});
  }

  std::string piece_name(const Simplification& part, std::size_t i) const {
    const robot::Body& body = edited_.robot.bodies[part.body];
    const std::string& name = (part.is_new() ? body.visuals : body.collisions)[part.index].name;
    if (name.empty() && !part.is_new()) return {};
    std::string base = name.empty() ? "collision" : name;
    if (i > 0) base += "_piece_" + std::to_string(i + 1);
    const auto taken = [&](const std::string& wanted) {
      return std::any_of(body.collisions.begin(), body.collisions.end(),
                         [&](const robot::Part& each) { return each.name == wanted; });
    };
    std::string result = base;
    if (i == 0 && !part.is_new()) return result;
    for (int n = 2; taken(result); ++n) result = fmt::format("{}_{}", base, n);
    return result;
  }

  void add_collisions(const Simplification& part) {
    const xml::Element link = *edited_.element(part.site).parent();
    const bool urdf = edited_.is_urdf();
    Pose X = part.pose->pose.value;
    if (part.found->primitive) X = compose(X, part.found->primitive->pose);
    std::string pose;
    const std::string& frame = part.pose->relative_to.value;
    if (urdf && !(X == Pose{})) {
      pose = fmt::format("  <origin xyz=\"{}\" rpy=\"{}\"/>\n", xyz_text(X), rpy_text(X));
    } else if (!urdf && (!(X == Pose{}) || !frame.empty())) {
      const std::string attribute =
          frame.empty() ? std::string()
                        : fmt::format(" {}=\"{}\"",
                                      root_[edited_.model].version >= 7 ? "relative_to" : "frame",
                                      xml::escaped(frame));
      pose = fmt::format("  <pose{}>{} {}</pose>\n", attribute, xyz_text(X), rpy_text(X));
    }
    const std::size_t count = std::max<std::size_t>(part.uris.size(), 1);
    for (std::size_t i = 0; i < count; ++i) {
      const std::string text = part.found->primitive
                                   ? primitive_text(*part.found->primitive)
                                   : mesh_text(part.uris[i], part.mesh().scale.value);
      std::string indented;
      for (const char c : text) indented += c == '\n' ? std::string("\n    ") : std::string(1, c);
      const std::string name = piece_name(part, i);
      draft_.insert(link, edited_.element(part.site),
                    fmt::format("<collision name=\"{}\">\n{}  <geometry>\n    {}\n  "
                                "</geometry>\n</collision>",
                                xml::escaped(name), pose, indented));
    }
  }

  // --- What is told ---

  static std::string what(const Substitute& found) {
    if (found.primitive) return shape_of(found.primitive->shape).kind;
    switch (found.kind) {
      case SubstituteKind::kHull: return "convex hull";
      case SubstituteKind::kPieces: return fmt::format("{} convex pieces", found.meshes.size());
      default: return "reduced mesh";
    }
  }

  std::string note(const Simplification& part) const {
    if (!part.found) return fmt::format("{}: left: {}", part.name, part.why);
    const Substitute& found = *part.found;
    const std::string triangles =
        found.primitive ? fmt::format("{} triangles", part.triangles)
                        : fmt::format("{} of {} triangles", found.triangles, part.triangles);
    return fmt::format("{}: {} for {}: {:.3g} m off ({:.2g} % of the link), volume {:+.2g} %{}",
                       part.name, what(found), triangles, found.hausdorff,
                       100 * found.hausdorff / part.link_size, 100 * found.volume_error,
                       found.of_hull ? " of its hull's, as it is open" : "");
  }

  void say_masses() {
    std::set<std::uint32_t> said;
    for (const Simplification& part : parts_) {
      const Id<model::Link> link = edited_.link(edited_.robot.bodies[part.body].name);
      if (!part.found || root_[link].inertial.written || !said.insert(part.body).second) continue;
      notes_.push_back(fmt::format("link {} has no inertial, as before: {}",
                                   edited_.robot.bodies[part.body].name,
                                   edited_.is_urdf() ? "it has no mass" : "it weighs 1 kg"));
    }
  }

  // --- The law ---

  robot::Robot law() const {
    robot::Robot after = edited_.robot;
    // From behind, so that indices stay right where pieces are added.
    for (auto part = parts_.rbegin(); part != parts_.rend(); ++part) {
      if (!part->found) continue;
      robot::Body& body = after.bodies[part->body];
      std::vector<robot::Part>& list = body.collisions;
      const robot::Part old = (part->is_new() ? body.visuals : list)[part->index];
      std::vector<robot::Part> now;
      for (std::size_t i = 0; i < std::max<std::size_t>(part->uris.size(), 1); ++i) {
        robot::Part each = old;
        each.color.reset();
        each.name = piece_name(*part, i);
        if (part->found->primitive) {
          each.shape = shape_of(rounded(part->found->primitive->shape));
          each.X_BS = compose(old.X_BS, part->found->primitive->pose);
        } else {
          each.shape.uri = part->uris[i];
          each.shape.path.clear();
        }
        now.push_back(std::move(each));
      }
      const auto at = static_cast<std::ptrdiff_t>(part->is_new() ? 0 : part->index);
      if (!part->is_new()) list.erase(list.begin() + at);
      list.insert(list.begin() + at, now.begin(), now.end());
    }
    return after;
  }

  const EditedModel& edited_;
  const model::Root& root_;
  const SimplifyRequest& request_;
  mass::MeshReads reads_;
  Draft draft_;
  std::vector<Simplification> parts_;
  std::map<std::tuple<std::string, std::vector<double>, double, int>,
           std::shared_ptr<const Substitute>>
      known_;
  std::map<std::string, std::shared_ptr<const mesh::TriangleMesh>> surfaces_;  // by URI
  std::map<std::string, NewFile> bytes_;                                       // by URI
  std::map<std::string, std::string> taken_;  // bytes by path; empty ones are others'
  std::vector<NewFile> files_;
  std::vector<std::string> notes_;
  std::size_t pairs_ = 0;
};

}  // namespace

Change simplified(const EditedModel& edited, const SimplifyRequest& request) {
  return Simplifier(edited, request).simplify();
}

}  // namespace rigor::author
