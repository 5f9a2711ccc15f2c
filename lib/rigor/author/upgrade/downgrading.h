// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the parts of a downgrade share: the file as it is, the version it is to have, and what becomes of it. Private to
// the room.
//
//   Downgrading work(loaded, to, losses);
//   downgrade_poses(work);
//   downgrade_joints(work);

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <rigor/author/upgrade/downgrade.h>
#include <rigor/author/upgrade/step.h>
#include <rigor/model/frames.h>
#include <rigor/model/model.h>
#include <rigor/read/load.h>
#include <rigor/text/edit.h>
#include <rigor/xml/document.h>

namespace rigor::author {

// First versions with what older ones have not.
inline constexpr int kNestedModels = 5;
inline constexpr int kWorldGravity = 6;
inline constexpr int kPoseFrames = 7;
inline constexpr int kNestedNames = 8;
inline constexpr int kRotationFormats = 9;
inline constexpr int kInfinities = 10;  // and the pitch of a screw in m, merged includes
inline constexpr int kAutomaticInertials = 11;
inline constexpr int kNamedStates = 12;

struct Downgrading {
  Downgrading(const read::Loaded& loaded, schema::Version wanted, VersionLosses allowed)
      : root(loaded.root),
        document(*loaded.file->document),
        frames(loaded.root),
        to(wanted.minor),
        losses(allowed) {}

  void refuse(UpgradeNoteKind kind, Span where, std::string message) {
    notes.add({kind, Severity::kError, where, std::move(message)});
  }
  /// An error, or a warning where losses are allowed.
  void lose(Span where, std::string message);

  void edit(std::vector<Edit> more) { append(edits, std::move(more)); }
  xml::Element element(const model::Site& site) const { return document.element(site.element); }

  /// Whether frames have no names in the version it is to have.
  bool drops_frames() const { return from >= kPoseFrames && to < kPoseFrames; }

  /// Those of the file itself: `visit(id, entity)`.
  template <class T, class Visit>
  void each(const std::vector<T>& all, Visit visit) {
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      if (root.own(all[i].site)) visit(model::Id<T>{i}, all[i]);
    }
  }

  /// Of a link, as its model names it.
  std::string name_in(model::Id<model::Model> model, model::Id<model::Link> link) const;

  const model::Root& root;
  const xml::Document& document;
  model::Frames frames;
  int from = 0;  ///< minor versions
  int to;
  VersionLosses losses;
  std::vector<Edit> edits;
  UpgradeNotes notes;
};

/// Poses relative to frames as ones in the link or the model, and in the words of the older version.
void downgrade_poses(Downgrading& work);
/// Ends that are frames, directions, limits and pitches.
void downgrade_joints(Downgrading& work);
/// Attributes of models, frames, gravity and states.
void downgrade_worlds(Downgrading& work);

}  // namespace rigor::author
