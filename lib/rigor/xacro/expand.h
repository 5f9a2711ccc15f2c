// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Expands a xacro file as ros/xacro 2.1 does, in this process and without an interpreter, and keeps what
// brought each element, attribute and text of the result. After an error it goes on as far as meaning
// allows, so that one run tells more than one.
//
//   World world{disk, find_package, variable, working_folder};
//   Expansion expansion = expand("robot.urdf.xacro", world, {.arguments = {{"prefix", "left_"}}}, sources);
//   if (expansion.ok()) write(print(*expansion.document, "robot.urdf.xacro"));
//   for (const Fact& fact : expansion.facts) say(fact.where, describe(fact));
//
// Where releases differ, 2.1's meaning holds: arguments of a macro's call are resolved where the call is
// written.

#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/text/disk.h>
#include <rigor/text/sources.h>
#include <rigor/xacro/bounds.h>
#include <rigor/xacro/fact.h>
#include <rigor/xacro/node.h>

namespace rigor::xacro {

class Heap;

/// What a template may reach: the disk, packages and variables by the names that it writes.
struct World {
  const Disk& disk;
  /// The folder of a package for `$(find NAME)` in a file; no function finds none.
  std::function<std::optional<std::string>(std::string_view package, std::string_view file)>
      find_package = {};
  /// A variable of the environment for `$(env NAME)` and `$(optenv NAME)`; no function, no variables.
  std::function<std::optional<std::string>(std::string_view name)> variable = {};
  /// Where a file lies that is not where a path says: in a source tree, what installation moves.
  std::function<std::optional<std::string>(const std::string& missing)> locate = {};
  /// Whether a file is in a place that no argument names: none of the packages, not the robot's own tree. It is
  /// read all the same, and reported. No function, no such place.
  std::function<bool(const std::string& path)> outside = {};
  /// What `$(cwd)` is; absolute. Files below it are shown by their paths from there.
  std::string working_folder = ".";
};

struct Options {
  std::vector<std::pair<std::string, std::string>> arguments = {};  ///< `name:=value`
  Bounds bounds = {};
};

/// A macro's call, an include, a condition or a block that brought nodes into the result.
struct Frame {
  FactFrame::Kind kind = FactFrame::Kind::kInclude;
  std::uint32_t outer = 0;  ///< index of the frame around; the file's own is 0 and its own outer
  Span where;               ///< of the tag
  std::string_view name;    ///< of the macro, the file, the condition, the block
  std::uint32_t parameters = 0;  ///< of a macro: the first in `Expansion::frame_parameters`
  std::uint32_t parameter_count = 0;
};

/// A macro's parameter in a call, with its value: a text, a number as it prints, "…" for anything else.
struct FrameParameter {
  std::string_view name;
  std::string_view value;
};

/// As a call shows it: 60 bytes at most.
std::string shown_value(std::string_view value);

/// Where the value is set of an expression in a text of several.
struct PartOrigin {
  std::uint32_t begin = 0;  ///< of the expression in the text as it is written
  std::uint32_t end = 0;
  Span from;
};

/// Those of all texts. A text is known by where its first byte lies.
class PartOrigins {
 public:
  void add(std::string_view text, std::span<const PartOrigin> parts);
  /// Once all are there, before the first is asked for.
  void sort();
  /// Empty where a text has no more than one expression.
  std::span<const PartOrigin> of(std::string_view text) const;

 private:
  struct Row {
    const char* text;
    std::uint32_t begin;
    std::uint32_t count;
  };
  std::vector<Row> rows_;
  std::vector<PartOrigin> parts_;
};

struct FileUse {
  std::string path;  ///< as it was opened
  SourceId source = kNoSource;
};

/// Nodes stay valid as long as the expansion and the `Sources`.
struct Expansion {
  Expansion();
  Expansion(Expansion&&) noexcept;
  Expansion& operator=(Expansion&&) noexcept;
  ~Expansion();

  /// Holds the root and the comments around it; null when the file could not be read at all.
  const Node* document = nullptr;
  const Node* root = nullptr;
  std::vector<Fact> facts;                       ///< in the order they were found
  std::uint32_t facts_left_out = 0;              ///< past the bound
  std::vector<Frame> frames;                     ///< the first is the file itself
  std::vector<FrameParameter> frame_parameters;  ///< of all calls of macros
  std::vector<FileUse> files;  ///< all that was read, the file itself first, each once

  std::vector<Span>
      skipped_conditions;  ///< tags of `if` and `unless` that were not taken, each time

  /// Without errors: the result is what the reference prints.
  bool ok() const;

  /// Without errors but packages that are not found and that nothing is read of: the result is what the
  /// reference prints where they are installed, but for the paths of their folders, which are
  /// `package://NAME`.
  bool is_known() const;

  /// What brought a frame's nodes, innermost first; no more than `kMaxShownFrames`.
  std::vector<FactFrame> stack_of(std::uint32_t frame) const;

  /// Of attributes and texts with several expressions.
  PartOrigins part_origins;

  // What the nodes live in.
  std::unique_ptr<Heap> heap;
  std::unique_ptr<Nodes> nodes;
};

Expansion expand(const std::string& path, const World& world, const Options& options,
                 Sources& sources);

}  // namespace rigor::xacro
