// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The elements of an MJCF file with its includes in their places, as MuJoCo reads them: each `<include>` is
// replaced by what the root of another file holds, relative to the folder of the main file.
//
//   MjcfTree tree(reader, file, facts);
//   for (xml::Element element : tree.children(root)) ...   // those of included files too

#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/model/field.h>
#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/read/mjcf/mjcf_includes.h>
#include <rigor/read/workspace.h>
#include <rigor/xml/document.h>

namespace rigor::read {

/// Files include files this deep at most; MuJoCo takes each file once, so there are no cycles.
inline constexpr std::size_t kMaxMjcfIncludes = 1000;

/// A name, path or keyword as it is written: MuJoCo takes spaces around it for a part of it.
model::Field<std::string> mjcf_name(xml::Element element, std::string_view attribute);

class MjcfTree {
 public:
  /// `file` has a document with a root. All outlive the tree but `facts`.
  MjcfTree(Workspace& workspace, const File& file, MjcfFacts& facts);

  const File& file() const { return file_; }
  xml::Element root() const { return *file_.document->root(); }
  /// What the parent holds, in order, with includes replaced.
  std::vector<xml::Element> children(xml::Element parent) const;
  /// What an `<include>` is replaced by, includes inside it not replaced; nothing where it leads nowhere.
  std::vector<xml::Element> children_of_include(xml::Element include) const;
  /// The children of all elements of the root with that name: `<asset>` may be there twice.
  std::vector<xml::Element> in_sections(std::string_view name) const;
  const MjcfIncludes& includes() const { return includes_; }
  /// The path of the file that an element is in.
  const std::string& path_of(xml::Element element) const;

 private:
  void follow(xml::Element parent, const File& file, int depth, MjcfFacts& facts);
  void collect(xml::Element parent, std::vector<xml::Element>& list) const;

  Workspace& workspace_;
  const File& file_;
  MjcfIncludes includes_;
  std::set<std::string> taken_;
  std::map<SourceId, const std::string*> paths_;
};

}  // namespace rigor::read
