// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/format/child_order.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/author/format/content.h>
#include <rigor/schema/version.h>

namespace rigor::author {
namespace {

/// What is in these is put together by their author.
constexpr std::array<std::string_view, 9> kKeptOrder{
    "sdf", "world", "model", "robot", "gazebo", "plugin", "include", "state", "population"};

bool keeps_order(std::string_view name) {
  return std::find(kKeptOrder.begin(), kKeptOrder.end(), name) != kKeptOrder.end();
}

/// A child with the comments that are about it.
struct Piece {
  std::uint32_t begin;
  std::uint32_t end;
  std::uint32_t rank;
  xml::Element element;
};

class OrderedText {
 public:
  explicit OrderedText(const xml::Document& document)
      : contents_(contents(document)), bytes_(document.bytes()) {}

  std::string text(xml::Element root, std::optional<schema::Node> node) {
    std::string all(bytes_.substr(0, root.span().begin));
    add(root, node, all);
    all += bytes_.substr(root.span().end);
    return all;
  }

 private:
  void add(xml::Element element, const std::optional<schema::Node>& node, std::string& into) {
    const Span span = element.span();
    const bool is_block = contents_[element.index()].kind == ContentKind::kBlock;
    if (!is_block || element.children().empty() || element.name() == "plugin") {
      into += bytes_.substr(span.begin, span.size());
      return;
    }
    std::vector<Piece> pieces = pieces_of(element, node);
    into += bytes_.substr(span.begin, pieces.front().begin - span.begin);
    const std::uint32_t tail = pieces.back().end;
    if (!keeps_order(element.name()) && all_known_) {
      std::stable_sort(pieces.begin(), pieces.end(),
                       [](const Piece& a, const Piece& b) { return a.rank < b.rank; });
    }
    for (const Piece& piece : pieces) {
      const Span child = piece.element.span();
      into += bytes_.substr(piece.begin, child.begin - piece.begin);
      add(piece.element, node ? node->child(piece.element.name()) : std::nullopt, into);
      into += bytes_.substr(child.end, piece.end - child.end);
    }
    into += bytes_.substr(tail, span.end - tail);
  }

  /// Where the comments that stand on the same line as what ends here end.
  std::uint32_t past_comments(std::uint32_t at, std::uint32_t end) const {
    while (true) {
      std::uint32_t next = at;
      while (next < end && (bytes_[next] == ' ' || bytes_[next] == '\t')) ++next;
      if (!bytes_.substr(next, end - next).starts_with("<!--")) return at;
      const std::size_t close = bytes_.find("-->", next + 4);
      if (close == std::string_view::npos || close + 3 > end) return at;
      at = static_cast<std::uint32_t>(close + 3);
    }
  }

  std::vector<Piece> pieces_of(xml::Element element, const std::optional<schema::Node>& node) {
    std::vector<Piece> pieces;
    all_known_ = node.has_value();
    const std::uint32_t last = element.span().end;
    std::uint32_t begin = past_comments(element.tag_span().end, last);
    for (const xml::Element child : element.children()) {
      const std::uint32_t end = past_comments(child.span().end, last);
      const std::optional<std::uint32_t> rank = node ? rank_in(*node, child.name()) : std::nullopt;
      all_known_ = all_known_ && rank;
      pieces.push_back({begin, end, rank.value_or(0), child});
      begin = end;
    }
    return pieces;
  }

  static std::optional<std::uint32_t> rank_in(const schema::Node& node, std::string_view name) {
    std::uint32_t rank = 0;
    for (const schema::Node child : node.children()) {
      if (child.name() == name) return rank;
      ++rank;
    }
    return std::nullopt;
  }

  const std::vector<Content> contents_;
  std::string_view bytes_;
  bool all_known_ = false;  // the children of which pieces were made last
};

std::string_view own_text(xml::Element element) {
  std::string_view text = element.text();
  while (!text.empty() && is_blank(text.substr(0, 1))) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.substr(text.size() - 1))) text.remove_suffix(1);
  return text;
}

bool same_attributes(xml::Element a, xml::Element b) {
  auto one = a.attributes().begin();
  auto other = b.attributes().begin();
  for (; one != a.attributes().end() && other != b.attributes().end(); ++one, ++other) {
    if ((*one).name() != (*other).name() || (*one).value() != (*other).value()) return false;
  }
  return one == a.attributes().end() && other == b.attributes().end();
}

using ChildrenByName = std::map<std::string_view, std::vector<xml::Element>>;

ChildrenByName children_by_name(xml::Element element) {
  ChildrenByName children;
  for (const xml::Element child : element.children()) children[child.name()].push_back(child);
  return children;
}

bool same_tree(xml::Element a, xml::Element b) {
  if (a.name() != b.name() || !same_attributes(a, b) || own_text(a) != own_text(b)) return false;
  const ChildrenByName of_a = children_by_name(a);
  const ChildrenByName of_b = children_by_name(b);
  return std::equal(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                    [](const auto& one, const auto& other) {
                      return one.first == other.first &&
                             std::equal(one.second.begin(), one.second.end(), other.second.begin(),
                                        other.second.end(), same_tree);
                    });
}

std::vector<std::string_view> comments_of(const xml::Document& document) {
  std::vector<std::string_view> comments;
  for (const xml::Token& token : document.tokens()) {
    if (token.kind == xml::TokenKind::kComment)
      comments.push_back(document.bytes().substr(token.begin, token.end - token.begin));
  }
  std::sort(comments.begin(), comments.end());
  return comments;
}

}  // namespace

std::string ChildOrder::ordered(const xml::Document& document) const {
  const auto root = document.root();
  if (!root) return std::string(document.bytes());
  std::optional<schema::Node> node;
  if (root->name() == "sdf") {
    const auto written = root->attribute("version");
    const auto version = schema::parse_version(written ? written->value() : std::string_view());
    node = sdf_.root("sdf", version ? sdf_.nearest(*version) : sdf_.latest());
  } else {
    node = urdf_.root(root->name(), urdf_.latest());
  }
  return OrderedText(document).text(*root, node);
}

bool same_but_for_order(const xml::Document& a, const xml::Document& b) {
  const auto root_a = a.root();
  const auto root_b = b.root();
  return root_a && root_b && a.element_count() == b.element_count() &&
         a.bytes().size() == b.bytes().size() && same_tree(*root_a, *root_b) &&
         comments_of(a) == comments_of(b);
}

}  // namespace rigor::author
