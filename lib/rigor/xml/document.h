// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// An XML file as it stands in its bytes: every tag, attribute name, attribute value and text has a
// span, and nothing is lost. Made by one walk over the bytes, without a DOM, so that a damaged file
// is read as far as it goes.
//
// Elements live in one flat array in document order; `Element` is a two-word view. Values are
// decoded (the five entities, character references, line ends) as tinyxml2 decodes them, so that
// rigor reads what consumers read.
//
//   xml::Document document = xml::parse(bytes, source);
//   for (xml::Element link : document.root()->children()) {
//     if (auto name = link.attribute("name")) use(name->value(), name->value_span());
//   }

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/text/span.h>
#include <rigor/xml/fault.h>
#include <rigor/xml/token.h>

namespace rigor::xml {

class Document;
class Element;

/// A view of one attribute; valid as long as its document.
class Attribute {
 public:
  Attribute(const Document& document, std::uint32_t index) : document_(&document), index_(index) {}

  std::string_view name() const;
  std::string_view value() const;  ///< decoded
  Span name_span() const;
  Span value_span() const;  ///< without the quotes
  /// From the name's first byte past the closing quote.
  Span span() const;
  /// Whether `value()` is the file's own bytes, so that an offset in one is an offset in the other.
  bool verbatim() const;
  /// `ContentByte`s among its bytes as they are written.
  std::uint8_t content() const;

 private:
  const Document* document_;
  std::uint32_t index_;
};

/// A forward range over the children of an element, or over its attributes.
template <class View>
class Range {
 public:
  class Iterator {
   public:
    Iterator(const Document* document, std::uint32_t index) : document_(document), index_(index) {}
    View operator*() const { return View(*document_, index_); }
    Iterator& operator++();
    bool operator==(const Iterator& other) const { return index_ == other.index_; }

   private:
    const Document* document_;
    std::uint32_t index_;
  };

  Range(const Document& document, std::uint32_t begin, std::uint32_t end)
      : document_(&document), begin_(begin), end_(end) {}
  Iterator begin() const { return {document_, begin_}; }
  Iterator end() const { return {document_, end_}; }
  bool empty() const { return begin_ == end_; }

 private:
  const Document* document_;
  std::uint32_t begin_;
  std::uint32_t end_;
};

/// A view of one element; valid as long as its document.
class Element {
 public:
  Element(const Document& document, std::uint32_t index) : document_(&document), index_(index) {}

  std::string_view name() const;
  /// The name in the start tag.
  Span name_span() const;
  /// The start tag, angle brackets included.
  Span tag_span() const;
  /// From the start tag's first byte past the end tag's last.
  Span span() const;
  /// Index in document order; the root is 0 unless the file has several.
  std::uint32_t index() const { return index_; }
  bool operator==(const Element&) const = default;

  std::optional<Element> parent() const;
  Range<Element> children() const;
  std::optional<Element> child(std::string_view name) const;  ///< the first of that name
  Range<Attribute> attributes() const;
  std::size_t attribute_count() const;
  std::optional<Attribute> attribute(std::string_view name) const;

  /// The value as a consumer takes it: the first run of text, if nothing but comments stands before
  /// it. Not trimmed. Empty when there is none.
  std::string_view text() const;
  /// Where `text()` stands; where it would stand (an empty span) when there is none.
  Span text_span() const;
  bool text_verbatim() const;
  /// Characters other than white space that `text()` does not hold, as in `5<!-- -->6`, or text
  /// between child elements; nowhere when there are none.
  Span lost_text() const;
  /// Whether a fatal fault cut the file before this element's end.
  bool cut() const;

 private:
  const Document* document_;
  std::uint32_t index_;
};

class Document {
 public:
  SourceId source() const { return source_; }
  std::string_view bytes() const { return bytes_; }

  /// The first element, if there is any.
  std::optional<Element> root() const;
  std::uint32_t element_count() const { return static_cast<std::uint32_t>(elements_.size()); }
  Element element(std::uint32_t index) const { return {*this, index}; }

  /// The innermost element that a byte is part of; nothing outside the root.
  std::optional<Element> element_at(std::uint32_t offset) const;

  const std::vector<Token>& tokens() const { return tokens_; }
  const std::vector<Fault>& faults() const { return faults_; }
  /// False when a fatal fault ended the reading.
  bool complete() const { return complete_; }

 private:
  friend class Attribute;
  friend class Element;
  friend class Range<Element>::Iterator;
  friend class Range<Attribute>::Iterator;
  friend class Builder;

  static constexpr std::uint32_t kNone = 0xffffffffU;

  struct TextRecord {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    std::uint32_t decoded = kNone;  // index in decoded_, when the bytes are not the value
  };
  struct AttributeRecord {
    std::uint32_t name_begin;
    std::uint32_t name_end;
    TextRecord value;
    std::uint8_t content;
  };
  struct ElementRecord {
    std::uint32_t begin;
    std::uint32_t end;
    std::uint32_t tag_end;
    std::uint32_t name_end;
    std::uint32_t parent;
    std::uint32_t first_child = kNone;
    std::uint32_t next_sibling = kNone;
    std::uint32_t first_attribute;
    std::uint32_t attribute_end;
    TextRecord text;
    std::uint32_t lost_begin = 0;
    std::uint32_t lost_end = 0;
    bool has_text = false;
    bool cut = false;
  };

