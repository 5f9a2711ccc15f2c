// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The scanner: one walk over the bytes, token by token, filling a `Document`.
//
// It follows XML 1.0 (fifth edition) for what a tag is, and tinyxml2 for what a value is. A fatal
// fault ends the walk; the elements open at that place are kept and marked as cut.

#include <algorithm>
#include <array>
#include <utility>

#include <rigor/text/byte_order_mark.h>
#include <rigor/text/sources.h>
#include <rigor/xml/characters.h>
#include <rigor/xml/declaration.h>
#include <rigor/xml/decode.h>
#include <rigor/xml/document.h>
#include <rigor/xml/judge.h>

namespace rigor::xml {
namespace {

/// What a byte may be part of, beside what it is for a value; in a table, since every byte of a tag is asked.
enum ByteClass : std::uint8_t {
  kColonByte = kMarkByte,  // no text asks for this
  kSpaceByte = 16,
  kNameStartByte = 32,
  kNameByte = 64,
  kAngleByte = 128,  ///< a `<`, which no value may hold
};

constexpr std::array<std::uint8_t, 256> kByteClasses = [] {
  std::array<std::uint8_t, 256> classes{};
  for (const char c : {' ', '\n', '\t', '\r'}) classes[static_cast<unsigned char>(c)] = kSpaceByte;
  for (std::size_t c = 0; c < classes.size(); ++c) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (letter || c == '_' || c == ':' || c >= 0x80) classes[c] = kNameStartByte | kNameByte;
    if ((c >= '0' && c <= '9') || c == '-' || c == '.') classes[c] = kNameByte;
  }
  classes[':'] |= kColonByte;
  classes['<'] |= kAngleByte;
  classes['&'] |= kCodeByte;
  classes['\r'] |= kCodeByte;
  for (const char c : {'\n', '\t'}) classes[static_cast<unsigned char>(c)] |= kLineByte;
  classes['$'] |= kDollarByte;
  return classes;
}();

std::uint8_t class_of(char c) { return kByteClasses[static_cast<unsigned char>(c)]; }
bool is_of(char c, ByteClass wanted) { return (class_of(c) & wanted) != 0; }
bool is_space(char c) { return is_of(c, kSpaceByte); }
bool is_name_start(char c) { return is_of(c, kNameStartByte); }
bool is_name(char c) { return is_of(c, kNameByte); }

/// A file uses a handful of prefixes; past this many no more are distinguished.
constexpr std::size_t kMaxPrefixes = 64;

/// How a piece of markup other than a tag opens and closes.
struct Markup {
  std::string_view open;
  std::string_view close;
  TokenKind kind;
};
constexpr std::array<Markup, 3> kMarkup{{{"<!--", "-->", TokenKind::kComment},
                                         {"<![CDATA[", "]]>", TokenKind::kCData},
                                         {"<?", "?>", TokenKind::kInstruction}}};

}  // namespace

class Builder {
 public:
  Builder(std::string_view bytes, SourceId source) : bytes_(bytes) {
    document_.source_ = source;
    last_child_[0] = kNone;
    document_.bytes_ = bytes;
    // Real models have an element every 37 to 60 bytes and a token every 9 to 20.
    document_.elements_.reserve(bytes.size() / 37 + 4);
    document_.attributes_.reserve(bytes.size() / 128 + 4);
    document_.tokens_.reserve(bytes.size() / 9 + 8);
  }

  Document build_judged() {
    walk();
    if (document_.complete_ && doubtful()) ask_the_judge();
    return std::move(document_);
  }

  Document build() {
    walk();
    return std::move(document_);
  }

 private:
  using Record = Document::ElementRecord;
  static constexpr std::uint32_t kNone = Document::kNone;

  void walk() {
    if (is_wide_encoding(bytes_)) {
      fail({FaultKind::kUtf16, span(0, std::min<std::size_t>(bytes_.size(), 2)), {}, {}});
    } else {
      find_bad_characters();
      if (bytes_.starts_with(kByteOrderMark)) {
        token(TokenKind::kByteOrderMark, static_cast<std::uint32_t>(kByteOrderMark.size()));
      }
      while (at_ < bytes_.size() && document_.complete_) step();
      finish();
    }
    if (at_ < bytes_.size()) token(TokenKind::kUnread, static_cast<std::uint32_t>(bytes_.size()));
  }

