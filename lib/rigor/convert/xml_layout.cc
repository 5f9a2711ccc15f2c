// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/xml_layout.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/read/values.h>
#include <rigor/xml/token.h>

namespace rigor::convert {
namespace {

using xml::Token;
using xml::TokenKind;

/// What the elements around it declare of the prefixes that an element uses: `xmlns:gz="…"`, each
/// with a space before it.
std::string inherited_prefixes(const xml::Document& document, xml::Element element) {
  const Span span = element.span();
  const std::string_view content = document.bytes().substr(span.begin, span.size());
  std::vector<std::string_view> known;
  std::string declarations;
  for (auto at = std::optional(element); at; at = at->parent()) {
    for (const xml::Attribute attribute : at->attributes()) {
      const std::string_view name = attribute.name();
      if (!name.starts_with("xmlns:")) continue;
      if (std::find(known.begin(), known.end(), name) != known.end()) continue;
      known.push_back(name);
      const std::string prefix = std::string(name.substr(6)) + ':';
      if (*at == element || content.find(prefix) == std::string_view::npos) continue;
      const Span whole = attribute.span();
      (declarations += ' ') += document.bytes().substr(whole.begin, whole.size());
    }
  }
  return declarations;
}

class XmlLayout {
 public:
  XmlLayout(const xml::Document& document, xml::Element element, const LayoutChanges& changes)
      : document_(document),
        bytes_(document.bytes()),
        end_(element.span().end),
        tag_end_(element.tag_span().end),
        prefixes_(inherited_prefixes(document, element)),
        changes_(changes),
        first_(changes.added) {
    const auto old = element.child("pose");
    if (changes.pose && old) old_pose_ = old->span();
    if (changes.pose && !old) first_.insert(first_.begin(), *changes.pose);
    const auto first = std::lower_bound(
        document.tokens().begin(), document.tokens().end(), element.span().begin,
        [](const Token& token, std::uint32_t begin) { return token.begin < begin; });
    at_ = static_cast<std::size_t>(first - document.tokens().begin());
  }

  std::string lay_out() && {
    while (at_ < document_.tokens().size() && token().begin < end_) next();
    return std::move(out_);
  }

 private:
  const Token& token() const { return document_.tokens()[at_]; }

  void next() {
    if (token().begin == old_pose_.begin && !old_pose_.nowhere()) {
      skip_to(old_pose_.end);
      return line(*changes_.pose);
    }
    for (const Span removed : changes_.removed) {
      if (token().begin == removed.begin) return skip_to(removed.end);
    }
    const Token& here = token();
    const std::string text = changed(here.begin, here.end);
    switch (here.kind) {
      case TokenKind::kStartTag: return start_tag(here);
      case TokenKind::kEmptyTag:
        if (!first_.empty() && here.end == tag_end_) return empty_with_children(text);
        line(tag_text(here));
        break;
      case TokenKind::kEndTag:
        if (depth_ > 0) --depth_;
        line(joined_tag(text));
        break;
      default:
        if (const auto content = read::trimmed(text); !content.empty()) line(content);
        break;
    }
    ++at_;
  }

  void skip_to(std::uint32_t end) {
    while (at_ < document_.tokens().size() && token().begin < end) ++at_;
  }

  void start_tag(const Token& tag) {
    if (const std::size_t last = end_of_leaf();
        last != 0 && (first_.empty() || tag.end != tag_end_)) {
      const std::uint32_t end = document_.tokens()[last].end;
      std::string leaf = tag_text(tag);
      const std::string content = changed(tag.end, document_.tokens()[last].begin);
      // Lines of nothing would be indented anew each time that a file goes there and back.
      const bool empty_lines =
          read::trimmed(content).empty() && content.find('\n') != std::string_view::npos;
      if (!empty_lines) leaf += content;
      leaf += bytes_.substr(document_.tokens()[last].begin, end - document_.tokens()[last].begin);
      line(leaf);
      at_ = last + 1;
      return;
    }
    line(tag_text(tag));
    ++depth_;
    ++at_;
    if (tag.end != tag_end_) return;
    for (const std::string& child : first_) line(child);
  }

  /// The bytes, but for what is replaced in them.
  std::string changed(std::uint32_t begin, std::uint32_t end) const {
    std::vector<const LayoutChanges::Replacement*> here;  // a tag may have several attributes
    for (const auto& one : changes_.replacements) {
      if (one.where.begin >= begin && one.where.end <= end) here.push_back(&one);
    }
    std::sort(here.begin(), here.end(), [](const auto* a, const auto* b) {
      return a->where.begin > b->where.begin;  // from the back, so that places stay
    });
    std::string text(bytes_.substr(begin, end - begin));
    for (const auto* one : here) {
      text.replace(one->where.begin - begin, one->where.size(), one->text);
    }
    return text;
  }

  void empty_with_children(std::string_view text) {
    const std::string tag = joined_tag(text.substr(0, text.size() - 2));
    const std::string name = tag.substr(1, tag.find(' ') - 1);
    line(std::string(read::trimmed(tag)) + prefixes_ + '>');
    ++depth_;
    for (const std::string& child : first_) line(child);
    --depth_;
    line("</" + name + '>');
    ++at_;
  }

  /// The end tag that follows with nothing but text before it; 0 for none.
  std::size_t end_of_leaf() const {
    for (std::size_t i = at_ + 1; i < document_.tokens().size(); ++i) {
      const TokenKind kind = document_.tokens()[i].kind;
      if (kind == TokenKind::kEndTag) return i;
      if (kind != TokenKind::kText && kind != TokenKind::kCData) return 0;
    }
    return 0;
  }

  std::string tag_text(const Token& tag) const {
    std::string text = joined_tag(changed(tag.begin, tag.end));
    if (tag.end == tag_end_) text.insert(text.find_first_of(" />", 1), prefixes_);
    return text;
  }

  /// On one line. White space in an attribute's value counts as spaces, too.
  static std::string joined_tag(std::string_view tag) {
    std::string result;
    for (std::size_t i = 0; i < tag.size(); ++i) {
      if (tag[i] != '\n' && tag[i] != '\r' && tag[i] != '\t') {
        result += tag[i];
        continue;
      }
      while (!result.empty() && result.back() == ' ') result.pop_back();
      result += ' ';
      while (i + 1 < tag.size() && read::trimmed(tag.substr(i + 1, 1)).empty()) ++i;
    }
    return result;
  }

  void line(std::string_view text) {
    out_.append(2 * depth_, ' ');
    std::remove_copy(text.begin(), text.end(), std::back_inserter(out_), '\r');
    out_ += '\n';
  }

  const xml::Document& document_;
  std::string_view bytes_;
  std::uint32_t end_;
  std::uint32_t tag_end_;  // of the element itself
  std::string prefixes_;   // for its tag
  const LayoutChanges& changes_;
  std::vector<std::string> first_;  // children that it has not had
  Span old_pose_;
  std::size_t at_ = 0;
  std::size_t depth_ = 0;
  std::string out_;
};

}  // namespace

std::string laid_out(const xml::Document& document, xml::Element element,
                     const LayoutChanges& changes) {
  return XmlLayout(document, element, changes).lay_out();
}

}  // namespace rigor::convert
