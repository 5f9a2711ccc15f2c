// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/apply_mesh.h>

#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include <rigor/author/mesh_uri.h>
#include <rigor/model/subject.h>
#include <rigor/read/values.h>
#include <rigor/rules/package/uris.h>
#include <rigor/text/path.h>
#include <rigor/write/numbers.h>
#include <rigor/write/write_pose.h>
#include <rigor/xml/edit.h>

namespace rigor::author {
namespace {

using model::Vector3;
using xml::Element;
using Edits = std::vector<Edit>;

bool turns(const MeshReplacement& by) { return by.transform.up == mesh::UpAxis::kY; }

/// s' = P (s/D); y and z change places, since the turn is one about x.
Vector3 new_scale(const Vector3& old, const MeshReplacement& by) {
  const auto divided = [&by](double s, double factor) {
    const double result = s / (by.transform.unit * factor);
    return write::settled(result, s, std::abs(result));
  };
  const Vector3& factors = by.transform.scale;
  const Vector3 s{divided(old.x, factors.x), divided(old.y, factors.y), divided(old.z, factors.z)};
  return turns(by) ? Vector3{s.x, s.z, s.y} : s;
}

/// X' = X P⁻¹ · translation(-s' t)
write::PoseChange pose_change(const Vector3& scale, const MeshReplacement& by) {
  const Vector3& t = by.translation;
  return {turns(by) ? write::Turn::kBackAboutX : write::Turn::kNone,
          {-scale.x * t.x, -scale.y * t.y, -scale.z * t.z}};
}

bool finite(const Vector3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool keeps_parts(const std::string& path) {
  const std::string format = extension(path);
  return format != ".stl" && format != ".ply";
}

/// Behind what a new `<scale>` goes, as in the schema.
std::optional<Element> before_scale(Element mesh) {
  if (const auto submesh = mesh.child("submesh")) return submesh;
  return mesh.child("uri");
}

class Applier {
 public:
  Applier(const Environment& environment, const Sources& sources, const read::Loaded& loaded,
          const std::vector<MeshReplacement>& replacements)
      : resolver_(environment.resolver),
        sources_(sources),
        file_(*loaded.file),
        root_(loaded.root),
        replacements_(replacements) {
    result_.path = file_.path;
  }

  ModelEdits apply() {
    for (const model::Collision& collision : root_.collisions) look_at(collision);
    for (const model::Visual& visual : root_.visuals) look_at(visual);
    if (file_.document) look_elsewhere();
    return std::move(result_);
  }

 private:
  template <class Part>
  void look_at(const Part& part) {
    const auto* mesh = std::get_if<model::Mesh>(&part.geometry.shape);
    if (mesh == nullptr || mesh->uri.value.empty() || mesh->uri.span.nowhere()) return;
    const MeshReplacement* by = replacement_of(mesh->uri.value, mesh->uri.span.source);
    // Included twice, a file still stands there once.
    if (by == nullptr || !seen_.insert(place(mesh->uri.span)).second) return;
    const bool own = root_.own(part.site);
    if (own) ++result_.uses;
    if (const auto why = own ? edit(part, *mesh, *by) : NotEdited::kIncluded) {
      result_.left.push_back({mesh->uri.span, model::subject(root_, part), *why});
    }
  }

  /// Nothing when it could be edited.
  template <class Part>
  std::optional<NotEdited> edit(const Part& part, const model::Mesh& mesh,
                                const MeshReplacement& by) {
    if (!file_.document->complete()) return NotEdited::kCutDocument;
    if (mesh.center.value) return NotEdited::kSubmeshCenter;
    if (!mesh.submesh.value.empty() && !keeps_parts(by.new_file)) return NotEdited::kSubmeshForgot;
    const Element shape = file_.document->element(part.geometry.site.element);
    const bool scale_lost = read::child_text(shape, "scale") && !mesh.scale.written;
    const Vector3 scale = new_scale(mesh.scale.value, by);
    if (scale_lost || !finite(scale)) return NotEdited::kScale;

    const auto uri = new_uri_of(mesh.uri.value, by);
    if (!uri) return NotEdited::kUri;
    const write::PoseForm form = write::pose_form(root_[root_[part.link].model]);
    auto pose = write_pose(*file_.document, file_.document->element(part.site.element), form,
                           part.pose.pose.value, pose_change(scale, by));
    if (!pose) return NotEdited::kPose;

    append(result_.edits, *std::move(pose));
    append(result_.edits, edits_of(shape, mesh, *uri, scale, form));
    return std::nullopt;
  }

  std::optional<std::string> new_uri_of(const std::string& uri, const MeshReplacement& by) const {
    if (normalize_path(by.file) == normalize_path(by.new_file)) return uri;
    return renamed_uri(resolver_, uri, file_.path, by.file, by.new_file);
  }

  Edits edits_of(Element shape, const model::Mesh& mesh, const std::string& uri,
                 const Vector3& scale, write::PoseForm form) const {
    const xml::Document& document = *file_.document;
    const std::vector<double> numbers{scale.x, scale.y, scale.z};
    Edits edits = uri == mesh.uri.value ? Edits() : set_uri(shape, uri);
    if (scale == mesh.scale.value) return edits;
    if (const auto element = shape.child("scale")) {
      append(edits, write::set_numbers(document, *element, numbers));
    } else if (shape.attribute("scale") || form != write::PoseForm::kPose) {
      append(edits, write::set_numbers(document, shape, "scale", numbers));
    } else {
      append(edits, insert_child(document, shape, before_scale(shape),
                                 "<scale>" + write::joined(numbers) + "</scale>"));
    }
    return edits;
  }

  /// In the place that the reader takes it from.
  Edits set_uri(Element shape, const std::string& uri) const {
    for (const std::string_view name : {"uri", "filename"}) {
      if (const auto child = shape.child(name)) return set_text(*file_.document, *child, uri);
      if (shape.attribute(name)) return set_attribute(*file_.document, shape, name, uri);
    }
    return {};
  }

  /// URIs of the file that are no shape's.
  void look_elsewhere() {
    for (const rules::Uri& uri : rules::uris_of(rules::elements_about_files(*file_.document))) {
      if (replacement_of(std::string(uri.text), root_.source) == nullptr) continue;
      if (!seen_.contains(place(uri.where))) {
        result_.left.push_back({uri.where, {}, NotEdited::kElsewhere});
      }
    }
  }

  using Place = std::pair<SourceId, std::size_t>;

  /// Where a value's text begins, behind white space.
  Place place(Span span) const {
    const std::string_view bytes = sources_.bytes(span);
    return {span.source,
            span.begin + static_cast<std::size_t>(read::trimmed(bytes).data() - bytes.data())};
  }

  const MeshReplacement* replacement_of(const std::string& uri, SourceId in) {
    const auto [known, is_new] = resolved_.try_emplace({in, uri}, nullptr);
    if (!is_new) return known->second;
    const auto path = resolver_.resolve(uri, sources_.path(in)).path;
    if (!path) return nullptr;
    for (const MeshReplacement& by : replacements_) {
      if (normalize_path(by.file) == *path) known->second = &by;
    }
    return known->second;
  }

  const read::Resolver& resolver_;
  const Sources& sources_;
  const read::File& file_;
  const model::Root& root_;
  const std::vector<MeshReplacement>& replacements_;
  std::set<Place> seen_;  // the URIs of shapes
  std::map<std::pair<SourceId, std::string>, const MeshReplacement*> resolved_;
  ModelEdits result_;
};

}  // namespace

std::string_view words(NotEdited why) {
  switch (why) {
    case NotEdited::kIncluded: return "it is in an included file";
    case NotEdited::kElsewhere: return "it is no shape of a collision or visual";
    case NotEdited::kSubmeshCenter: return "a part of the mesh is centered when it is loaded";
    case NotEdited::kSubmeshForgot: return "it names a part, and the new format keeps no parts";
    case NotEdited::kScale: return "its scale cannot be read, or would be no number";
    case NotEdited::kPose: return "its pose cannot be read";
    case NotEdited::kUri: return "no URI of its form leads to the new file";
    case NotEdited::kCutDocument: return "the file is damaged";
  }
  return "";
}

ModelEdits apply_mesh(const Environment& environment, const Sources& sources,
                      const read::Loaded& loaded,
                      const std::vector<MeshReplacement>& replacements) {
  return Applier(environment, sources, loaded, replacements).apply();
}

}  // namespace rigor::author
