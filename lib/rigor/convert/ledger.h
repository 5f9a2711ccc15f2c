// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The account of a conversion: every element and attribute of the source, and what became of it.
//
// It is opened with the whole source, so it is complete by construction: a conversion takes what it
// converts, notes what it changes, and what no code took is a loss when the account is closed. Nothing
// can vanish unseen.
//
//   Ledger ledger(documents);
//   ledger.open(model.site, "my_robot");
//   ledger.take(link.name);                          // converted
//   ledger.take_all(plugin.site, Outcome::kCarried); // with all that it holds
//   ledger.take(axis.effort, Outcome::kSubstituted); // and tells it:
//   ledger.note({.kind = NoteKind::kEffortStandIn, …});
//   Account account = std::move(ledger).close(implied, implied_attribute, kind_of);
//
// What is taken twice, as by a model that is included twice, has the worse of the two outcomes.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <rigor/convert/note.h>
#include <rigor/model/field.h>
#include <rigor/model/site.h>
#include <rigor/read/documents.h>
#include <rigor/xml/document.h>

namespace rigor::convert {

struct Account {
  /// Elements and attributes by what became of them, indexed by `Outcome`.
  std::array<std::size_t, 6> counts{};
  Notes notes;  ///< in the order of the source's files and bytes
};

class Ledger {
 public:
  explicit Ledger(const read::Documents& documents) : documents_(documents) {}

  /// Everything inside the element, and the element itself, must be accounted for. `subject` is the
  /// element's, for the notes on what stands in it; what was opened before stays as it is.
  void open(const model::Site& site, std::string subject = {});

  /// The element alone: not its attributes, not what it holds.
  void take(const model::Site& site, Outcome outcome = Outcome::kConverted);
  void take(xml::Element element, Outcome outcome = Outcome::kConverted);
  /// The element or attribute whose value stands there; nothing for a span that stands nowhere.
  void take_value(Span value, Outcome outcome = Outcome::kConverted);
  template <class T>
  void take(const model::Field<T>& field, Outcome outcome = Outcome::kConverted) {
    if (field.written) take_value(field.span, outcome);
  }
  /// With its attributes and all that it holds, except what was taken before; gives how many.
  std::size_t take_all(const model::Site& site, Outcome outcome = Outcome::kConverted);
  std::size_t take_all(xml::Element element, Outcome outcome = Outcome::kConverted);

  /// Adds a note. It does not take what it refers to.
  void note(Note note) { notes_.push_back(std::move(note)); }
  /// Takes all of an element as lost and says so: `count` becomes what was not taken before.
  void lose(const model::Site& site, Note note);

  /// Takes all of an element, or one value, as what no reader of the source takes from it, and says so:
  /// `written` says what it is and why.
  void pass_over(xml::Element element, std::string subject, std::string written);
  void pass_over_value(Span value, std::string subject, std::string written);

  /// What no code took: an element or attribute that `implied` says a default of is implied, and so is
  /// an element that holds nothing else. An element that only holds what was taken is converted with
  /// it. Of the rest, the outermost of each subtree is one note with the number of elements and
  /// attributes in it that are lost, of the kind that `kind_of` gives; such a note's `written` is the
  /// path inside the opened element, as "link/@foo".
  using Implied = std::function<bool(const model::Site& opened, xml::Element element)>;
  using ImpliedAttribute = std::function<bool(xml::Element element, xml::Attribute attribute)>;
  using KindOf = std::function<NoteKind(xml::Element element)>;
  Account close(const Implied& implied, const ImpliedAttribute& implied_attribute,
                const KindOf& kind_of) &&;

 private:
  friend class LedgerCloser;

  static constexpr Outcome kUntaken{0xff};

  /// An element or an attribute, named by where its tag or its name begins.
  struct Node {
    std::uint32_t begin = 0;
    std::uint32_t element = 0;    ///< the element itself, or the attribute's
    std::uint32_t attribute = 0;  ///< one more than its place in the sheet's; 0 of the element
    Outcome outcome = kUntaken;
  };
  /// All nodes of a document, in the order of its bytes.
  struct Sheet {
    const xml::Document* document;
    std::vector<Node> nodes;
    std::vector<xml::Attribute> attributes;
    std::vector<std::uint32_t> of_element;  ///< where an element's node is; one more at the end
  };
  struct Opened {
    model::Site site;
    std::string subject;
  };

  Sheet& sheet(SourceId source);
  static void take(Node& node, Outcome outcome);

  const read::Documents& documents_;
  std::vector<std::pair<SourceId, Sheet>> sheets_;  // in the order of their first use: few
  std::vector<Opened> opened_;
  Notes notes_;
};

}  // namespace rigor::convert
