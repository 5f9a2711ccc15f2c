// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What an edit did to a model that somebody looks at, in short sentences: things that came, went, moved or weigh
// something else, and findings that are new or gone.
//
//   const PageFacts after = facts_of(page);
//   for (const std::string& sentence : page_changes(before, after)) say(sentence);

#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <rigor/model/pose.h>
#include <rigor/report/changes.h>
#include <rigor/report/page/model_page.h>

namespace rigor::report {

/// What of a page is compared with the next.
struct PageFacts {
  struct Link {
    std::optional<model::Pose> pose;  ///< in the file's frame
    double mass = 0;                  ///< kg
    std::string rest;                 ///< center of mass and inertia, as text
  };
  std::map<std::string, Link> links;          ///< by scoped name
  std::map<std::string, std::string> joints;  ///< what each is, as text
  std::map<std::string, std::string>
      shapes;  ///< of visuals and collisions, how each looks, as text
  std::vector<KnownFinding> findings;
};

PageFacts facts_of(const ModelPage& page);

/// More sentences are only counted, in a last one.
inline constexpr std::size_t kMaxChanges = 8;

/// None when nothing changed that a page shows.
std::vector<std::string> page_changes(const PageFacts& before, const PageFacts& after);

/// {"changes": […], "nothing": false}, in one line
std::string page_changes_json(const std::vector<std::string>& changes);

}  // namespace rigor::report
