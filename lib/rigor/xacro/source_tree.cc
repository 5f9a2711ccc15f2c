// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xacro/source_tree.h>

#include <algorithm>
#include <utility>
#include <vector>

#include <rigor/xacro/expression/text_template.h>
#include <rigor/xacro/value/heap.h>
#include <rigor/xml/decode.h>
#include <rigor/xml/document.h>

namespace rigor::xacro {
namespace {

std::string fault_words(const xml::Fault& fault) {
  using Kind = xml::FaultKind;
  switch (fault.kind) {
    case Kind::kEmpty: return "there is no element";
    case Kind::kUtf16: return "the file is UTF-16";
    case Kind::kBadTag: return "this < starts no tag";
    case Kind::kBadAttribute: return "an attribute has no value in quotes";
    case Kind::kUnclosedValue: return "this quote is not closed";
    case Kind::kUnclosedTag: return "this tag has no >";
    case Kind::kUnclosedMarkup: return "this comment, CDATA section or instruction is not closed";
    case Kind::kMismatchedEnd: return "this end tag does not match the start tag";
    case Kind::kUnexpectedEnd: return "this end tag has no start tag";
    case Kind::kUnclosedElement: return "the file ends within an element";
    case Kind::kTooDeep: return "elements are nested too deep";
    case Kind::kTooMany: return "there are too many attributes or elements";
    case Kind::kDuplicateAttribute: return "this attribute appears twice";
    case Kind::kDeclarationNotFirst: return "the XML declaration is not at the start of the file";
    case Kind::kBadDeclaration: return "the XML declaration is malformed";
    case Kind::kSecondRoot: return "there is a second root element";
    case Kind::kTextOutsideRoot: return "there is text outside of the root element";
    case Kind::kUndefinedEntity: return "this entity is undefined";
    case Kind::kNotUtf8: return "this byte is not UTF-8";
    case Kind::kControlCharacter: return "XML has no such control character";
    case Kind::kUnboundPrefix: return "the namespace prefix '" + fault.detail + "' is undefined";
    case Kind::kHyphensInComment: return "a comment contains --";
    case Kind::kAngleInValue: return "an attribute value contains <";
    case Kind::kNoSpaceBetween: return "there is no space between attributes";
    default: return "the file is refused";
  }
}

class SourceReader {
 public:
  SourceReader(std::string_view bytes, SourceId source, Nodes& nodes, Heap& heap,
               TextTemplates& templates)
      : bytes_(bytes),
        nodes_(nodes),
        heap_(heap),
        templates_(templates),
        document_(xml::parse_own(bytes, source)) {}

  SourceTree run() {
    SourceTree tree;
    for (const xml::Fault& fault : document_.faults()) {
      if (fault.kind != xml::FaultKind::kDoctype)
        tree.faults.push_back({fault.where, fault_words(fault)});
    }
    if (!document_.root()) return tree;
    Node& top = nodes_.emplace_back();
    open_ = &top;
    for (const xml::Token& token : document_.tokens()) take(token);
    tree.document = &top;
    tree.root = top.first_element();
    return tree;
  }

 private:
  Place place(std::size_t begin, std::size_t end, bool verbatim = true) const {
    return {
        {document_.source(), static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)},
        verbatim};
  }

  /// With each line end as one LF; of text outside of markup with references replaced.
  std::string_view decoded(std::string_view raw, bool references) {
    if (!xml::needs_decoding(raw)) return raw;
    if (references) return heap_.keep(xml::decode(raw).text);
    if (raw.find('\r') == std::string_view::npos) return raw;
    std::string text;
    for (std::size_t i = 0; i < raw.size(); ++i) {
      if (raw[i] != '\r') text += raw[i];
      if (raw[i] == '\r' && (i + 1 == raw.size() || raw[i + 1] != '\n')) text += '\n';
    }
    return heap_.keep(text);
  }

  void take_attribute(const xml::Attribute attribute, Node& node) {
    const Span span = attribute.value_span();
    const std::string_view raw = bytes_.substr(span.begin, span.size());
    const std::uint8_t found = attribute.content();
    const std::string_view value =
        (found & (xml::kCodeByte | xml::kLineByte)) == 0 ? raw : flattened(raw);
    // A reference may represent a dollar.
    const bool plain = (found & (xml::kDollarByte | xml::kCodeByte)) == 0 ||
                       value.find('$') == std::string_view::npos;
    node.attributes.push_back({attribute.name(),
                               value,
                               {span, value.size() == raw.size()},
                               {},
                               plain ? TextCode::kPlain : templates_.new_code()});
  }

