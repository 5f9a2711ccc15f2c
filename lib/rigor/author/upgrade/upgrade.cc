// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/upgrade/upgrade.h>

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/core.h>

#include <rigor/author/patched_text.h>
#include <rigor/author/upgrade/config.h>
#include <rigor/author/upgrade/step.h>
#include <rigor/model/subject.h>
#include <rigor/read/workspace.h>
#include <rigor/text/sources.h>
#include <rigor/xml/edit.h>

namespace rigor::author {
namespace {

using schema::Version;

struct VersionChange {
  int version;  ///< that brought it
  void (*carry_out)(UpgradeStep&);
};

/// In their order. Those of one version must not edit the same place.
constexpr std::array<VersionChange, 16> kChanges{{{2, upgrade_attributes},
                                                  {3, upgrade_file_names},
                                                  {3, upgrade_state_time},
                                                  {4, upgrade_step_size},
                                                  {4, upgrade_zero_limits},
                                                  {5, upgrade_axes_to_flag},
                                                  {5, upgrade_actor_static},
                                                  {6, upgrade_gravity},
                                                  {6, upgrade_imu_noise},
                                                  {7, upgrade_axes_to_expressed_in},
                                                  {7, upgrade_feedback},
                                                  {7, upgrade_pose_frames},
                                                  {8, upgrade_inertial_poses},
                                                  {8, refuse_scoped_names},
                                                  {10, upgrade_screws},
                                                  {12, upgrade_states}}};

Span in_place(Span span) { return span; }

class Upgrader {
 public:
  Upgrader(const Environment& environment, const read::Loaded& loaded, Version to)
      : environment_(environment), loaded_(loaded), document_(*loaded.file->document) {
    result_.to = to;
    result_.text = document_.bytes();
  }

  Upgrade upgrade() {
    if (!may_be_upgraded() || result_.from == result_.to) return finish();
    PatchedText text(std::string(document_.bytes()));
    notes_.take(notes_on_defaults(document_, environment_.sdf, result_.from, result_.to), in_place);
    if (!rename_siblings(text)) return refuse_overlap();
    Version reached = result_.from;
    for (const VersionChange& change : kChanges) {
      const Version version{change.version};
      if (version <= result_.from || version > result_.to) continue;
      if (!carry_out(change, reached, text)) return refuse_overlap();
      reached = version;
    }
    if (!write_version(text)) return refuse_overlap();
    if (!notes_.has_errors()) prove(text);
    tell_surroundings();
    if (!notes_.has_errors()) {
      result_.edits = text.edits(document_.source());
      result_.text = text.text();
      ConfigUpgrade config = upgrade_config(environment_.disk, loaded_.file->path, result_.to);
      for (UpgradeNote& note : config.notes) notes_.add(std::move(note));
      result_.config = std::move(config.change);
    }
    return finish();
  }

 private:
  void add(UpgradeNoteKind kind, Severity severity, Span where, std::string message) {
    notes_.add({kind, severity, where, std::move(message)});
  }

  bool may_be_upgraded() {
    const auto refuse = [this](UpgradeNoteKind kind, Span where, std::string message) {
      add(kind, Severity::kError, where, std::move(message));
      return false;
    };
    if (!document_.complete()) {
      return refuse(UpgradeNoteKind::kNotReadable, {}, "is not well-formed: validate says where");
    }
    const model::Root& root = loaded_.root;
    if (root.format != model::Format::kSdf) {
      return refuse(UpgradeNoteKind::kNotSdf, {}, "is no SDF file");
    }
    const auto version = schema::parse_version(root.version_text.value);
    if (!root.version_text.written) {
      return refuse(UpgradeNoteKind::kVersionUnknown, root.site.tag,
                    "states no version: what it means depends on it");
    }
    if (version && *version > result_.to) {
      result_.from = *version;
      return refuse(UpgradeNoteKind::kNewer, root.version_text.span,
                    fmt::format("is SDF {}, which is newer than {}: models are brought to later "
                                "versions only",
                                root.version_text.value, to_string(result_.to)));
    }
    if (!version || !environment_.sdf.knows(*version)) {
      return refuse(
          UpgradeNoteKind::kVersionUnknown, root.version_text.span,
          fmt::format("states version {}, which was never published", root.version_text.value));
    }
    result_.from = *version;
    return true;
  }

  Upgrade refuse_overlap() {
    add(UpgradeNoteKind::kNotReadable, Severity::kError, loaded_.root.site.tag,
        "two changes meet in one place; put each element on a line of its own");
    return finish();
  }

