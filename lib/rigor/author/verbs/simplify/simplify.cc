// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/simplify/simplify.h>

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

#include <rigor/author/verbs/block.h>
#include <rigor/author/verbs/draft.h>
#include <rigor/author/verbs/simplify/mesh_files.h>
#include <rigor/author/verbs/simplify/primitive_element.h>
#include <rigor/author/verbs/simplify/rest_contacts.h>
#include <rigor/author/verbs/simplify/simplification.h>
#include <rigor/mass/mesh/reads.h>
#include <rigor/mesh/collide/collider.h>
#include <rigor/mesh/select.h>
#include <rigor/mesh/substitute/substitute.h>
#include <rigor/robot/collision/surfaces.h>
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

/// A mesh with fewer triangles is one that somebody simplified before: there is little to gain.
constexpr std::size_t kCoarse = 100;

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

class Simplifier {
 public:
  Simplifier(const EditedModel& edited, const SimplifyRequest& request)
      : edited_(edited),
        root_(edited.root()),
        request_(request),
        reads_(edited.environment.disk, edited.environment.workers),
        meshes_(edited),
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
      return refusal(none_simpler());
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
      const Vector3 s = part.old_mesh().scale.value;
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
    const Vector3 s = part.old_mesh().scale.value;
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
          stretched(reads_.find(of.path)->mesh, part.old_mesh().scale.value),
          {.max_error = bound,
           .capsules = capsules ? mesh::Capsules::kAllowed : mesh::Capsules::kRefused,
           .first = part.first});
      known = std::make_shared<Substitute>(found.value_or(Substitute{}));
    }
    if (!known->primitive && known->meshes.empty()) {
      part.why = fmt::format(
          "{}no simpler shape is within {:.3g} m of it",
          part.triangles < kCoarse
              ? fmt::format("it is coarse already, with {} triangles, and ", part.triangles)
              : std::string(),
          bound);
      return;
    }
    part.found = known;
    if (!name_files(part)) part.found = nullptr;
  }

  /// Whether URIs of the collision's form lead to the new meshes.
  bool name_files(Simplification& part) {
    part.uris.clear();
    const Vector3& s = part.old_mesh().scale.value;
    const std::string_view kind = file_suffix(part.found->kind);
    const std::size_t count = part.found->meshes.size();
    for (std::size_t i = 0; i < count; ++i) {
      auto uri = meshes_.add({shape(part).path, part.old_mesh().uri.value},
                             count == 1 ? std::string(kind) : fmt::format("{}_{}", kind, i + 1),
                             stretched(part.found->meshes[i], {1 / s.x, 1 / s.y, 1 / s.z}));
      if (!uri) {
        part.why = "no URI of the form of " + part.old_mesh().uri.value + " leads to its folder";
        return false;
      }
      part.uris.push_back(*std::move(uri));
    }
    return true;
  }

  // --- Self-collisions ---

  robot::FindSurface surfaces() {
    return [this, read = robot::surface_finder(reads_)](const robot::Shape& of) {
      if (auto own = meshes_.surface(of.uri)) return robot::FoundSurface{std::move(own), {}};
      return read(of);
    };
  }

  void avoid_contacts() {
    if (const std::string problem = mesh::collider_problem(); !problem.empty()) {
      notes_.push_back("self-collisions at rest are not checked: " + problem);
      return;
    }
    std::vector<bool> gets_shape(edited_.robot.bodies.size());
    for (const Simplification& part : parts_) {
      if (part.is_new()) gets_shape[part.body] = true;
    }
    const RestContacts contacts(edited_.robot, surfaces(), std::move(gets_shape));
    for (bool again = true; again;) {
      again = false;
      for (const auto& [a, b] : contacts.added(law(), surfaces())) again = step_back(a, b) || again;
    }
    if (contacts.checked() == 0) return;
    notes_.push_back(
        fmt::format("no new self-collision at rest in {} pairs of links that no joint connects",
                    contacts.checked()));
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

  GeometryForm form() const { return edited_.is_urdf() ? GeometryForm::kUrdf : GeometryForm::kSdf; }

  void rewrite(Simplification& part) {
    for (const std::string& uri : part.uris) {
      const NewFile& file = meshes_.of(uri);
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
                                      primitive_element(readable_primitive(fit.shape), form())));
      draft_.set_pose(*part.pose, element, compose(part.pose->pose.value, fit.pose));
      return;
    }
    draft_.add({{part.old_mesh().uri.span, xml::escaped(part.uris.front())}});
    std::string copies;
    for (std::size_t i = 1; i < part.uris.size(); ++i) {
      std::vector<Edit> edits{{part.old_mesh().uri.span, xml::escaped(part.uris[i])}};
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
      const std::string text =
          part.found->primitive
              ? primitive_element(readable_primitive(part.found->primitive->shape), form())
              : mesh_element(part.uris[i], part.old_mesh().scale.value, form());
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

  /// Each with its reason, up to some.
  std::string none_simpler() const {
    constexpr std::size_t kMaxNamed = 8;
    std::string text = fmt::format("none of {} collisions gets a simpler shape: ", parts_.size());
    for (std::size_t i = 0; i < std::min(parts_.size(), kMaxNamed); ++i)
      text += (i == 0 ? "" : "; ") + note(parts_[i]);
    if (parts_.size() > kMaxNamed) text += fmt::format("; and {} more", parts_.size() - kMaxNamed);
    return text;
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
          each.shape = primitive_shape(readable_primitive(part->found->primitive->shape));
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
  MeshFiles meshes_;
  Draft draft_;
  std::vector<Simplification> parts_;
  std::map<std::tuple<std::string, std::vector<double>, double, int>,
           std::shared_ptr<const Substitute>>
      known_;
  std::vector<NewFile> files_;
  std::vector<std::string> notes_;
};

}  // namespace

Change simplified(const EditedModel& edited, const SimplifyRequest& request) {
  return Simplifier(edited, request).simplify();
}

}  // namespace rigor::author
