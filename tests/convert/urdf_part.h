// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The first link of an SDF model given as text, converted by itself.

#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <rigor/convert/urdf/draft.h>
#include <rigor/model/frames.h>
#include <rigor/read/load.h>
#include <rigor/read/workspace.h>
#include <rigor/rules/environment.h>
#include <rigor/text/disk.h>
#include <rigor/text/sources.h>

namespace rigor::test {

struct UrdfPart {
  /// `model` is what stands in the model.
  explicit UrdfPart(const std::string& model, const std::string& version = "1.9",
                    convert::UrdfOptions the_options = {}, const model::Pose& X_JL = {},
                    std::map<std::string, std::string> files = {}, const std::string& out = {})
      : disk(std::move(files)),
        environment(disk, {}),
        workspace(disk, sources),
        options(std::move(the_options)),
        loaded(read::load({workspace, environment.resolver, environment.sdf, environment.urdf},
                          workspace.put("/robots/arm/model.sdf", "<sdf version='" + version +
                                                                     "'><model name='arm'>" +
                                                                     model + "</model></sdf>"))),
        frames(loaded.root),
        documents(workspace),
        source{loaded.root,
               frames,
               documents,
               environment.resolver,
               environment.sdf,
               environment.workers,
               "/robots/arm/model.sdf",
               out},
        ledger(documents),
        draft{.source = source, .options = options, .ledger = ledger} {
    ledger.open(loaded.root.models[0].site, "arm");
    for (std::uint32_t i = 0; i < loaded.root.links.size(); ++i) {
      draft.link_names[{i}] = loaded.root.links[i].name.value;
    }
    draft.top = {0};
    if (!loaded.root.links.empty()) link = convert::urdf_link(draft, {0}, X_JL);
  }

  /// Closes the account.
  convert::Account account() {
    return std::move(ledger).close(
        [this](const model::Site& opened, xml::Element element) {
          return convert::is_implied(source, opened, element);
        },
        [this](xml::Element element, xml::Attribute attribute) {
          return convert::is_implied(source, element, attribute);
        },
        convert::kind_of);
  }

  MemoryDisk disk;
  Environment environment;
  Sources sources;
  read::Workspace workspace;
  convert::UrdfOptions options;
  read::Loaded loaded;
  model::Frames frames;
  read::Documents documents;
  convert::Source source;
  convert::Ledger ledger;
  convert::UrdfDraft draft;
  convert::UrdfLink link;
};

inline std::vector<convert::Note> of_kind(const convert::Notes& notes, convert::NoteKind kind) {
  std::vector<convert::Note> found;
  std::copy_if(notes.begin(), notes.end(), std::back_inserter(found),
               [kind](const convert::Note& note) { return note.kind == kind; });
  return found;
}

/// A link around a shape in a visual and the same in a collision.
inline std::string link_with_shape(const std::string& shape) {
  const std::string geometry = "<geometry>" + shape + "</geometry>";
  return "<link name='base'><visual name='v'>" + geometry + "</visual><collision name='c'>" +
         geometry + "</collision></link>";
}

}  // namespace rigor::test
