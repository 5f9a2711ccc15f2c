// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Models from paths to what a report tells of them: totals, meshes, pictures.
//
//   ModelGatherer gatherer(checking, sources);
//   GatheredModel model = gatherer.gather(path, pictures);   // from any thread

#pragma once

#include <cstdint>
#include <string>

#include <rigor/model/frames.h>
#include <rigor/read/load.h>
#include <rigor/read/workspace.h>
#include <rigor/report/team/report.h>
#include <rigor/text/sources.h>
#include <rigor/view/drawing/drawing.h>

#include "project/checking.h"

namespace rigor::tool {

enum class Pictures : std::uint8_t { kNone, kDraw };

struct GatheredModel {
  read::Loaded loaded;  ///< `file` is null when it could not be read
  report::ReportedModel told;

  /// Whether all of the file was read, so that a simulation means something.
  bool whole() const;
};

class ModelGatherer {
 public:
  /// Both outlive it.
  ModelGatherer(Checking& checking, Sources& sources);

  /// Safe across threads.
  GatheredModel gather(const std::string& path, Pictures pictures);

  read::Workspace& workspace() { return workspace_; }
  /// Of the threads that gather.
  Turns& turns() { return checking_.turns(); }

 private:
  void draw(GatheredModel& model, const model::Frames& frames, const view::Files& files) const;

  Checking& checking_;
  Sources& sources_;
  read::Workspace workspace_;
};

}  // namespace rigor::tool
