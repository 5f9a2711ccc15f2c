// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/suppression/suppression_comment.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <utility>

#include <rigor/read/values.h>

namespace rigor::rules {
namespace {

using Kind = SuppressionFactKind;

constexpr std::string_view kSuppressionOpen = "<!--";
constexpr std::string_view kSuppressionClose = "-->";
constexpr std::string_view kSuppressionSpace = " \t\r\n";
constexpr std::array<std::string_view, 3> kSuppressionForms{"ignore", "ignore-next", "file-ignore"};

/// What people write who mean every rule.
bool names_every_rule(std::string_view name) { return name == "all" || name == "*"; }

class SuppressionReader {
 public:
  SuppressionReader(const xml::Document& document, std::string_view inside)
      : document_(document), inside_(inside) {}

  SuppressionComment read(std::string_view said) {
    const std::string_view word =
        said.substr(0, std::min(said.find_first_of(" \t\r\n["), said.size()));
    comment_.word = span(word);
    const auto form = std::find(kSuppressionForms.begin(), kSuppressionForms.end(), word);
    if (form == kSuppressionForms.end()) {
      wrong(Kind::kMalformed, word.empty() ? inside_ : word, word);
      return std::move(comment_);
    }
    comment_.form = static_cast<SuppressionForm>(form - kSuppressionForms.begin());
    const std::string_view rest = read::trimmed(said.substr(word.size()));
    if (!rest.starts_with('[')) {
      wrong(Kind::kNoNames, word, word);
    } else if (const std::size_t end = rest.find(']'); end == std::string_view::npos) {
      wrong(Kind::kUnclosedList, rest.substr(0, 1), word);
    } else {
      names(rest.substr(1, end - 1));
      if (comment_.names.empty() && comment_.faults.empty()) wrong(Kind::kNoNames, word, word);
    }
    return std::move(comment_);
  }

 private:
  void names(std::string_view list) {
    while (!list.empty()) {
      const std::size_t comma = std::min(list.find(','), list.size());
      const std::string_view name = read::trimmed(list.substr(0, comma));
      list.remove_prefix(std::min(comma + 1, list.size()));
      if (names_every_rule(name)) {
        wrong(Kind::kEveryRule, name, name);
      } else if (!name.empty()) {
        comment_.names.push_back(span(name));
      }
    }
  }

  void wrong(Kind kind, std::string_view where, std::string_view name) {
    comment_.faults.push_back({kind, span(where), std::string(name), {}});
  }

  Span span(std::string_view part) const {
    const auto begin = static_cast<std::uint32_t>(part.data() - document_.bytes().data());
    return {document_.source(), begin, begin + static_cast<std::uint32_t>(part.size())};
  }

  const xml::Document& document_;
  std::string_view inside_;  // the comment without its ends and the white space there
  SuppressionComment comment_;
};

}  // namespace

std::vector<std::string_view> suppression_forms() {
  return {kSuppressionForms.begin(), kSuppressionForms.end()};
}

std::optional<SuppressionComment> read_suppression(const xml::Document& document,
                                                   const xml::Token& comment) {
  const std::size_t ends = kSuppressionOpen.size() + kSuppressionClose.size();
  const std::string_view inside = read::trimmed(document.bytes().substr(
      comment.begin + kSuppressionOpen.size(), comment.end - comment.begin - ends));
  if (!inside.starts_with(kSuppressionMark)) return std::nullopt;
  const std::string_view rest = inside.substr(kSuppressionMark.size());
  const std::size_t word = std::min(rest.find_first_not_of(kSuppressionSpace), rest.size());
  return SuppressionReader(document, inside).read(rest.substr(word));
}

}  // namespace rigor::rules
