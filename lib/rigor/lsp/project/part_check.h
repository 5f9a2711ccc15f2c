// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a key changes in a large document, found in the part that it is typed in: a check of all of it takes longer
// than a person should wait for each key, and follows when nobody types.
//
//   std::optional<PartCheck> parts = PartCheck::of(path, text);
//   parts->take(std::move(whole));                          // the check of all of that text
//   if (auto checked = parts->check(disk, project, later_text)) publish(*checked);
//
// Findings elsewhere are those of the check of the whole, moved. In the part, those of rules that look at an element
// and what is in it are new: XML, schema, inertia, geometry, physics, sensors, plugins. What other rules found in it
// stays while its bytes are as they were.
//
// A template has no parts, since a key may change anything in the model that it makes. Of one that reads much, what
// expanding it shows is new, and what was found in the model stays where it moved to.

#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <rigor/lsp/document/excerpt.h>
#include <rigor/lsp/document/text_difference.h>
#include <rigor/lsp/project/check.h>
#include <rigor/xml/document.h>

namespace rigor::lsp {

class PartCheck {
 public:
  /// Documents of at least so many bytes are worth it: a check of this size takes 5 ms. Of a template all that it
  /// reads counts.
  static constexpr std::size_t kLargeBytes = std::size_t{64} << 10U;
  static bool is_worth_it(const std::string& path, const std::string& text,
                          const CheckedDocument& checked, std::size_t large = kLargeBytes);

  /// Nothing of a text that is not well-formed.
  static std::optional<PartCheck> of(const std::string& path, const std::string& text);

  /// The check of all of the text, with meshes unopened.
  void take(CheckedDocument whole) { whole_ = std::move(whole); }

  /// Of what the text has become since. Nothing when the change is not within one part: then the whole is to be
  /// checked.
  std::optional<CheckedDocument> check(const EditorDisk& disk, const Project& project,
                                       const std::string& text);

 private:
  /// What is found in the part alone, as it was when the whole was checked.
  struct Before {
    Excerpt excerpt;
    std::set<std::string_view> partial;  ///< rules that find something else in the part alone
  };

  PartCheck(std::string path, std::string text);

  std::optional<CheckedDocument> check_expansion(const EditorDisk& disk, const Project& project,
                                                 const std::string& text, const TextChange& change);
  const Before& before(const Excerpt& excerpt, const EditorDisk& disk, const Project& project);

  std::string path_;
  std::unique_ptr<const std::string> text_;  // which the document is a view of
  xml::Document document_;
  CheckedDocument whole_;
  std::optional<Before> before_;
};

}  // namespace rigor::lsp