  /// What consumers call a joint or frame that has a sibling's name, it is called since 1.7.
  bool rename_siblings(PatchedText& text) {
    constexpr Version kUnique{7};
    if (result_.from >= kUnique || result_.to < kUnique) return true;
    std::vector<Edit> edits;
    const auto rename = [&](const auto& entity) {
      if (entity.alias.empty() || !loaded_.root.own(entity.site)) return;
      const xml::Element element = document_.element(entity.site.element);
      append(edits, xml::set_attribute(document_, element, "name", entity.alias));
      add(UpgradeNoteKind::kRenamed, Severity::kInfo, entity.name.span,
          fmt::format("a sibling has the name '{}' too: it is '{}' now, as libsdformat calls it; "
                      "plugins that name it are not checked",
                      entity.name.value, entity.alias));
    };
    for (const model::Joint& joint : loaded_.root.joints) rename(joint);
    for (const model::Frame& frame : loaded_.root.frames) rename(frame);
    return text.apply(std::move(edits));
  }

  bool carry_out(const VersionChange& change, Version reached, PatchedText& text) {
    const std::string bytes = text.text();
    const xml::Document document = xml::parse(bytes, document_.source());
    UpgradeStep step(document, environment_.sdf, result_.from, reached, result_.to);
    change.carry_out(step);
    const PlacesBefore places(text.edits(document_.source()));
    notes_.take(step.take_notes(), [&](Span span) { return places.of(span); });
    return text.apply(step.take_edits());
  }

  bool write_version(PatchedText& text) {
    constexpr Version kSdfRoot{3};
    const std::string bytes = text.text();
    const xml::Document document = xml::parse(bytes, document_.source());
    const xml::Element root = *document.root();
    std::vector<Edit> edits = xml::set_attribute(document, root, "version", to_string(result_.to));
    if (result_.to >= kSdfRoot) append(edits, xml::rename_element(document, root, "sdf"));
    return text.apply(std::move(edits));
  }

  /// Reads what was made and holds it against what was.
  void prove(const PatchedText& text) {
    Sources sources;
    read::Workspace workspace(environment_.disk, sources);
    const read::Reader reader{workspace, environment_.resolver, environment_.sdf,
                              environment_.urdf};
    const read::File& file = workspace.put(loaded_.file->path, text.text());
    const read::Loaded after = read::load(reader, file);
    notes_.take(differences_after_upgrade(loaded_, after), in_place);
    if (notes_.has_errors()) return;
    const PlacesBefore places(text.edits(document_.source()));
    notes_.take(notes_after_upgrade(*file.document, environment_.sdf, result_.from, result_.to),
                [&](Span span) { return places.of(span); });
  }

  void tell_surroundings() {
    for (const model::Include& include : loaded_.root.includes) {
      if (!include.loaded || !loaded_.root.own(include.site)) continue;
      const model::Model& model = loaded_.root[include.loaded];
      if (model.format != model::Format::kSdf || model.version <= result_.to.minor) continue;
      add(UpgradeNoteKind::kIncludeNewer, Severity::kWarning, include.uri.span,
          fmt::format("{} is SDF 1.{}: a consumer that knows no more than {} cannot read it",
                      include.path, model.version, to_string(result_.to)));
    }
  }

  Upgrade finish() {
    result_.notes = notes_.take_list();
    return std::move(result_);
  }

  const Environment& environment_;
  const read::Loaded& loaded_;
  const xml::Document& document_;
  UpgradeNotes notes_;
  Upgrade result_;
};

}  // namespace

std::string_view to_string(UpgradeNoteKind kind) {
  switch (kind) {
    case UpgradeNoteKind::kNotReadable: return "not-readable";
    case UpgradeNoteKind::kNotSdf: return "not-sdf";
    case UpgradeNoteKind::kVersionUnknown: return "version-unknown";
    case UpgradeNoteKind::kNewer: return "newer";
    case UpgradeNoteKind::kScopedName: return "scoped-name";
    case UpgradeNoteKind::kNotTheSame: return "not-the-same";
    case UpgradeNoteKind::kLost: return "lost";
    case UpgradeNoteKind::kRemoved: return "removed";
    case UpgradeNoteKind::kCommentLost: return "comment-lost";
    case UpgradeNoteKind::kIncludeNewer: return "include-newer";
    case UpgradeNoteKind::kRenamed: return "renamed";
    case UpgradeNoteKind::kUnlimited: return "unlimited";
    case UpgradeNoteKind::kDefaultChanged: return "default-changed";
    case UpgradeNoteKind::kDeprecated: return "deprecated";
    case UpgradeNoteKind::kConfigEntry: return "config-entry";
  }
  return {};
}

bool Upgrade::refused() const {
  return std::any_of(notes.begin(), notes.end(),
                     [](const UpgradeNote& note) { return note.severity == Severity::kError; });
}

Upgrade upgrade(const Environment& environment, const read::Loaded& loaded, Version to) {
  if (!loaded.file->document) {
    Upgrade result;
    result.to = to;
    result.notes.push_back({UpgradeNoteKind::kNotReadable,
                            Severity::kError,
                            {},
                            "cannot be read: " + loaded.file->problem});
    return result;
  }
  return Upgrader(environment, loaded, to).upgrade();
}

}  // namespace rigor::author
