// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/comments.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/read/values.h>
#include <rigor/xml/document.h>
#include <rigor/xml/token.h>

namespace rigor::convert {
namespace {

using xml::Token;
using xml::TokenKind;

bool is_part_of_link(std::string_view name) {
  return name == "inertial" || name == "visual" || name == "collision";
}

/// What is carried as it stands, with the comments in it.
bool is_carried_whole(std::string_view name) {
  return name == "sensor" || name == "plugin" || name == "light" || name == "gazebo";
}

/// The first lines of author/conversion.cc.
bool is_own_head(std::string_view comment) {
  return comment.starts_with("Converted from ") &&
         comment.find(" by rigor.") != std::string_view::npos;
}

class CommentFinder {
 public:
  CommentFinder(const xml::Document& document, xml::Element element, CommentsFor target)
      : document_(document), tokens_(document.tokens()), element_(element), target_(target) {
    const auto first =
        std::lower_bound(tokens_.begin(), tokens_.end(), element.span().begin,
                         [](const Token& token, std::uint32_t at) { return token.begin < at; });
    tag_ = static_cast<std::size_t>(first - tokens_.begin());
  }

  Remarks find() && {
    find_before();
    if (tag_ < tokens_.size()) find_inside();
    return std::move(found_);
  }

  Remarks before() && {
    find_before();
    return std::move(found_);
  }

 private:
  std::string_view bytes(std::size_t i) const {
    return document_.bytes().substr(tokens_[i].begin, tokens_[i].end - tokens_[i].begin);
  }
  bool is_blank(std::size_t i) const {
    return tokens_[i].kind == TokenKind::kText && read::trimmed(bytes(i)).empty();
  }
  bool has_own_line(std::size_t comment) const {
    if (comment == 0) return true;
    const std::size_t before = comment - 1;
    return tokens_[before].kind == TokenKind::kByteOrderMark ||
           (tokens_[before].kind == TokenKind::kText &&
            bytes(before).find('\n') != std::string_view::npos);
  }

  /// Without `<!--` and `-->`, which a comment that the file's end has cut lacks.
  void add(std::size_t comment, std::vector<std::string> places) {
    constexpr std::size_t kOpen = 4, kClose = 3;
    const std::string_view text = bytes(comment);
    if (text.size() < kOpen + kClose) return;
    found_.push_back(
        {std::string(text.substr(kOpen, text.size() - kOpen - kClose)), std::move(places)});
  }

  void find_before() {
    for (std::size_t i = tag_; i-- > 0;) {
      if (is_blank(i)) continue;
      if (tokens_[i].kind != TokenKind::kComment || !has_own_line(i)) break;
      add(i, {});
    }
    std::reverse(found_.begin(), found_.end());
  }

  /// Element by element, as their tags come.
  void find_inside() {
    const std::uint32_t end = element_.span().end;
    std::uint32_t next = element_.index();
    std::vector<xml::Element> open;
    Places last;                       // what a comment on the same line speaks of
    std::vector<std::size_t> waiting;  // comments for what follows
    std::size_t i = tag_;
    for (; i < tokens_.size() && tokens_[i].begin < end; ++i) {
      const TokenKind kind = tokens_[i].kind;
      if (kind == TokenKind::kStartTag || kind == TokenKind::kEmptyTag) {
        if (next == document_.element_count()) break;
        const xml::Element one = document_.element(next++);
        const bool own = one != element_ && is_part_of_link(one.name());
        last = own ? Places{true, {}} : Places{false, places_of(one, open)};
        settle(waiting, last);
        if (own || (one != element_ && is_carried_whole(one.name()))) {
          i = skip(i, one.span().end);
          while (next < document_.element_count() &&
                 document_.element(next).span().begin < one.span().end) {
            ++next;
          }
        } else if (kind == TokenKind::kStartTag) {
          open.push_back(one);
        }
      } else if (kind == TokenKind::kEndTag && !open.empty()) {
        const xml::Element one = open.back();
        open.pop_back();
        last = {false, places_of(one, open)};
        settle(waiting, one == element_ ? Places{false, {std::string(kAtEnd)}} : last);
      } else if (kind == TokenKind::kComment) {
        if (has_own_line(i)) {
          waiting.push_back(i);
        } else if (!last.of_part) {
          add(i, last.names);
        }
      }
    }
    // On the line where it ends.
    for (; i < tokens_.size(); ++i) {
      if (tokens_[i].kind == TokenKind::kComment && !has_own_line(i)) {
        add(i, {});
      } else if (!is_blank(i) || bytes(i).find('\n') != std::string_view::npos) {
        break;
      }
    }
  }

  struct Places {
    bool of_part = false;  ///< which finds its comments itself
    std::vector<std::string> names;
  };

  void settle(std::vector<std::size_t>& waiting, const Places& places) {
    for (const std::size_t comment : waiting) {
      if (!places.of_part) add(comment, places.names);
    }
    waiting.clear();
  }

  /// The last token that begins before `end`.
  std::size_t skip(std::size_t i, std::uint32_t end) const {
    while (i + 1 < tokens_.size() && tokens_[i + 1].begin < end) ++i;
    return i;
  }

  /// Innermost first, without the element itself.
  std::vector<std::string> places_of(xml::Element one,
                                     const std::vector<xml::Element>& around) const {
    std::vector<std::string> names;
    if (one == element_) return names;
    names.push_back(in_target(one.name()));
    for (std::size_t n = around.size(); n-- > 1;) names.push_back(in_target(around[n].name()));
    return names;
  }

  std::string in_target(std::string_view name) const {
    if (target_ == CommentsFor::kUrdf && name == "pose") return "origin";
    if (target_ == CommentsFor::kSdf && name == "origin") return "pose";
    return std::string(name);
  }

  const xml::Document& document_;
  const std::vector<Token>& tokens_;
  const xml::Element element_;
  const CommentsFor target_;
  std::size_t tag_ = 0;
  Remarks found_;
};

}  // namespace

Remarks remarks_on(const read::Documents& documents, const model::Site& site, CommentsFor target) {
  if (site.span.nowhere()) return {};
  const xml::Document& document = documents.of(site.span.source);
  return CommentFinder(document, documents.element(site), target).find();
}

Remarks remarks_on_file(const xml::Document& document) {
  const auto root = document.root();
  if (!root) return {};
  Remarks remarks = CommentFinder(document, *root, CommentsFor::kUrdf).before();
  std::erase_if(remarks,
                [](const Remark& remark) { return is_own_head(read::trimmed(remark.text)); });
  return remarks;
}

}  // namespace rigor::convert
