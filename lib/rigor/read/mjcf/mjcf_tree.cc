// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/mjcf/mjcf_tree.h>

#include <rigor/read/values.h>
#include <rigor/text/path.h>
#include <rigor/xml/fault.h>

namespace rigor::read {

model::Field<std::string> mjcf_name(xml::Element element, std::string_view attribute) {
  const auto text = attribute_text(element, attribute);
  if (!text) return {};
  return {std::string(text->text), text->span, true};
}

MjcfTree::MjcfTree(Workspace& workspace, const File& file, MjcfFacts& facts)
    : workspace_(workspace), file_(file) {
  taken_.insert(normalize_path(file.path));
  paths_.emplace(file.source, &file.path);
  follow(root(), file, 1, facts);
}

/// `depth`: of the parent, in the tree where includes are replaced.
void MjcfTree::follow(xml::Element parent, const File& file, int depth, MjcfFacts& facts) {
  for (const xml::Element child : parent.children()) {
    if (child.name() != "include") {
      follow(child, file, depth + 1, facts);
      continue;
    }
    const auto name = mjcf_name(child, "file");
    if (name.value.empty() || taken_.size() > kMaxMjcfIncludes) {
      const char* why = name.value.empty() ? "has no name" : "is not read: over 1000 are included";
      facts.push_back({MjcfFactKind::kIncludeBroken, name.span, {}, name.value, why});
      continue;
    }
    if (depth > xml::kMaxDepth) {
      const std::string why = "is not read: it is included below more than " +
                              std::to_string(xml::kMaxDepth) + " elements";
      facts.push_back({MjcfFactKind::kIncludeBroken, name.span, {}, name.value, why});
      continue;
    }
    const Disk& disk = workspace_.disk();
    std::string path = join_path(parent_path(file_.path), name.value);
    if (disk.kind(path) != PathKind::kFile) {
      const std::string beside = join_path(parent_path(file.path), name.value);
      if (disk.kind(beside) != PathKind::kFile) {
        facts.push_back({MjcfFactKind::kIncludeMissing, name.span, {}, name.value, path});
        continue;
      }
      path = beside;
    }
    if (!taken_.insert(normalize_path(path)).second) {
      facts.push_back({MjcfFactKind::kIncludeRepeated, name.span, {}, name.value});
      continue;
    }
    const File& inner = workspace_.open(path);
    if (!inner.document || !inner.document->complete() || !inner.document->root()) {
      const std::string why = inner.document ? "is not well-formed XML" : inner.problem;
      facts.push_back({MjcfFactKind::kIncludeBroken, name.span, {}, name.value, why});
      continue;
    }
    includes_.add(child, inner);
    paths_.emplace(inner.source, &inner.path);
    follow(*inner.document->root(), inner, depth, facts);
  }
}

void MjcfTree::collect(xml::Element parent, std::vector<xml::Element>& list) const {
  for (const xml::Element child : parent.children()) {
    if (child.name() != "include") {
      list.push_back(child);
      continue;
    }
    if (const auto root = includes_.root_of(child)) collect(*root, list);
  }
}

std::vector<xml::Element> MjcfTree::children(xml::Element parent) const {
  std::vector<xml::Element> list;
  collect(parent, list);
  return list;
}

std::vector<xml::Element> MjcfTree::children_of_include(xml::Element include) const {
  std::vector<xml::Element> list;
  const auto root = includes_.root_of(include);
  if (!root) return list;
  for (const xml::Element child : root->children()) list.push_back(child);
  return list;
}

std::vector<xml::Element> MjcfTree::in_sections(std::string_view name) const {
  std::vector<xml::Element> list;
  for (const xml::Element section : children(root())) {
    if (section.name() == name) collect(section, list);
  }
  return list;
}

const std::string& MjcfTree::path_of(xml::Element element) const {
  return *paths_.at(element.tag_span().source);
}

}  // namespace rigor::read
