// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which differences between a source and its conversion the notes on the conversion have reported
// already, so that the proof of the result says nothing new with them. Private to the room.
//
//   const ReportedDifferences reported(source.root, account.notes);
//   if (!reported.include(difference)) notes.push_back(note_of(difference));

#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <rigor/convert/note.h>
#include <rigor/model/model.h>
#include <rigor/robot/compare.h>

namespace rigor::author {

class ReportedDifferences {
 public:
  ReportedDifferences(const model::Root& root, const convert::Notes& notes);

  /// In the time of a search: a model may have a note for each of its thousands of shapes.
  bool include(const robot::Difference& difference) const;

 private:
  /// What notes on something lost or substituted point at, in one file.
  struct Places {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> spans;  ///< begin and end, in order
    std::vector<std::uint32_t> furthest;  ///< the greatest end of a span and of all before it

    bool touch(const Span& where) const;
  };

  void keep(const model::Site& site);
  void add(const convert::Note& note);
  Span whole(const Span& tag) const;
  bool follows(robot::DifferenceKind kind) const;
  bool in_other_words(const robot::Difference& difference) const;

  std::map<std::pair<SourceId, std::uint32_t>, Span> whole_;  ///< of each start tag
  std::map<SourceId, Places> places_;
  std::set<std::string> massless_;   ///< names of links
  std::set<std::string> elsewhere_;  ///< names that meshes got
  std::set<std::string> worlds_;     ///< links that became the world
  std::set<std::string>
      of_blocks_;  ///< "joint loop", of `<gazebo>`, where URDF has no robot's parts
  std::vector<std::string> unfollowing_;  ///< subjects of joints that mimic none any more
  bool has_gearbox_ = false, has_shape_ = false, has_loop_ = false;
};

}  // namespace rigor::author
