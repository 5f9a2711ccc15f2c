// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// From a path to what the page of `rigor view` shows.
//
//   const MadePage made = make_page(disk, search, "my_robot", report::PageUse::kFile);
//   if (!made.problem.empty()) return kFindings;

#pragma once

#include <string>

#include <rigor/report/page/changes.h>
#include <rigor/report/page/model_page.h>
#include <rigor/text/disk.h>

#include "option/search.h"

namespace rigor::tool {

struct MadePage {
  std::string path;  ///< of the model's file
  report::PageData data;
  report::PageFacts facts;  ///< of a page that is served
  std::string problem;      ///< why there is no model to show; empty when there is
};

/// The findings are those of `rigor validate`, with the configuration of the file. Pictures are left out where
/// Embree is not installed. A UsageError when the path cannot be read, or a configuration cannot stand.
MadePage make_page(const Disk& disk, const SearchOptions& search, const std::string& path,
                   report::PageUse use);

}  // namespace rigor::tool
