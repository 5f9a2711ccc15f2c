// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A conversion as a user asks for it: converted, reported in findings, and proved. The result is read again
// as any file is, once by rigor and once by urdfdom, and moved through random joint positions beside
// the source (robot/compare.h).
//
//   Conversion result = to_urdf(environment, sources, workspace, loaded, {}, {});
//   if (result.text && !result.diagnostics.count(Severity::kError)) write(*result.text);

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/convert/from_mjcf.h>
#include <rigor/convert/sdf_to_urdf.h>
#include <rigor/convert/to_mjcf.h>
#include <rigor/convert/urdf_to_sdf.h>
#include <rigor/read/load.h>
#include <rigor/read/workspace.h>
#include <rigor/robot/compare.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>
#include <rigor/text/diagnostic.h>
#include <rigor/text/sources.h>

namespace rigor::author {

enum class Proof : std::uint8_t { kNone, kVerify };

/// Whether a loss that is an error keeps the result from being used. That the result is another robot
/// than it should be is never allowed.
enum class Losses : std::uint8_t { kRefused, kAllowed };

/// Whether the result begins with a comment that tells the account.
enum class AccountHeader : std::uint8_t { kNone, kComment };

struct ConversionOptions {
  rules::Selection selection;  ///< when it selects nothing, the category `convert`
  Proof proof = Proof::kVerify;
  Losses losses = Losses::kRefused;  ///< kAllowed: they are warnings
  AccountHeader header = AccountHeader::kNone;
  std::string out;  ///< where the result will stand: what its URIs are looked up from
  std::string working_folder = {};  ///< that relative paths are seen from; empty: not known
};

struct Conversion {
  model::Id<model::Model> model;    ///< that was converted, or was to be
  std::optional<std::string> text;  ///< nothing when the notes say why there is none
  std::vector<convert::SideFile> files;
  convert::Account account;
  Diagnostics diagnostics;
  /// What of the source is what of the result, by the choices that were made.
  robot::Correspondence names;
  std::size_t configurations = 0;  ///< joint positions that it was proved at
};

/// `loaded` holds SDF.
Conversion to_urdf(const Environment& environment, Sources& sources, read::Workspace& workspace,
                   const read::Loaded& loaded, const convert::UrdfOptions& how,
                   const ConversionOptions& options);

/// `loaded` holds URDF.
Conversion to_sdf(const Environment& environment, Sources& sources, read::Workspace& workspace,
                  const read::Loaded& loaded, const convert::SdfOptions& how,
                  const ConversionOptions& options);

/// `loaded` holds SDF or URDF. The text is MJCF; `model` is the first of those that were converted.
Conversion to_mjcf(const Environment& environment, Sources& sources, read::Workspace& workspace,
                   const read::Loaded& loaded, const convert::MjcfOptions& how,
                   const ConversionOptions& options);

/// `loaded` holds MJCF.
Conversion from_mjcf_to_urdf(const Environment& environment, Sources& sources,
                             read::Workspace& workspace, const read::Loaded& loaded,
                             const convert::FromMjcfOptions& how, const ConversionOptions& options);
Conversion from_mjcf_to_sdf(const Environment& environment, Sources& sources,
                            read::Workspace& workspace, const read::Loaded& loaded,
                            const convert::FromMjcfOptions& how, const ConversionOptions& options);

/// "convert", "rewritten": the words of outcomes, in their order.
std::string_view to_string(convert::Outcome outcome);

}  // namespace rigor::author