  /// An attribute's value with references replaced and each line end, each tab as a space.
  std::string_view flattened(std::string_view raw) {
    std::string flat;
    for (std::size_t i = 0; i < raw.size(); ++i) {
      if (raw[i] == '\r' && i + 1 < raw.size() && raw[i + 1] == '\n') continue;
      flat += raw[i] == '\r' || raw[i] == '\n' || raw[i] == '\t' ? ' ' : raw[i];
    }
    return heap_.keep(xml::decode(flat).text);
  }

  void take(const xml::Token& token) {
    const std::string_view raw = bytes_.substr(token.begin, token.end - token.begin);
    switch (token.kind) {
      case xml::TokenKind::kText: return take_text(raw, token.begin, token.content);
      case xml::TokenKind::kCData: return take_cdata(raw, token.begin);
      case xml::TokenKind::kStartTag:
      case xml::TokenKind::kEmptyTag: return take_tag(token);
      case xml::TokenKind::kEndTag:
        if (open_->parent != nullptr) open_ = open_->parent;
        return;
      case xml::TokenKind::kComment:
        return add(NodeKind::kComment, {}, decoded(raw.substr(4, raw.size() - 7), false),
                   place(token.begin + 4, token.end - 3));
      case xml::TokenKind::kInstruction: return take_instruction(raw, token.begin);
      case xml::TokenKind::kDoctype:
        return add(NodeKind::kDoctype, {}, decoded(raw, false), place(token.begin, token.end));
      default: return;
    }
  }

  void take_text(std::string_view raw, std::size_t begin, std::uint8_t content) {
    if (open_->parent == nullptr || raw.empty()) return;  // outside of the root
    const std::string_view text = (content & xml::kCodeByte) == 0 ? raw : decoded(raw, true);
    Node* before = open_->last;
    if (before != nullptr && before->kind == NodeKind::kText) {
      // What an empty CDATA section parted.
      before->text = heap_.keep(std::string(before->text) + std::string(text));
      before->code = TextCode::kUnknown;
      before->where = place(before->where.span.begin, begin + raw.size(), false);
      return;
    }
    add(NodeKind::kText, {}, text, place(begin, begin + raw.size(), text.data() == raw.data()));
    if ((content & xml::kMarkByte) == 0) {
      open_->last->code = TextCode::kBlank;
    } else if ((content & (xml::kCodeByte | xml::kDollarByte)) == 0) {
      open_->last->code = TextCode::kPlain;
    }
  }

  void take_cdata(std::string_view raw, std::size_t begin) {
    const std::string_view inside = raw.substr(9, raw.size() - 12);
    if (!inside.empty())
      add(NodeKind::kCData, {}, decoded(inside, false), place(begin + 9, begin + raw.size() - 3));
  }

  void take_instruction(std::string_view raw, std::size_t begin) {
    const std::string_view inside = raw.substr(2, raw.size() - 4);
    const std::size_t end = std::min(inside.find_first_of(" \t\r\n"), inside.size());
    const std::size_t data = std::min(inside.find_first_not_of(" \t\r\n", end), inside.size());
    add(NodeKind::kInstruction, inside.substr(0, end), decoded(inside.substr(data), false),
        place(begin, begin + raw.size()));
  }

  void take_tag(const xml::Token& token) {
    if (next_element_ >= document_.element_count()) return;
    const xml::Element element = document_.element(next_element_++);
    Node& node = nodes_.emplace_back();
    node.name = element.name();
    node.tag = tag_of(node.name);
    node.where = {element.tag_span(), true};
    node.attributes.reserve(element.attribute_count());
    for (const xml::Attribute attribute : element.attributes()) take_attribute(attribute, node);
    open_->append(node);
    if (token.kind == xml::TokenKind::kStartTag) open_ = &node;
  }

  void add(NodeKind kind, std::string_view name, std::string_view text, Place where) {
    Node& node = nodes_.emplace_back();
    node.kind = kind;
    node.name = name;
    node.text = text;
    node.where = where;
    open_->append(node);
  }

  std::string_view bytes_;
  Nodes& nodes_;
  Heap& heap_;
  TextTemplates& templates_;
  xml::Document document_;
  Node* open_ = nullptr;
  std::uint32_t next_element_ = 0;
};

}  // namespace

SourceTree read_source_tree(std::string_view bytes, SourceId source, Nodes& nodes, Heap& heap,
                            TextTemplates& templates) {
  return SourceReader(bytes, source, nodes, heap, templates).run();
}

}  // namespace rigor::xacro
