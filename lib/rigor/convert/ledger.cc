// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/ledger.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>

namespace rigor::convert {
namespace {

bool says_nothing(xml::Element element) {
  return element.text().find_first_not_of(" \t\r\n") == std::string_view::npos &&
         element.lost_text().nowhere();
}

/// Models join their names, what stands in them is reported by kind and name, as in `subject.h`.
void append_to_subject(std::string& subject, xml::Element element) {
  const auto name = element.attribute("name");
  if (!name) return;
  if (element.name() == "model") {
    if (!subject.empty()) subject += "::";
  } else {
    if (!subject.empty()) subject += '/';
    subject.append(element.name()).append(" ");
  }
  subject += name->value();
}

}  // namespace

Ledger::Sheet& Ledger::sheet(SourceId source) {
  for (auto& [id, sheet] : sheets_) {
    if (id == source) return sheet;
  }
  Sheet sheet{&documents_.of(source), {}, {}, {}};
  const std::uint32_t count = sheet.document->element_count();
  sheet.nodes.reserve(std::size_t{2} * count);
  sheet.of_element.reserve(std::size_t{1} + count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const xml::Element element = sheet.document->element(i);
    sheet.of_element.push_back(static_cast<std::uint32_t>(sheet.nodes.size()));
    sheet.nodes.push_back({element.span().begin, i});
    for (const xml::Attribute attribute : element.attributes()) {
      sheet.attributes.push_back(attribute);
      sheet.nodes.push_back(
          {attribute.name_span().begin, i, static_cast<std::uint32_t>(sheet.attributes.size())});
    }
  }
  sheet.of_element.push_back(static_cast<std::uint32_t>(sheet.nodes.size()));
  return sheets_.emplace_back(source, std::move(sheet)).second;
}

void Ledger::take(Node& node, Outcome outcome) {
  if (node.outcome == kUntaken || node.outcome < outcome) node.outcome = outcome;
}

void Ledger::open(const model::Site& site, std::string subject) {
  if (site.span.nowhere()) return;
  sheet(site.span.source);
  opened_.push_back({site, std::move(subject)});
}

void Ledger::take(const model::Site& site, Outcome outcome) {
  if (!site.span.nowhere()) take(documents_.element(site), outcome);
}

void Ledger::take(xml::Element element, Outcome outcome) {
  Sheet& all = sheet(element.span().source);
  take(all.nodes[all.of_element[element.index()]], outcome);
}

void Ledger::take_value(Span value, Outcome outcome) {
  if (value.nowhere()) return;
  Sheet& all = sheet(value.source);
  // The last node that begins before the value is the one whose value it is, or, where an element's
  // text follows its attributes, the last of these. An empty text may begin where another node does.
  auto node = std::lower_bound(all.nodes.begin(), all.nodes.end(), value.begin,
                               [](const Node& n, std::uint32_t begin) { return n.begin < begin; });
  if (node == all.nodes.begin()) return;
  --node;
  const xml::Element element = all.document->element(node->element);
  if (element.tag_span().end <= value.begin) {
    take(element, outcome);
  } else {
    take(*node, outcome);
  }
}

std::size_t Ledger::take_all(const model::Site& site, Outcome outcome) {
  return site.span.nowhere() ? 0 : take_all(documents_.element(site), outcome);
}

std::size_t Ledger::take_all(xml::Element element, Outcome outcome) {
  Sheet& all = sheet(element.span().source);
  const std::uint32_t end = element.span().end;
  std::size_t count = 0;
  for (std::size_t i = all.of_element[element.index()];
       i < all.nodes.size() && all.nodes[i].begin < end; ++i) {
    if (all.nodes[i].outcome != kUntaken) continue;
    all.nodes[i].outcome = outcome;
    ++count;
  }
  return count;
}

void Ledger::lose(const model::Site& site, Note lost) {
  lost.outcome = Outcome::kLost;
  lost.count = take_all(site, Outcome::kLost);
  if (lost.where.nowhere()) lost.where = site.name;
  note(std::move(lost));
}

void Ledger::pass_over(xml::Element element, std::string subject, std::string written) {
  const std::size_t count = take_all(element, Outcome::kImplied);
  note({.kind = NoteKind::kIdle,
        .outcome = Outcome::kImplied,
        .where = element.name_span(),
        .subject = std::move(subject),
        .written = std::move(written),
        .instead = {},
        .count = count});
}

void Ledger::pass_over_value(Span value, std::string subject, std::string written) {
  if (value.nowhere()) return;
  take_value(value, Outcome::kImplied);
  note({.kind = NoteKind::kIdle,
        .outcome = Outcome::kImplied,
        .where = value,
        .subject = std::move(subject),
        .written = std::move(written)});
}

/// Settles what no code took, one opened element at a time: from its last node to its first, so that
/// an element comes after all that it holds, then forward to tell what is lost.
class LedgerCloser {
 public:
  LedgerCloser(Ledger& ledger, const Ledger::Implied& implied,
               const Ledger::ImpliedAttribute& implied_attribute, const Ledger::KindOf& kind_of)
      : ledger_(ledger),
        implied_(implied),
        implied_attribute_(implied_attribute),
        kind_of_(kind_of) {}

  Account close() {
    account_.notes = std::move(ledger_.notes_);
    for (auto& [source, sheet] : ledger_.sheets_) {
      held_.assign(sheet.document->element_count(), {});
      for (const Opened* opened : outermost(source)) {
        settle(sheet, opened->site);
        tell(sheet, *opened);
      }
    }
    sort_notes();
    return std::move(account_);
  }

 private:
  using Node = Ledger::Node;
  using Opened = Ledger::Opened;
  using Sheet = Ledger::Sheet;

