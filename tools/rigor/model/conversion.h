// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What conversions share: the file they read, what they do with a result and with its
// losses.

#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <rigor/author/conversion.h>
#include <rigor/rules/environment.h>
#include <rigor/text/disk.h>

#include "command/command.h"
#include "option/search.h"
#include "option/selection.h"
#include "output/output.h"

namespace rigor::tool {

/// What a direction does: the library call, with this file and these options.
using Convert =
    std::function<author::Conversion(const Environment&, Sources&, read::Workspace&,
                                     const read::Loaded&, const author::ConversionOptions&)>;

class ConversionCommand {
 public:
  /// `ending` is that of the result: ".urdf".
  ConversionCommand(model::Format from, std::string ending)
      : from_(from), ending_(std::move(ending)) {}

  void declare(CLI::App& app);
  int run(const Convert& convert) const;

  /// Whether there is a folder that further files may be written to.
  bool writes_file() const { return !out_.empty(); }
  bool compares_file() const { return !check_.empty(); }
  bool allows_loss() const { return allow_loss_; }
  /// The result's name without its folder; "robot" and the ending where it goes to stdout.
  std::string result_name() const;

 private:
  std::string stem() const;
  int check(const Environment& environment, Sources& sources, read::Workspace& workspace,
            const read::Loaded& loaded, const author::Conversion& result) const;
  void write_result(const author::Conversion& result) const;
  std::string place_of(const convert::SideFile& file) const;
  void tell(const author::Conversion& result, const Sources& sources) const;
  void refuse_stdout_twice() const;

  model::Format from_;
  std::string ending_;
  CLI::App* app_ = nullptr;
  std::string in_;
  std::string out_;
  std::string check_;
  bool allow_loss_ = false;
  bool header_ = false;
  bool no_verify_ = false;
  bool verify_ = false;
  bool verbose_ = false;
  OutputOptions output_;
  ColorOption color_;
  SelectionOptions selection_;
  SearchOptions search_;
};

/// What `--mesh-uri` says: nothing, `file`, `keep`, or SCHEME://NAME.
enum class MeshNaming : std::uint8_t { kDefault, kFile, kKeep, kScheme };
struct NamedMeshes {
  MeshNaming naming = MeshNaming::kDefault;
  std::string name;  ///< of kScheme: behind it
};
NamedMeshes mesh_naming(const std::string& text, const std::vector<std::string>& schemes);

}  // namespace rigor::tool
