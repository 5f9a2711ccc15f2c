// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <fmt/core.h>

#include <rigor/convert/bullet_urdf.h>
#include <rigor/convert/comments.h>
#include <rigor/convert/sdf/draft.h>
#include <rigor/convert/written_number.h>
#include <rigor/mass/mass_properties.h>
#include <rigor/mass/nearest.h>
#include <rigor/model/subject.h>

namespace rigor::convert {
namespace {

using model::Id;
using model::Link;
using model::Pose;

/// How far the mass of a link without mass lies from its center, m: what turns at all is about so
/// large, and solvers dislike bodies that are nearly points.
constexpr double kNothingGyration = 0.1;

std::array<const model::Field<double>*, 6> tensor_of(const model::Inertial& i) {
  return {&i.ixx, &i.ixy, &i.ixz, &i.iyy, &i.iyz, &i.izz};
}

mass::MassProperties body_of(const model::Inertial& i) {
  return mass::transformed(i.pose.pose.value, {i.mass.value,
                                               {},
                                               {i.ixx.value, i.ixy.value, i.ixz.value, i.iyy.value,
                                                i.iyz.value, i.izz.value}});
}

void take_inertial(const SdfDraft& draft, const model::Inertial& inertial, Outcome outcome) {
  Ledger& ledger = draft.ledger;
  ledger.take(inertial.site, outcome);
  const xml::Element element = draft.source.documents.element(inertial.site);
  if (const auto mass = element.child("mass")) ledger.take(*mass, outcome);
  ledger.take_all(inertial.pose.site, outcome);
  if (inertial.tensor_written) ledger.take(inertial.tensor_site, outcome);
  ledger.take(inertial.mass, outcome);
  for (const auto* entry : tensor_of(inertial)) ledger.take(*entry, outcome);
}

/// An inertia without a mass, which adds to that of what it is fixed to.
bool has_bare_tensor(const Link& link) {
  const auto tensor = tensor_of(link.inertial);
  return link.inertial.tensor_written &&
         std::any_of(tensor.begin(), tensor.end(), [](const auto* e) { return e->value != 0; });
}

/// The pose of a link in one that it hangs on; nothing where it does not.
std::optional<Pose> pose_below(const SdfDraft& draft, Id<Link> id, Id<Link> above) {
  Pose X;
  while (id != above) {
    const SdfNode& node = draft.node(id);
    if (!node.carrier) return std::nullopt;
    X = compose(draft.source.root[node.carrier].pose.pose.value, X);
    id = node.parent;
  }
  return X;
}

UrdfInertial as_written(const SdfDraft& draft, const model::Inertial& inertial) {
  const read::Documents& documents = draft.source.documents;
  UrdfInertial result;
  result.comments = remarks_on(documents, inertial.site, CommentsFor::kSdf);
  result.origin = urdf_written_origin(documents, inertial.pose);
  result.mass = written_number(documents, inertial.mass);
  const auto entries = tensor_of(inertial);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    result.inertia[i] = written_number(documents, *entries[i]);
  }
  return result;
}

/// With six digits, as many as a number has that somebody measured.
Number six_digits(double value) {
  if (value == 0) return {};
  const double scale = std::pow(10, 5 - std::floor(std::log10(std::abs(value))));
  const double rounded = std::round(value * scale) / scale;
  return {std::isfinite(rounded) ? rounded : value, {}};
}

void note_on_inertial(const SdfDraft& draft, NoteKind kind, const Link& link, std::string written,
                      std::string instead) {
  draft.ledger.note({.kind = kind,
                     .outcome = Outcome::kSubstituted,
                     .where = link.inertial.tensor_site.name,
                     .subject = model::subject(draft.source.root, link),
                     .written = std::move(written),
                     .instead = std::move(instead)});
}

std::string moments_text(const std::array<double, 3>& moments) {
  return fmt::format("{:.3g}, {:.3g} and {:.3g}", moments[0], moments[1], moments[2]);
}

/// Where the policy says so, for a tensor that libsdformat rejects.
void make_possible(const SdfDraft& draft, const Link& link, UrdfInertial& inertial) {
  if (draft.options.inertia != InertiaPolicy::kNearest) return;
  const auto& I = inertial.inertia;
  const mass::Inertia tensor{I[0].value, I[1].value, I[2].value,
                             I[3].value, I[4].value, I[5].value};
  if (mass::judge(inertial.mass.value, tensor).possible()) return;
  const auto nearest = mass::nearest_possible(tensor);
  if (!nearest) return;
  inertial.inertia = tensor_entries(*nearest);
  for (Number& number : inertial.inertia) number = six_digits(number.value);
  const bool own = link.inertial.tensor_written;
  draft.ledger.note({.kind = NoteKind::kInertiaNearest,
                     .outcome = Outcome::kSubstituted,
                     .where = own ? link.inertial.tensor_site.name : link.site.name,
                     .subject = model::subject(draft.source.root, link),
                     .written = moments_text(mass::principal_moments(tensor)),
                     .instead = moments_text(mass::principal_moments(*nearest))});
}

}  // namespace

Pose pose_in_holder(const SdfDraft& draft, Id<Link> id) {
  const Id<Link> holder = draft.node(id).holder;
  if (const auto X = pose_below(draft, id, holder)) return *X;
  // A root that became a frame of its subtree.
  const auto X = pose_below(draft, holder, id);
  return X ? inverse(*X) : Pose{};
}

UrdfInertial next_to_nothing(const SdfDraft& draft) {
  const Number moment{draft.next_to_nothing * kNothingGyration * kNothingGyration, {}};
  return {{}, {draft.next_to_nothing, {}}, {moment, Number{}, Number{}, moment, Number{}, moment}};
}

std::optional<UrdfInertial> sdf_inertial(SdfDraft& draft, Id<Link> id) {
  const model::Root& root = draft.source.root;
  std::vector<Id<Link>> held;  // with a mass or an inertia
  for (const Id<Link> link : draft.node(id).held) {
    if (!is_massless(root[link]) || has_bare_tensor(root[link])) held.push_back(link);
  }
  for (const Id<Link> link : held) {
    const std::string missing = missing_entries(root[link].inertial);
    if (!missing.empty()) {
      note_on_inertial(draft, NoteKind::kInertiaIncomplete, root[link], missing, "0");
    }
    if (link != id && is_massless(root[link])) {
      note_on_inertial(draft, NoteKind::kBareInertia, root[link], root[link].name.value,
                       draft.node(id).name);
    }
  }
  if (held.empty()) return std::nullopt;
  if (held.size() == 1 && held[0] == id) {
    take_inertial(draft, root[id].inertial, Outcome::kConverted);
    UrdfInertial inertial = as_written(draft, root[id].inertial);
    make_possible(draft, root[id], inertial);
    return inertial;
  }
  mass::MassProperties sum;
  for (const Id<Link> link : held) {
    take_inertial(draft, root[link].inertial, Outcome::kRewritten);
    sum = mass::add(sum,
                    mass::transformed(pose_in_holder(draft, link), body_of(root[link].inertial)));
  }
  UrdfInertial inertial = inertial_of(sum);
  make_possible(draft, root[id], inertial);
  return inertial;
}

}  // namespace rigor::convert
