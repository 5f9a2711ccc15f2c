// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/block.h>

#include <numbers>
#include <utility>

#include <rigor/author/verbs/draft.h>
#include <rigor/write/numbers.h>
#include <rigor/xml/style.h>

namespace rigor::author {

std::optional<std::uint32_t> end_of_content(const xml::Document& document, xml::Element element) {
  const Span span = element.span();
  const std::string_view bytes = document.bytes();
  if (xml::is_empty_tag(document, element)) return std::nullopt;
  const auto at = static_cast<std::uint32_t>(bytes.rfind("</", span.end - 1));
  std::uint32_t line = at;
  while (line > span.begin && xml::kBlanks.find(bytes[line - 1]) != std::string_view::npos) --line;
  return bytes[line - 1] == '\n' ? line : at;
}

std::string part_after(const xml::Document& document, std::uint32_t begin, std::uint32_t end,
                       std::vector<Edit> edits) {
  std::erase_if(edits,
                [&](const Edit& edit) { return edit.span.begin < begin || edit.span.end > end; });
  for (Edit& edit : edits) {
    edit.span.begin -= begin;
    edit.span.end -= begin;
  }
  return apply_edits(document.bytes().substr(begin, end - begin), std::move(edits)).value_or("");
}

std::optional<Edit> block_at_end(const xml::Document& document, xml::Element holder,
                                 std::string text) {
  const auto at = end_of_content(document, holder);
  if (!at) return std::nullopt;
  const std::string line(xml::line_end(document, *at));
  if (document.bytes()[*at - 1] != '\n') text.insert(0, line);
  return Edit{{document.source(), *at, *at}, text + line};
}

std::optional<Edit> block_in_template(const EditedModel& edited, std::string text) {
  const read::ExpandedFile* expanded = edited.loaded.file->expanded.get();
  const xml::Element root = edited.element(edited.root()[edited.model].site);
  if (expanded == nullptr) return std::nullopt;
  const Span tag = expanded->origin(edited.document(), root.name_span(), edited.sources).where;
  if (tag.nowhere()) return std::nullopt;
  const xml::Document written = xml::parse_own(edited.sources.bytes(tag.source), tag.source);
  if (!written.complete() || !written.root() || !written.root()->attribute("xmlns:xacro"))
    return std::nullopt;
  return block_at_end(written, *written.root(), std::move(text));
}

std::string child_indentation(const xml::Document& document, xml::Element holder) {
  for (const xml::Element child : holder.children()) {
    if (xml::stands_first(document, child)) return xml::indentation(document, child);
  }
  return xml::indentation(document, holder) + xml::indent_unit(document, holder);
}

std::optional<xml::Element> last_child_of(xml::Element element) {
  std::optional<xml::Element> last;
  for (const xml::Element child : element.children()) last = child;
  return last;
}

std::string trimmed_lines(std::string text) {
  text.erase(text.find_last_not_of(write::kSpace) + 1);
  const std::size_t first = text.find_first_not_of(write::kSpace);
  if (first == std::string::npos) return {};
  const std::size_t line = text.rfind('\n', first);
  return line == std::string::npos ? text : text.substr(line + 1);
}

std::string xyz_text(const model::Pose& X) {
  const double size = length(X.translation);
  const auto number = [size](double value) { return write::settled(value, 0, size); };
  return write::joined({number(X.translation.x), number(X.translation.y), number(X.translation.z)});
}

std::string rpy_text(const model::Pose& X) {
  const model::Vector3 rpy = to_rpy(X.rotation);
  const auto number = [](double value) { return write::settled(value, 0, std::numbers::pi); };
  return write::joined({number(rpy.x), number(rpy.y), number(rpy.z)});
}

}  // namespace rigor::author
