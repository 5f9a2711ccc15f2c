// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The SRDF that is checked, held against the robot that it names.
//
//   void check(const model::Root&, Context& context) {
//     report_srdf(context, {robot::SrdfFactKind::kChainBroken});
//   }

#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/read/srdf/srdf.h>
#include <rigor/robot/semantic/srdf_check.h>
#include <rigor/text/disk.h>

namespace rigor::rules {

class Context;

/// "link 'palm' does not exist in robot 'arm'"
std::string describe(const robot::SrdfFact& fact, std::string_view robot);

/// URDF files and templates whose robot has the name: those below the SRDF's folder, else below the one around it,
/// and so on, three folders up; in the order of their depth.
std::vector<std::string> robots_near(const Disk& disk, const std::string& srdf_path,
                                     std::string_view name);

/// Reports what of these kinds is wrong with the file, if it is an SRDF whose robot is found.
void report_srdf(Context& context, std::initializer_list<robot::SrdfFactKind> kinds);

/// The name of the robot that the file, an SRDF, is about, when no such robot is found, or none without errors.
std::optional<read::SrdfName> missing_robot(Context& context);

}  // namespace rigor::rules
