// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/reported_differences.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <string_view>

namespace rigor::author {

using convert::Note;
using convert::NoteKind;
using convert::Notes;
using convert::Outcome;
using robot::Difference;
using robot::DifferenceKind;

ReportedDifferences::ReportedDifferences(const model::Root& root, const Notes& notes) {
  for (const auto& link : root.links) keep(link.site);
  for (const auto& collision : root.collisions) keep(collision.site);
  for (const auto& visual : root.visuals) keep(visual.site);
  for (const auto& frame : root.frames) keep(frame.site);
  for (const auto& joint : root.joints) {
    keep(joint.site);
    for (const auto& axis : joint.axes) keep(axis.site);
  }
  for (const model::GazeboBlock& block : root.gazebo_blocks) {
    for (const model::Parameter& part : block.content) {
      const auto* name = model::attribute(part, "name");
      if (name != nullptr && (part.name == "joint" || part.name == "frame")) {
        of_blocks_.insert(part.name + ' ' + name->value);
      }
    }
  }
  for (const Note& note : notes) add(note);
  for (auto& [source, places] : places_) {
    std::sort(places.spans.begin(), places.spans.end());
    std::uint32_t furthest = 0;
    for (const auto& [begin, end] : places.spans) {
      furthest = std::max(furthest, end);
      places.furthest.push_back(furthest);
    }
  }
}

void ReportedDifferences::add(const Note& note) {
  static constexpr std::string_view kLink = "/link ";
  switch (note.kind) {
    case NoteKind::kMassless:
      if (const std::size_t at = note.subject.rfind(kLink); at != std::string::npos) {
        massless_.insert(note.subject.substr(at + kLink.size()));
      }
      break;
    case NoteKind::kUriElsewhere: elsewhere_.insert(note.instead); break;
    case NoteKind::kWorldLink: worlds_.insert("link " + note.written); break;
    case NoteKind::kMimicLost: unfollowing_.push_back(note.subject); break;
    case NoteKind::kJointType: has_gearbox_ |= note.written == "gearbox"; break;
    default: break;
  }
  if (note.outcome != Outcome::kLost && note.outcome != Outcome::kSubstituted) return;
  has_shape_ |= note.kind == NoteKind::kShape;
  has_loop_ |= note.kind == NoteKind::kLoop;
  if (note.where.nowhere()) return;
  places_[note.where.source].spans.emplace_back(note.where.begin, note.where.end);
}

bool ReportedDifferences::include(const Difference& difference) const {
  if (in_other_words(difference)) return true;
  if (difference.a.empty() && of_blocks_.contains(difference.b)) return true;
  const Span where = whole(difference.span_a);
  if (where.nowhere()) return follows(difference.kind);
  const auto places = places_.find(where.source);
  return places != places_.end() && places->second.touch(where);
}

/// Whether one of the spans is in `where`, or `where` in one of them.
bool ReportedDifferences::Places::touch(const Span& where) const {
  const auto after =
      std::upper_bound(spans.begin(), spans.end(),
                       std::pair{where.begin, std::numeric_limits<std::uint32_t>::max()});
  const auto before = static_cast<std::size_t>(after - spans.begin());
  if (before > 0 && furthest[before - 1] >= where.end) return true;
  // Spans in a document nest: of those that begin inside, the first ends there, too.
  for (auto inside = std::lower_bound(spans.begin(), spans.end(), std::pair{where.begin, 0U});
       inside != spans.end() && inside->first <= where.end; ++inside) {
    if (inside->second <= where.end) return true;
  }
  return false;
}

void ReportedDifferences::keep(const model::Site& site) {
  whole_[{site.tag.source, site.tag.begin}] = site.span;
}

/// A difference stands at a start tag; the note may refer to something inside.
Span ReportedDifferences::whole(const Span& tag) const {
  const auto found = whole_.find({tag.source, tag.begin});
  return found == whole_.end() ? tag : found->second;
}

/// Of what stands nowhere in the source: several shapes for one, and the world that only a cut joint
/// named.
bool ReportedDifferences::follows(DifferenceKind kind) const {
  const bool shape =
      kind == DifferenceKind::kCollisionOnlyInB || kind == DifferenceKind::kVisualOnlyInB;
  return (shape && has_shape_) || (kind == DifferenceKind::kLinkOnlyInA && has_loop_);
}

/// Of notes that do not refer to a loss, or not at its place.
bool ReportedDifferences::in_other_words(const Difference& difference) const {
  switch (difference.kind) {
    // What hangs on a link without mass hangs on what that is fixed to.
    case DifferenceKind::kJointParent: return massless_.contains(difference.from.text);
    // A mesh that is not found from where the result will stand has the name that was chosen for it.
    case DifferenceKind::kMesh: return elsewhere_.contains(difference.to.text);
    // Nothing hangs on the world any more where what hung there is free.
    case DifferenceKind::kLinkOnlyInA: return worlds_.contains(difference.a);
    case DifferenceKind::kMimic:
      // The joints that a gearbox couples have no mimic in the source.
      if (has_gearbox_ && difference.from.numbers.empty()) return true;
      // A mimic that the target has no word for stands beside the axis in URDF, not in it.
      return difference.to.numbers.empty() &&
             std::any_of(unfollowing_.begin(), unfollowing_.end(), [&](const std::string& subject) {
               return subject.ends_with("/" + difference.a);
             });
    default: return false;
  }
}

}  // namespace rigor::author
