// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/upgrade/downgrade.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/author/patched_text.h>
#include <rigor/author/upgrade/config.h>
#include <rigor/author/upgrade/downgrading.h>
#include <rigor/read/conformance.h>
#include <rigor/read/workspace.h>
#include <rigor/text/sources.h>
#include <rigor/xml/edit.h>

namespace rigor::author {
namespace {

class Downgrader {
 public:
  Downgrader(const Environment& environment, const read::Loaded& loaded, schema::Version to,
             VersionLosses losses)
      : environment_(environment), loaded_(loaded), work_(loaded, to, losses) {
    result_.to = to;
    result_.text = work_.document.bytes();
  }

  Upgrade downgrade() {
    if (!may_be_downgraded() || result_.from == result_.to) return finish();
    refuse_what_cannot_be();
    if (!work_.notes.has_errors()) {
      work_.from = result_.from.minor;
      downgrade_poses(work_);
      downgrade_joints(work_);
      downgrade_worlds(work_);
      work_.edit(xml::set_attribute(work_.document, *work_.document.root(), "version",
                                    to_string(result_.to)));
      prove();
    }
    return finish();
  }

 private:
  bool may_be_downgraded() {
    const auto version = schema::parse_version(work_.root.version_text.value);
    if (!work_.document.complete()) {
      work_.refuse(UpgradeNoteKind::kNotReadable, {}, "is not well-formed: validate says where");
    } else if (work_.root.format != model::Format::kSdf) {
      work_.refuse(UpgradeNoteKind::kNotSdf, {}, "is no SDF file");
    } else if (!work_.root.version_text.written || !version || !environment_.sdf.knows(*version)) {
      work_.refuse(UpgradeNoteKind::kVersionUnknown, work_.root.site.tag,
                   "states no version that was published");
    } else if (*version < result_.to) {
      result_.from = *version;
      work_.refuse(UpgradeNoteKind::kNewer, work_.root.version_text.span,
                   fmt::format("is SDF {}, which is older than {}: use upgrade",
                               work_.root.version_text.value, to_string(result_.to)));
    } else {
      result_.from = *version;
    }
    return !work_.notes.has_errors();
  }

  void refuse_what_cannot_be() {
    for (const model::Include& include : work_.root.includes) {
      if (!work_.root.own(include.site)) continue;
      if (include.merge.value && work_.to < kInfinities)
        work_.refuse(UpgradeNoteKind::kLost, include.site.tag,
                     "an included model is merged since 1.10: copy it in first");
      if (!include.placement_frame.value.empty() && work_.to < kNestedNames)
        work_.refuse(
            UpgradeNoteKind::kLost, include.site.tag,
            "an included model is placed by a frame of it since 1.8: write its pose first");
    }
    for (const model::Link& link : work_.root.links) {
      if (link.inertial.automatic.value && work_.root.own(link.site) &&
          work_.to < kAutomaticInertials)
        work_.refuse(
            UpgradeNoteKind::kLost, link.inertial.site.tag,
            fmt::format("link '{}' gets its inertial from its shapes since 1.11: write it with "
                        "rigor inertia --only missing first",
                        link.name.value));
    }
    for (const model::Model& model : work_.root.models) {
      if (model.parent && work_.root.own(model.site) && work_.to < kNestedModels)
        work_.refuse(UpgradeNoteKind::kLost, model.site.tag, "models are nested since 1.5");
    }
  }

  // --- The proof ---

  void prove() {
    PatchedText text(std::string(work_.document.bytes()));
    if (!text.apply(std::move(work_.edits))) {
      return work_.refuse(UpgradeNoteKind::kNotReadable, work_.root.site.tag,
                          "two changes meet in one place; put each element on a line of its own");
    }
    Sources sources;
    read::Workspace workspace(environment_.disk, sources);
    const read::Reader reader{workspace, environment_.resolver, environment_.sdf,
                              environment_.urdf};
    const read::File& file = workspace.put(loaded_.file->path, text.text());
    const read::Loaded after = read::load(reader, file);
    name_losses(*file.document, PlacesBefore(text.edits(work_.document.source())));
    if (work_.notes.has_errors()) return;
    work_.notes.take(differences_after_downgrade(loaded_, after), [](Span span) { return span; });
    if (work_.notes.has_errors()) return;
    result_.edits = text.edits(work_.document.source());
    result_.text = text.text();
    ConfigUpgrade config = upgrade_config(environment_.disk, loaded_.file->path, result_.to);
    for (UpgradeNote& note : config.notes) work_.notes.add(std::move(note));
    result_.config = std::move(config.change);
  }

  /// What stays though the older version does not know it.
  void name_losses(const xml::Document& after, const PlacesBefore& places) {
    const auto top = after.root();
    const auto root = top ? environment_.sdf.root(top->name(), result_.to) : std::nullopt;
    if (!root) return;
    read::check_conformance(after, *root, [&](const read::SchemaFact& fact) {
      if (fact.kind != read::SchemaFactKind::kNewerThanVersion || !fact.node) return;
      const std::string what =
          fact.attribute
              ? fmt::format("attribute {} of <{}>", fact.attribute->name(), fact.element.name())
              : fmt::format("<{}>", fact.element.name());
      work_.lose(places.of(fact.where),
                 fmt::format("{}: consumers of SDF {} ignore it", what, to_string(result_.to)));
    });
  }

  Upgrade finish() {
    result_.notes = work_.notes.take_list();
    return std::move(result_);
  }

  const Environment& environment_;
  const read::Loaded& loaded_;
  Downgrading work_;
  Upgrade result_;
};

}  // namespace

Upgrade downgrade(const Environment& environment, const read::Loaded& loaded, schema::Version to,
                  VersionLosses losses) {
  if (!loaded.file->document) {
    Upgrade result;
    result.to = to;
    result.notes.push_back({UpgradeNoteKind::kNotReadable,
                            Severity::kError,
                            {},
                            "cannot be read: " + loaded.file->problem});
    return result;
  }
  return Downgrader(environment, loaded, to, losses).downgrade();
}

}  // namespace rigor::author
