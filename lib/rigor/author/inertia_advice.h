// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What to do about the inertia of a link that a simulation suspects, by what `rigor inertia` would do with the file that
// the link is in. Private to the room.
//
//   InertiaAdvice advice(environment, sources, workspace, loaded);
//   cause.help = advice.help(link.name.span);

#pragma once

#include <map>
#include <string>
#include <string_view>

#include <rigor/author/model_inertia.h>
#include <rigor/read/load.h>

namespace rigor::author {

class InertiaAdvice {
 public:
  /// All outlive it.
  InertiaAdvice(const Environment& environment, const Sources& sources, read::Workspace& workspace,
                const read::Loaded& main)
      : environment_(environment), sources_(sources), workspace_(workspace), main_(main) {}

  /// `link` is its name in its file. Empty where `rigor inertia MODEL --write` gives it one.
  std::string help(Span link);

 private:
  std::string included_path(Span link) const;
  read::Loaded load(const std::string& path) const;
  const ModelInertia& table(const read::Loaded& loaded);
  std::string help_in(const read::Loaded& loaded, Span link, const std::string& model);
  bool is_changed_copy(Span link) const;
  std::string_view text(Span where) const;

  const Environment& environment_;
  const Sources& sources_;
  read::Workspace& workspace_;
  const read::Loaded& main_;
  std::map<std::string, read::Loaded> included_;
  std::map<const read::File*, ModelInertia> tables_;
};

}  // namespace rigor::author