  /// What the attributes and children of an element came to.
  struct Held {
    Outcome best = Ledger::kUntaken;  ///< of what was taken in it
    bool any_child = false;
    bool any_untaken = false;
  };

  /// The opened elements of a document that stand in no other, in the order of its bytes.
  std::vector<const Opened*> outermost(SourceId source) const {
    std::vector<const Opened*> found;
    for (const Opened& opened : ledger_.opened_) {
      if (opened.site.span.source == source) found.push_back(&opened);
    }
    std::stable_sort(found.begin(), found.end(), [](const Opened* a, const Opened* b) {
      return a->site.span.begin < b->site.span.begin;
    });
    std::vector<const Opened*> kept;
    for (const Opened* opened : found) {
      const bool inside = !kept.empty() && opened->site.span.begin < kept.back()->site.span.end &&
                          opened->site.span.end <= kept.back()->site.span.end;
      if (!inside) kept.push_back(opened);
    }
    return kept;
  }

  static std::size_t first_node(const Sheet& sheet, const model::Site& site) {
    return sheet.of_element[site.element];
  }
  static std::size_t end_node(const Sheet& sheet, const model::Site& site) {
    const auto end =
        std::lower_bound(sheet.nodes.begin(), sheet.nodes.end(), site.span.end,
                         [](const Node& node, std::uint32_t at) { return node.begin < at; });
    return static_cast<std::size_t>(std::distance(sheet.nodes.begin(), end));
  }

  void settle(Sheet& sheet, const model::Site& opened) {
    for (std::size_t i = end_node(sheet, opened); i-- > first_node(sheet, opened);) {
      Node& node = sheet.nodes[i];
      const xml::Element element = sheet.document->element(node.element);
      if (node.attribute == 0) {
        settle_element(node, element, opened);
        continue;
      }
      if (node.outcome == Ledger::kUntaken &&
          implied_attribute_(element, sheet.attributes[node.attribute - 1])) {
        node.outcome = Outcome::kImplied;
      }
      if (node.outcome == Ledger::kUntaken) held_[node.element].any_untaken = true;
    }
  }

  void settle_element(Node& node, xml::Element element, const model::Site& opened) {
    const Held& held = held_[node.element];
    bool taken = node.outcome != Ledger::kUntaken;
    if (!taken && held.best != Ledger::kUntaken && says_nothing(element)) {
      node.outcome = held.best;
      taken = true;
    } else if (!taken && (implied_(opened, element) ||
                          (held.any_child && !held.any_untaken && says_nothing(element)))) {
      node.outcome = Outcome::kImplied;
    }
    const auto parent = element.parent();
    if (!parent) return;
    Held& above = held_[parent->index()];
    above.any_child = true;
    above.any_untaken |= held.any_untaken || node.outcome == Ledger::kUntaken;
    above.best = std::min(above.best, taken ? node.outcome : held.best);
  }

  void tell(Sheet& sheet, const Opened& opened) {
    std::uint32_t lost_end = 0;  // of the subtree that the last note refers to
    const std::size_t end = end_node(sheet, opened.site);
    for (std::size_t i = first_node(sheet, opened.site); i < end; ++i) {
      Node& node = sheet.nodes[i];
      if (node.outcome == Ledger::kUntaken) {
        node.outcome = Outcome::kLost;
        if (node.begin < lost_end) {
          ++account_.notes.back().count;
        } else {
          account_.notes.push_back(lost(sheet, node, opened));
          if (node.attribute == 0) lost_end = sheet.document->element(node.element).span().end;
        }
      }
      ++account_.counts[static_cast<std::size_t>(node.outcome)];
    }
  }

  Note lost(const Sheet& sheet, const Node& node, const Opened& opened) const {
    const xml::Element element = sheet.document->element(node.element);
    Note note{.kind = kind_of_(element), .outcome = Outcome::kLost, .where = element.name_span()};
    std::vector<xml::Element> way{element};  // from the element up to the opened one
    while (way.back().index() != opened.site.element) way.push_back(*way.back().parent());
    note.subject = opened.subject;
    for (auto step = way.rbegin(); step != way.rend(); ++step) {
      const bool outermost = step->index() == opened.site.element;
      if (!outermost || note.subject.empty()) append_to_subject(note.subject, *step);
      if (outermost && way.size() > 1) continue;
      if (!note.written.empty()) note.written += '/';
      note.written += step->name();
    }
    if (node.attribute != 0) {
      const xml::Attribute attribute = sheet.attributes[node.attribute - 1];
      note.where = attribute.span();
      note.written.append("/@").append(attribute.name());
    }
    return note;
  }

  void sort_notes() {
    const auto rank = [this](const Note& note) {
      std::size_t at = 0;
      while (at < ledger_.sheets_.size() && ledger_.sheets_[at].first != note.where.source) ++at;
      return at;
    };
    std::stable_sort(account_.notes.begin(), account_.notes.end(),
                     [&rank](const Note& a, const Note& b) {
                       const std::size_t rank_a = rank(a);
                       const std::size_t rank_b = rank(b);
                       return rank_a != rank_b ? rank_a < rank_b : a.where.begin < b.where.begin;
                     });
  }

  Ledger& ledger_;
  const Ledger::Implied& implied_;
  const Ledger::ImpliedAttribute& implied_attribute_;
  const Ledger::KindOf& kind_of_;
  Account account_;
  std::vector<Held> held_;  // by element of the document at hand
};

Account Ledger::close(const Implied& implied, const ImpliedAttribute& implied_attribute,
                      const KindOf& kind_of) && {
  return LedgerCloser(*this, implied, implied_attribute, kind_of).close();
}

}  // namespace rigor::convert
