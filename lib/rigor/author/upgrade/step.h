// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// One step of an upgrade, from a version to the next: what it reads and what it writes. Private to the
// room.

#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/author/upgrade/upgrade.h>
#include <rigor/schema/schema.h>
#include <rigor/text/edit.h>
#include <rigor/xml/document.h>

namespace rigor::author {

/// The schema's node of every element as it is in a version, or else in the nearest one that has it;
/// none of those that no version knows, and of what stands inside a plugin.
std::vector<std::optional<schema::Node>> schema_nodes(const xml::Document& document,
                                                      const schema::Schema& schema,
                                                      schema::Version version);

/// Notes, of each kind the first ones; the others are counted. Nobody reads thousands, which a file may
/// ask for.
class UpgradeNotes {
 public:
  static constexpr std::size_t kMaxOfKind = 100;

  void add(UpgradeNote note);
  /// With their places taken from a later text back to an earlier one.
  template <class Place>
  void take(UpgradeNotes&& other, Place place) {
    for (auto& [kind, of_kind] : other.kinds_) {
      for (UpgradeNote& note : of_kind.listed) {
        note.where = place(note.where);
        add(std::move(note));
      }
      kinds_[kind].more += of_kind.more;
    }
  }
  bool has_errors() const;

  /// By place; at last, for each kind, how many there are more.
  std::vector<UpgradeNote> take_list();

 private:
  struct OfKind {
    std::vector<UpgradeNote> listed;
    std::size_t more = 0;
  };
  std::map<UpgradeNoteKind, OfKind> kinds_;
};

class UpgradeStep {
 public:
  UpgradeStep(const xml::Document& document, const schema::Schema& schema, schema::Version from,
              schema::Version reached, schema::Version to)
      : document_(document),
        schema_(schema),
        from_(from),
        to_(to),
        nodes_(schema_nodes(document, schema, reached)) {}

  const xml::Document& document() const { return document_; }
  const schema::Schema& schema() const { return schema_; }
  int from() const { return from_.minor; }  ///< of the file as it was
  int to() const { return to_.minor; }      ///< of the file as it will be

  std::optional<schema::Node> node(xml::Element element) const { return nodes_[element.index()]; }

  /// All elements that some version knows, in document order.
  template <class Visit>
  void for_each(Visit visit) const {
    for (std::uint32_t i = 0; i < document_.element_count(); ++i) {
      if (nodes_[i]) visit(document_.element(i));
    }
  }
  /// Those of a name in a parent of a name.
  template <class Visit>
  void for_each(std::string_view parent, std::string_view name, Visit visit) const {
    for_each([&](xml::Element element) {
      if (element.name() != name) return;
      const auto above = element.parent();
      if (above && above->name() == parent) visit(element);
    });
  }

  void edit(std::vector<Edit> edits) { append(edits_, std::move(edits)); }
  void note(UpgradeNoteKind kind, Severity severity, Span where, std::string message) {
    notes_.add({kind, severity, where, std::move(message)});
  }

  std::vector<Edit> take_edits() { return std::move(edits_); }
  UpgradeNotes take_notes() { return std::move(notes_); }

 private:
  const xml::Document& document_;
  const schema::Schema& schema_;
  schema::Version from_;
  schema::Version to_;
  std::vector<std::optional<schema::Node>> nodes_;
  std::vector<Edit> edits_;
  UpgradeNotes notes_;
};

// What changed in a version, each in the file of its noun.
void upgrade_attributes(UpgradeStep& step);            // 1.2, attributes.cc
void upgrade_file_names(UpgradeStep& step);            // 1.3, attributes.cc
void upgrade_state_time(UpgradeStep& step);            // 1.3, world.cc
void upgrade_step_size(UpgradeStep& step);             // 1.4, world.cc
void upgrade_zero_limits(UpgradeStep& step);           // 1.4, joint.cc
void upgrade_axes_to_flag(UpgradeStep& step);          // 1.5, joint.cc
void upgrade_actor_static(UpgradeStep& step);          // 1.5, world.cc
void upgrade_gravity(UpgradeStep& step);               // 1.6, world.cc
void upgrade_imu_noise(UpgradeStep& step);             // 1.6, sensor.cc
void upgrade_axes_to_expressed_in(UpgradeStep& step);  // 1.7, joint.cc
void upgrade_feedback(UpgradeStep& step);              // 1.7, joint.cc
void upgrade_pose_frames(UpgradeStep& step);           // 1.7, pose.cc
void upgrade_inertial_poses(UpgradeStep& step);        // 1.8, pose.cc
void refuse_scoped_names(UpgradeStep& step);           // 1.8, pose.cc
void upgrade_screws(UpgradeStep& step);                // 1.10, joint.cc
void upgrade_states(UpgradeStep& step);                // 1.12, world.cc

/// What the newer version has no place for, advises against or has other defaults for
/// (notes.cc). Spans of the first list are in `after`, those of the second in `before`.
UpgradeNotes notes_after_upgrade(const xml::Document& after, const schema::Schema& schema,
                                 schema::Version from, schema::Version to);
UpgradeNotes notes_on_defaults(const xml::Document& before, const schema::Schema& schema,
                               schema::Version from, schema::Version to);

/// In what the two differ, as errors with places in the first; nothing when they are the same model
/// (proof.cc).
UpgradeNotes differences_after_upgrade(const read::Loaded& before, const read::Loaded& after);

/// The same without what the older version has no word for, which the downgrade itself reports: frames, canonical links,
/// mimics, shapes that are none to it.
UpgradeNotes differences_after_downgrade(const read::Loaded& before, const read::Loaded& after);

}  // namespace rigor::author
