// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xml/document.h>

namespace rigor::xml {

std::string_view Document::decoded(const TextRecord& text) const {
  if (text.decoded != kNone) return decoded_[text.decoded];
  return bytes_.substr(text.begin, text.end - text.begin);
}

std::optional<Element> Document::root() const {
  if (elements_.empty()) return std::nullopt;
  return Element(*this, 0);
}

std::string_view Attribute::name() const {
  const auto& record = document_->attributes_[index_];
  return document_->bytes_.substr(record.name_begin, record.name_end - record.name_begin);
}

std::string_view Attribute::value() const {
  return document_->decoded(document_->attributes_[index_].value);
}

Span Attribute::name_span() const {
  const auto& record = document_->attributes_[index_];
  return document_->span(record.name_begin, record.name_end);
}

Span Attribute::value_span() const {
  const auto& value = document_->attributes_[index_].value;
  return document_->span(value.begin, value.end);
}

Span Attribute::span() const {
  const auto& record = document_->attributes_[index_];
  return document_->span(record.name_begin, record.value.end + 1);
}

bool Attribute::verbatim() const {
  return document_->attributes_[index_].value.decoded == Document::kNone;
}

std::string_view Element::name() const {
  const auto& record = document_->elements_[index_];
  return document_->bytes_.substr(record.begin + 1, record.name_end - record.begin - 1);
}

Span Element::name_span() const {
  const auto& record = document_->elements_[index_];
  return document_->span(record.begin + 1, record.name_end);
}

Span Element::tag_span() const {
  const auto& record = document_->elements_[index_];
  return document_->span(record.begin, record.tag_end);
}

Span Element::span() const {
  const auto& record = document_->elements_[index_];
  return document_->span(record.begin, record.end);
}

std::optional<Element> Element::parent() const {
  const std::uint32_t parent = document_->elements_[index_].parent;
  if (parent == Document::kNone) return std::nullopt;
  return Element(*document_, parent);
}

Range<Element> Element::children() const {
  return {*document_, document_->elements_[index_].first_child, Document::kNone};
}

std::optional<Element> Element::child(std::string_view name) const {
  for (const Element child : children()) {
    if (child.name() == name) return child;
  }
  return std::nullopt;
}

Range<Attribute> Element::attributes() const {
  const auto& record = document_->elements_[index_];
  return {*document_, record.first_attribute, record.attribute_end};
}

std::optional<Attribute> Element::attribute(std::string_view name) const {
  for (const Attribute attribute : attributes()) {
    if (attribute.name() == name) return attribute;
  }
  return std::nullopt;
}

std::string_view Element::text() const {
  return document_->decoded(document_->elements_[index_].text);
}

Span Element::text_span() const {
  const auto& record = document_->elements_[index_];
  if (!record.has_text) return document_->span(record.tag_end, record.tag_end);
  return document_->span(record.text.begin, record.text.end);
}

bool Element::text_verbatim() const {
  return document_->elements_[index_].text.decoded == Document::kNone;
}

Span Element::lost_text() const {
  const auto& record = document_->elements_[index_];
  if (record.lost_begin == record.lost_end) return {};
  return document_->span(record.lost_begin, record.lost_end);
}

bool Element::cut() const { return document_->elements_[index_].cut; }

}  // namespace rigor::xml
