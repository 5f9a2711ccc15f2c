// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/sdf_to_urdf.h>

#include <utility>

#include <rigor/convert/urdf/build.h>
#include <rigor/convert/urdf/choice.h>
#include <rigor/convert/urdf/draft.h>
#include <rigor/convert/urdf/roots.h>
#include <rigor/convert/urdf/tree.h>

namespace rigor::convert {

UrdfConversion sdf_to_urdf(const Source& source, const UrdfOptions& options) {
  UrdfConversion result;
  UrdfChoice choice = choose_model(source, options.model);
  result.model = choice.model;
  result.account.notes = std::move(choice.notes);
  if (!result.model) return result;

  const UrdfTree tree = urdf_tree(source.root, source.frames, result.model);
  const UrdfRoots roots = urdf_roots(source, options, tree);
  result.from_world = roots.has_model_pose;
  Notes& refusals = result.account.notes;
  refusals = unresolved_in(source, tree);
  if (roots.kind == UrdfRoots::Kind::kNone) {
    for (const auto& left_out : tree.left_out) refusals.push_back(note_on(source, tree, left_out));
    refusals.push_back(note_on_roots(source, tree));
  }
  if (!refusals.empty()) return result;

  Ledger ledger(source.documents);
  if (options.model.empty()) lose_surroundings(source, ledger, result.model);
  build_robot(source, options, tree, roots, ledger, result);
  result.account = std::move(ledger).close(
      [&source](const model::Site& opened, xml::Element element) {
        return is_implied(source, opened, element);
      },
      [&source](xml::Element element, xml::Attribute attribute) {
        return is_implied(source, element, attribute);
      },
      kind_of);
  return result;
}

}  // namespace rigor::convert
