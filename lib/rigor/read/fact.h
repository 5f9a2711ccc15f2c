// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a reader finds wrong beyond a file's schema, as data; a rule turns each kind into words.

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <rigor/read/parameter/parameter_fault.h>
#include <rigor/text/span.h>

namespace rigor::read {

enum class FactKind : std::uint8_t {
  kUnknownRoot,  ///< the root element is of no format rigor knows; `name` is it
  kOldRoot,      ///< `<gazebo version="1.0">`
  kVersionMissing,
  kVersionUnknown,  ///< no such version was ever published; `name` is it
  kVersionTooNew,   ///< newer than rigor knows
  kUnfollowedInclude,  ///< `https://` and not in the cache, or of Gazebo classic's database: not looked at
  kIncludeNotFound,    ///< `tried` has every place
  kIncludeUnreadable,  ///< found, but it cannot be parsed, or holds nothing; `name` says why
  kIncludeCycle,       ///< `tried` has the files of the cycle, the first again at the end
  kIncludeTooDeep,
  kIncludeHasErrors,  ///< of an included file; `name` is its path, `tried` the first of `count`
  kConfigWithoutSdf,  ///< an included model folder whose model.config names no file
  kMoreAtTopLevel,    ///< a second model, actor or light beside the first; `name` is it
  kParameterSkipped,  ///< of an include; `name` is its element and target, `parameter_fault` says why
  kTooMuchIncluded,  ///< the includes bring more parts than rigor holds
  kFileTooLarge,
  kFileUnreadable,
};

struct Fact {
  FactKind kind;
  Span where;
  std::string name;
  std::vector<std::string> tried;
  std::size_t count = 0;
  Span related = {};                    ///< of kIncludeHasErrors: the first of them, in its file
  ParameterFault parameter_fault = {};  ///< of kParameterSkipped; `tried` has the detail
};

}  // namespace rigor::read
