// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// An SDF file brought to a later version by edits, its meaning kept: what a version took for granted
// is written out, what it called otherwise is renamed, and all else keeps its bytes.
//
//   Upgrade result = upgrade(environment, loaded, schema::Version{9});
//   for (const UpgradeNote& note : result.notes) say(note.severity, note.where, note.message);
//   if (!result.refused()) write(result.text);
//
// The steps go from version to version, as the versions did (docs/upgrade.md has the table). The result
// is read again and held against what the file was before, number by number; where they differ,
// the upgrade is refused. Files that it includes are not touched: each is read by its own version.

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/read/load.h>
#include <rigor/rules/environment.h>
#include <rigor/schema/version.h>
#include <rigor/text/diagnostic.h>
#include <rigor/text/edit.h>
#include <rigor/text/span.h>

namespace rigor::author {

enum class UpgradeNoteKind : std::uint8_t {
  // Errors: nothing is changed.
  kNotReadable,  ///< not well-formed, or no file that can be read
  kNotSdf,
  kVersionUnknown,  ///< the file states none, or one that was never published
  kNewer,           ///< the file is newer than what is asked for
  kScopedName,      ///< `::` in a name, which 1.8 reserves
  kNotTheSame,      ///< the result, read again, is another model
  kLost,  ///< an older version has no word for it (downgrade.h); a warning where that is allowed

  // Warnings: what the newer version has no place for stays as it is.
  kRemoved,
  kCommentLost,   ///< it stood in an element that was written anew
  kIncludeNewer,  ///< an included file is newer than what is asked for
  kConfigEntry,   ///< the model.config beside it has to go on stating the old version

  // What is worth knowing.
  kRenamed,         ///< a joint or frame that had its sibling's name
  kUnlimited,       ///< a zero that meant "no limit"
  kDefaultChanged,  ///< of something that is not written; consumers take the newest for all versions
  kDeprecated,
};

/// "scoped-name"; stable, for programs.
std::string_view to_string(UpgradeNoteKind kind);

struct UpgradeNote {
  UpgradeNoteKind kind{};
  Severity severity = Severity::kInfo;
  Span where;           ///< in the file as it was; nowhere when it is about a file
  std::string message;  ///< lower case, no full stop
};

struct FileChange {
  std::string path;
  std::string before;  ///< its bytes
  std::vector<Edit> edits;
  std::string text;  ///< its bytes after them
};

struct Upgrade {
  schema::Version from;
  schema::Version to;
  std::vector<Edit> edits;  ///< of the file; none when it is refused, or of that version already
  std::string text;         ///< the file's bytes after them
  /// The model.config beside it, when what that says of its version goes along: both or neither.
  std::optional<FileChange> config;
  std::vector<UpgradeNote> notes;

  bool refused() const;
};

/// `to` is a version that the schema knows.
Upgrade upgrade(const Environment& environment, const read::Loaded& loaded, schema::Version to);

}  // namespace rigor::author