  Span span(std::size_t begin, std::size_t end) const {
    return {document_.source_, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
  }

  void token(TokenKind kind, std::uint32_t end, std::uint8_t content = 0) {
    document_.tokens_.push_back({kind, content, at_, end});
    at_ = end;
  }

  void note(Fault fault) {
    const auto kind = static_cast<std::size_t>(fault.kind);
    if (kept_[kind].count++ == 0) kept_[kind].first = document_.faults_.size();
    if (kept_[kind].count > max_kept(fault.kind)) {
      document_.faults_[kept_[kind].first].count = kept_[kind].count;
    } else {
      document_.faults_.push_back(std::move(fault));
    }
  }

  void fail(Fault fault) {
    note(std::move(fault));
    document_.complete_ = false;
  }

  void find_bad_characters() {
    for (auto bad = find_bad_character(bytes_, 0); bad;
         bad = find_bad_character(bytes_, bad->end)) {
      note({bad->control ? FaultKind::kControlCharacter : FaultKind::kNotUtf8,
            span(bad->begin, bad->end),
            {},
            {}});
    }
  }

  void step() {
    if (bytes_[at_] != '<') return text();
    const char next = at_ + 1 < bytes_.size() ? bytes_[at_ + 1] : '\0';
    if (is_name_start(next)) return start_tag();
    if (next == '/') return end_tag();
    for (const Markup& markup : kMarkup) {
      if (bytes_.substr(at_).starts_with(markup.open)) return other(markup);
    }
    if (bytes_.substr(at_).starts_with("<!")) return doctype();
    fail({FaultKind::kBadTag, span(at_, at_ + 1), {}, {}});
  }

  void text() {
    std::uint8_t seen = 0;
    std::uint32_t first = at_;
    while (first < bytes_.size() && is_space(bytes_[first])) seen |= class_of(bytes_[first++]);
    std::uint32_t end = first;
    while (end < bytes_.size() && bytes_[end] != '<') seen |= class_of(bytes_[end++]);
    auto content = static_cast<std::uint8_t>(seen & (kCodeByte | kLineByte | kDollarByte));
    if (first < end) {
      content |= kMarkByte;
      if (open_ == kNone) {
        note({FaultKind::kTextOutsideRoot, span(first, without_space(end)), {}, {}});
      } else {
        give_text(at_, end, first, (seen & kCodeByte) != 0 ? Decode::kYes : Decode::kNo);
      }
    }
    token(TokenKind::kText, end, content);
  }

  enum class Decode { kYes, kNo };

  /// Hands characters to the open element: its value, if nothing came before, else lost.
  void give_text(std::uint32_t begin, std::uint32_t end, std::uint32_t first, Decode decode) {
    Record& element = document_.elements_[open_];
    const auto value =
        decode == Decode::kYes ? text_record(begin, end) : Document::TextRecord{begin, end, kNone};
    if (!element.has_text && element.first_child == kNone) {
      element.text = value;
      element.has_text = true;
    } else if (element.lost_begin == element.lost_end) {
      element.lost_begin = first;
      element.lost_end = without_space(end);
    }
  }

  /// The end of text without the white space behind it; the text holds something else.
  std::uint32_t without_space(std::uint32_t end) const {
    while (is_space(bytes_[end - 1])) --end;
    return end;
  }

  /// Decodes once, here, so that values are plain views afterwards.
  Document::TextRecord text_record(std::uint32_t begin, std::uint32_t end) {
    const std::string_view raw = bytes_.substr(begin, end - begin);
    Decoded decoded = decode(raw);
    for (const auto& unknown : decoded.unknown) {
      note({FaultKind::kUndefinedEntity, span(begin + unknown.begin, begin + unknown.end), {}, {}});
    }
    document_.decoded_.push_back(std::make_unique<std::string>(std::move(decoded.text)));
    return {begin, end, static_cast<std::uint32_t>(document_.decoded_.size() - 1)};
  }

  void other(const Markup& markup) {
    const auto inside = static_cast<std::uint32_t>(at_ + markup.open.size());
    const std::size_t close = bytes_.find(markup.close, inside);
    if (close == std::string_view::npos) {
      return fail({FaultKind::kUnclosedMarkup, span(at_, inside), {}, {}});
    }
    const auto end = static_cast<std::uint32_t>(close + markup.close.size());
    TokenKind kind = markup.kind;
    if (kind == TokenKind::kComment) {
      const std::size_t hyphens = bytes_.substr(inside, close - inside + 1).find("--");
      if (hyphens != std::string_view::npos) {
        note({FaultKind::kHyphensInComment, span(inside + hyphens, inside + hyphens + 2), {}, {}});
      }
    } else if (kind == TokenKind::kCData) {
      if (open_ == kNone) {
        note({FaultKind::kTextOutsideRoot, span(at_, end), {}, {}});
      } else {
        give_text(inside, static_cast<std::uint32_t>(close), inside, Decode::kNo);
      }
    } else if (is_declaration(inside)) {
      kind = TokenKind::kDeclaration;
      const std::uint32_t first = bytes_.starts_with(kByteOrderMark) ? 3 : 0;
      if (at_ != first) {
        note({FaultKind::kDeclarationNotFirst, span(at_, end), {}, {}});
      } else if (std::string why = declaration_fault(bytes_.substr(inside + 3, close - inside - 3));
                 !why.empty()) {
        note({FaultKind::kBadDeclaration, span(at_, end), {}, std::move(why)});
      }
    } else {
      has_instruction_ = true;
    }
    token(kind, end);
  }

  bool is_declaration(std::uint32_t inside) const {
    const std::string_view rest = bytes_.substr(inside);
    return rest.starts_with("xml") && (rest.size() == 3 || !is_name(rest[3]));
  }

  void doctype() {
    // An internal subset stands in brackets and may hold `>`.
    std::uint32_t end = at_;
    bool subset = false;
    while (end < bytes_.size() && (subset || bytes_[end] != '>')) {
      if (bytes_[end] == '[') subset = true;
      if (bytes_[end] == ']') subset = false;
      ++end;
    }
    if (end == bytes_.size()) {
      return fail({FaultKind::kUnclosedMarkup, span(at_, at_ + 2), {}, {}});
    }
    note({FaultKind::kDoctype, span(at_, end + 1), {}, {}});
    token(TokenKind::kDoctype, end + 1);
  }

  void start_tag() {
    if (depth_ >= kMaxDepth || document_.elements_.size() >= kMaxElements) {
      const FaultKind kind = depth_ >= kMaxDepth ? FaultKind::kTooDeep : FaultKind::kTooMany;
      return fail({kind, span(at_, name_end(at_ + 1)), {}, {}});
    }
    const std::uint32_t begin = at_;
    has_colon_ = false;
    Record record{};
    record.begin = begin;
    record.name_end = name_end(begin + 1);
    record.parent = open_;
    record.first_attribute = static_cast<std::uint32_t>(document_.attributes_.size());
    std::uint32_t end = record.name_end;
    if (!attributes(end, record)) return;
    const bool empty = bytes_[end] == '/';
    end += empty ? 2 : 1;
    record.tag_end = end;
    record.end = end;
    record.attribute_end = static_cast<std::uint32_t>(document_.attributes_.size());
    open(record);
    if (empty) close(end);
    token(empty ? TokenKind::kEmptyTag : TokenKind::kStartTag, end);
  }

  std::uint32_t name_end(std::uint32_t begin) {
    std::uint32_t end = begin;
    std::uint8_t seen = 0;
    while (end < bytes_.size() && is_name(bytes_[end])) seen |= class_of(bytes_[end++]);
    has_colon_ = has_colon_ || (seen & kColonByte) != 0;
    return end;
  }

  std::uint32_t skip_space(std::uint32_t at) const {
    while (at < bytes_.size() && is_space(bytes_[at])) ++at;
    return at;
  }

  /// Reads attributes from `end` on and leaves `end` at the tag's `>` or `/>`.
  bool attributes(std::uint32_t& end, const Record& record) {
    while (true) {
      const std::uint32_t after_space = skip_space(end);
      const bool spaced = after_space > end;
      end = after_space;
      if (end == bytes_.size()) break;
      if (bytes_[end] == '>' || bytes_.substr(end, 2) == "/>") return true;
      if (!is_name_start(bytes_[end])) break;
      const std::uint32_t begin = end;
      if (!attribute(end, record)) return false;
      if (!spaced) note({FaultKind::kNoSpaceBetween, span(begin, end), {}, {}});
    }
    fail({FaultKind::kUnclosedTag, span(record.begin, record.name_end), {}, {}});
    return false;
  }

  bool attribute(std::uint32_t& at, const Record& record) {
    const std::uint32_t begin = at;
    const std::uint32_t end = name_end(begin);
    at = skip_space(end);
    if (at < bytes_.size() && bytes_[at] == '=') {
      at = skip_space(at + 1);
      if (at < bytes_.size() && (bytes_[at] == '"' || bytes_[at] == '\'')) {
        const std::uint32_t value = at + 1;
        std::uint32_t close = value;
        std::uint8_t seen = 0;
        while (close < bytes_.size() && bytes_[close] != bytes_[at])
          seen |= class_of(bytes_[close++]);
        if (close == bytes_.size()) {
          fail({FaultKind::kUnclosedValue, span(at, at + 1), {}, {}});
          return false;
        }
        at = close + 1;
        return keep_attribute(begin, end, {value, close, kNone}, seen, record);
      }
    }
    fail({FaultKind::kBadAttribute, span(begin, end), {}, {}});
    return false;
  }

  /// With the classes that the bytes of its value are of.
  bool keep_attribute(std::uint32_t begin, std::uint32_t end, Document::TextRecord value,
                      std::uint8_t seen, const Record& record) {
    if (document_.attributes_.size() - record.first_attribute >= kMaxAttributes) {
      fail({FaultKind::kTooMany, span(record.begin, record.name_end), {}, {}});
      return false;
    }
    const std::string_view name = bytes_.substr(begin, end - begin);
    for (std::size_t i = record.first_attribute; i < document_.attributes_.size(); ++i) {
      const auto& other = document_.attributes_[i];
      // Of one length, `ixx` and `ixy` differ in the last letter.
      if (other.name_end - other.name_begin != name.size() ||
          bytes_[other.name_end - 1] != name.back())
        continue;
      if (bytes_.substr(other.name_begin, name.size()) == name) {
        fail({FaultKind::kDuplicateAttribute, span(begin, end),
              span(other.name_begin, other.name_end), std::string(name)});
        return false;
      }
    }
    if ((seen & kAngleByte) != 0) {
      const std::size_t angle = bytes_.find('<', value.begin);
      note({FaultKind::kAngleInValue, span(angle, angle + 1), {}, {}});
    }
    if ((seen & kCodeByte) != 0) value = text_record(value.begin, value.end);
    document_.attributes_.push_back({begin, end, value, seen});
    return true;
  }

  void open(const Record& record) {
    const auto index = static_cast<std::uint32_t>(document_.elements_.size());
    if (open_ == kNone) {
      if (index > 0) {
        const Element first(document_, 0);
        note({FaultKind::kSecondRoot,
              span(record.begin + 1, record.name_end),
              first.name_span(),
              {}});
      }
    } else if (last_child_[static_cast<std::size_t>(depth_)] == kNone) {
      document_.elements_[open_].first_child = index;
    } else {
      document_.elements_[last_child_[static_cast<std::size_t>(depth_)]].next_sibling = index;
    }
    last_child_[static_cast<std::size_t>(depth_)] = index;
    document_.elements_.push_back(record);
    open_ = index;
    ++depth_;
    last_child_[static_cast<std::size_t>(depth_)] = kNone;
    check_prefixes(index);
  }

  void close(std::uint32_t end) {
    document_.elements_[open_].end = end;
    open_ = document_.elements_[open_].parent;
    --depth_;
  }

  void end_tag() {
    const std::uint32_t begin = at_ + 2;
    // Nearly always it is the name that is open, which need not be examined letter by letter.
    const std::string_view wanted =
        open_ == kNone ? std::string_view() : Element(document_, open_).name();
    const std::string_view rest = bytes_.substr(begin);
    const bool matches =
        rest.size() > wanted.size() && rest.starts_with(wanted) && !is_name(rest[wanted.size()]);
    const std::uint32_t end =
        matches ? begin + static_cast<std::uint32_t>(wanted.size()) : name_end(begin);
    const std::uint32_t angle = skip_space(end);
    if (angle == bytes_.size() || bytes_[angle] != '>') {
      return fail({FaultKind::kUnclosedTag, span(at_, end), {}, {}});
    }
    if (open_ == kNone) return fail({FaultKind::kUnexpectedEnd, span(at_, angle + 1), {}, {}});
    if (!matches) {
      const Span open_tag = Element(document_, open_).tag_span();
      return fail({FaultKind::kMismatchedEnd, span(at_, angle + 1), open_tag, {}});
    }
    close(angle + 1);
    token(TokenKind::kEndTag, angle + 1);
  }

  /// Namespaces in XML 1.0: a prefix must be bound by an `xmlns:` attribute. One bound anywhere
  /// before is taken as bound; where it ends is of no use to anybody who writes models.
  void check_prefixes(std::uint32_t index) {
    if (!has_colon_) return;
    const Element element(document_, index);
    for (const Attribute attribute : element.attributes()) {
      const std::string_view name = attribute.name();
      if (name.starts_with("xmlns:") && known_prefixes_.size() < kMaxPrefixes) {
        known_prefixes_.push_back(name.substr(6));
      }
    }
    check_prefix(element.name_span());
    for (const Attribute attribute : element.attributes()) check_prefix(attribute.name_span());
  }

  void check_prefix(Span name_span) {
    const std::string_view name = bytes_.substr(name_span.begin, name_span.size());
    const std::size_t colon = name.find(':');
    if (colon == std::string_view::npos || colon == 0) return;
    const std::string_view prefix = name.substr(0, colon);
    const bool known =
        std::find(known_prefixes_.begin(), known_prefixes_.end(), prefix) != known_prefixes_.end();
    if (known || known_prefixes_.size() >= kMaxPrefixes) return;
    known_prefixes_.push_back(prefix);  // one fault each
    note({FaultKind::kUnboundPrefix,
          span(name_span.begin, name_span.begin + colon),
          {},
          std::string(prefix)});
  }

  void finish() {
    if (document_.complete_ && open_ != kNone) {
      const Element element(document_, open_);
      fail({FaultKind::kUnclosedElement,
            span(bytes_.size(), bytes_.size()),
            element.tag_span(),
            {}});
    }
    if (document_.complete_ && document_.elements_.empty()) {
      fail({FaultKind::kEmpty, span(0, 0), {}, {}});
    }
    for (std::uint32_t index = open_; index != kNone; index = document_.elements_[index].parent) {
      document_.elements_[index].cut = true;
      document_.elements_[index].end = at_;
    }
  }

  /// Whether tinyxml2 may refuse what was read whole. It takes whatever is well-formed, but for an instruction behind
  /// other nodes, which it takes for a declaration.
  bool doubtful() const { return !document_.faults_.empty() || has_instruction_; }

  void ask_the_judge() {
    const std::optional<Refusal> refusal = tinyxml2_refusal(bytes_);
    if (!refusal) return;
    document_.complete_ = false;
    const auto find = [this](FaultKind kind) {
      return std::find_if(document_.faults_.begin(), document_.faults_.end(),
                          [kind](const Fault& fault) { return fault.kind == kind; });
    };
    if (find(FaultKind::kDeclarationNotFirst) != document_.faults_.end()) return;  // says it all
    // Text behind the root is what it refuses though the structure is whole; then that is the place.
    const auto outside = find(FaultKind::kTextOutsideRoot);
    Span where = line_span(refusal->line);
    if (outside != document_.faults_.end()) {
      where = outside->where;
      document_.faults_.erase(outside);
    }
    note({FaultKind::kRefused, where, {}, refusal->reason});
  }

  Span line_span(int number) const {
    const LineTable lines(bytes_);
    const std::string_view line = lines.line(static_cast<std::uint32_t>(std::max(number, 1)));
    if (line.empty()) return span(0, 0);
    const auto begin = static_cast<std::size_t>(line.data() - bytes_.data());
    return span(begin, begin + line.size());
  }

  struct Kept {
    std::uint32_t count = 0;
    std::size_t first = 0;
  };

  std::string_view bytes_;
  Document document_;
  bool has_instruction_ = false;
  bool has_colon_ = false;  // whether a name of the tag at hand has a prefix
  std::uint32_t at_ = 0;
  std::uint32_t open_ = kNone;
  int depth_ = 0;
  std::array<std::uint32_t, kMaxDepth + 1> last_child_;  // by depth, up to the open element's
  std::array<Kept, static_cast<std::size_t>(FaultKind::kNoSpaceBetween) + 1> kept_{};
  std::vector<std::string_view> known_prefixes_{"xml", "xmlns"};
};

Document parse(std::string_view bytes, SourceId source) {
  return Builder(bytes, source).build_judged();
}

Document parse_own(std::string_view bytes, SourceId source) {
  return Builder(bytes, source).build();
}

}  // namespace rigor::xml
