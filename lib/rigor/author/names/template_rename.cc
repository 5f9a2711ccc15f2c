// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/names/template_rename.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include <fmt/core.h>

#include <rigor/author/names/expansion_proof.h>
#include <rigor/read/template/expanded_file.h>
#include <rigor/text/path.h>

namespace rigor::author {
namespace {

bool is_letter_or_digit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// As expressions have names; a macro is an element, too.
std::string template_name_fault(std::string_view name) {
  const bool is_name = !name.empty() && std::all_of(name.begin(), name.end(), is_letter_or_digit) &&
                       !(name[0] >= '0' && name[0] <= '9') && !name.starts_with("__");
  return is_name ? std::string() : "a name has letters, digits and '_', and begins with a letter";
}

class TemplateRenamer {
 public:
  TemplateRenamer(const RenameContext& context, const TemplateName& name, std::string_view new_name)
      : context_(context), name_(name), new_name_(new_name) {}

  Renaming rename(const std::vector<std::string>& templates) {
    for (const std::string& path : templates) take(path);
    if (edits_.empty()) return {{}, "nothing has the name"};
    if (taken_)
      return {{}, fmt::format("a {} is named '{}' already", to_string(name_.kind), new_name_)};
    std::vector<Edit> edits;
    for (const auto& [key, edit] : edits_) edits.push_back(edit);
    if (std::string refused = expansion_fault(context_, users_, edits); !refused.empty())
      return {{}, std::move(refused)};
    std::sort(edits.begin(), edits.end(), [](const Edit& a, const Edit& b) {
      return std::tie(a.span.source, a.span.begin) < std::tie(b.span.source, b.span.begin);
    });
    return {std::move(edits), {}};
  }

 private:
  void take(const std::string& path) {
    const read::File& file = context_.graph.file(path);
    if (!file.expanded) return;
    const auto uses = template_uses(file, context_.sources, name_);
    if (uses.empty()) return;
    users_.push_back(path);
    for (const TemplateUse& use : uses) {
      const std::string written = normalize_path(context_.sources.path(use.where.source));
      edits_.try_emplace({written, use.where.begin}, Edit{use.where, new_name_});
    }
    TemplateName other = name_;
    other.name = new_name_;
    const auto others = template_uses(file, context_.sources, other);
    taken_ = taken_ || !others.empty();
  }

  RenameContext context_;
  TemplateName name_;
  std::string new_name_;
  std::vector<std::string> users_;
  std::map<std::pair<std::string, std::uint32_t>, Edit> edits_;  // by path and offset
  bool taken_ = false;
};

}  // namespace

std::vector<TemplateUse> template_uses(const read::File& file, const Sources& sources,
                                       const TemplateName& name) {
  std::vector<TemplateUse> uses;
  if (!file.expanded) return uses;
  for (const xacro::FileUse& read : file.expanded->expansion().files) {
    if (read.source == kNoSource) continue;
    const xml::Document document = xml::parse_own(sources.bytes(read.source), read.source);
    for (TemplateName& each : template_names(document)) {
      if (!each.same_as(name)) continue;
      const Span also = each.also;
      uses.push_back({each, each.where});
      if (!also.nowhere()) uses.push_back({std::move(each), also});
    }
  }
  return uses;
}

Renaming renamed_in_templates(const RenameContext& context,
                              const std::vector<std::string>& templates, const TemplateName& name,
                              std::string_view new_name) {
  if (std::string fault = template_name_fault(new_name); !fault.empty())
    return {{}, std::move(fault)};
  return TemplateRenamer(context, name, new_name).rename(templates);
}

}  // namespace rigor::author