  std::string_view decoded(const TextRecord& text) const;
  std::string_view between(std::uint32_t begin, std::uint32_t end) const {
    return {bytes_.data() + begin, end - begin};
  }
  Span span(std::uint32_t begin, std::uint32_t end) const { return {source_, begin, end}; }

  SourceId source_ = kNoSource;
  std::string_view bytes_;
  std::vector<Token> tokens_;
  std::vector<ElementRecord> elements_;
  std::vector<AttributeRecord> attributes_;
  std::vector<std::unique_ptr<std::string>> decoded_;  ///< few, and each stays where it is
  std::vector<Fault> faults_;
  bool complete_ = true;
};

template <>
inline Range<Element>::Iterator& Range<Element>::Iterator::operator++() {
  index_ = document_->elements_[index_].next_sibling;
  return *this;
}

template <>
inline Range<Attribute>::Iterator& Range<Attribute>::Iterator::operator++() {
  ++index_;
  return *this;
}

// One load each: a linter asks them for every element of every file.

/// Most names that are equally long begin with another letter.
inline bool same_name(std::string_view written, std::string_view name) {
  return written.size() == name.size() && (name.empty() || written.front() == name.front()) &&
         written == name;
}

inline std::string_view Document::decoded(const TextRecord& text) const {
  if (text.decoded != kNone) return *decoded_[text.decoded];
  return between(text.begin, text.end);
}

inline std::optional<Element> Document::root() const {
  if (elements_.empty()) return std::nullopt;
  return Element(*this, 0);
}

inline std::string_view Attribute::name() const {
  const auto& record = document_->attributes_[index_];
  return document_->between(record.name_begin, record.name_end);
}

inline std::string_view Attribute::value() const {
  return document_->decoded(document_->attributes_[index_].value);
}

inline Span Attribute::name_span() const {
  const auto& record = document_->attributes_[index_];
  return document_->span(record.name_begin, record.name_end);
}

inline Span Attribute::value_span() const {
  const auto& value = document_->attributes_[index_].value;
  return document_->span(value.begin, value.end);
}

inline Span Attribute::span() const {
  const auto& record = document_->attributes_[index_];
  return document_->span(record.name_begin, record.value.end + 1);
}

inline bool Attribute::verbatim() const {
  return document_->attributes_[index_].value.decoded == Document::kNone;
}

inline std::uint8_t Attribute::content() const { return document_->attributes_[index_].content; }

inline std::string_view Element::name() const {
  const auto& record = document_->elements_[index_];
  return document_->between(record.begin + 1, record.name_end);
}

inline Span Element::name_span() const {
  const auto& record = document_->elements_[index_];
  return document_->span(record.begin + 1, record.name_end);
}

inline Span Element::tag_span() const {
  const auto& record = document_->elements_[index_];
  return document_->span(record.begin, record.tag_end);
}

inline Span Element::span() const {
  const auto& record = document_->elements_[index_];
  return document_->span(record.begin, record.end);
}

inline std::optional<Element> Element::parent() const {
  const std::uint32_t parent = document_->elements_[index_].parent;
  if (parent == Document::kNone) return std::nullopt;
  return Element(*document_, parent);
}

inline Range<Element> Element::children() const {
  return {*document_, document_->elements_[index_].first_child, Document::kNone};
}

inline std::optional<Element> Element::child(std::string_view name) const {
  for (const Element child : children()) {
    if (same_name(child.name(), name)) return child;
  }
  return std::nullopt;
}

inline Range<Attribute> Element::attributes() const {
  const auto& record = document_->elements_[index_];
  return {*document_, record.first_attribute, record.attribute_end};
}

inline std::size_t Element::attribute_count() const {
  const auto& record = document_->elements_[index_];
  return record.attribute_end - record.first_attribute;
}

inline std::optional<Attribute> Element::attribute(std::string_view name) const {
  for (const Attribute attribute : attributes()) {
    if (same_name(attribute.name(), name)) return attribute;
  }
  return std::nullopt;
}

inline std::string_view Element::text() const {
  return document_->decoded(document_->elements_[index_].text);
}

inline Span Element::text_span() const {
  const auto& record = document_->elements_[index_];
  if (!record.has_text) return document_->span(record.tag_end, record.tag_end);
  return document_->span(record.text.begin, record.text.end);
}

inline bool Element::text_verbatim() const {
  return document_->elements_[index_].text.decoded == Document::kNone;
}

inline Span Element::lost_text() const {
  const auto& record = document_->elements_[index_];
  if (record.lost_begin == record.lost_end) return {};
  return document_->span(record.lost_begin, record.lost_end);
}

inline bool Element::cut() const { return document_->elements_[index_].cut; }

/// Reads `bytes`, which must outlive the document. Never fails: what is wrong stands in `faults()`, and whether tinyxml2
/// refuses the file, which is asked where the scanner cannot tell.
Document parse(std::string_view bytes, SourceId source);

/// The same for what rigor wrote itself: tinyxml2 is not asked whether it is well-formed.
Document parse_own(std::string_view bytes, SourceId source);

}  // namespace rigor::xml
