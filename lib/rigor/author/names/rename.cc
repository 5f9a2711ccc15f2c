// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/names/rename.h>

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include <fmt/core.h>

#include <rigor/author/names/parameter_names.h>
#include <rigor/read/template/expanded_file.h>
#include <rigor/read/template/template_expander.h>
#include <rigor/text/path.h>

namespace rigor::author {
namespace {

std::string place_of(const Sources& sources, Span where) {
  return fmt::format("{}:{}", sources.path(where.source),
                     sources.position(where.source, where.begin).line);
}

bool before(const Edit& a, const Edit& b) {
  return std::tie(a.span.source, a.span.begin) < std::tie(b.span.source, b.span.begin);
}

/// Files of parameters are written by people; what is larger is data.
constexpr std::uint64_t kMaxParameterBytes = std::uint64_t{1} << 20U;

/// Renames in one file after another; `refused` ends it.
class Renamer {
 public:
  Renamer(const RenameContext& context, const std::map<EntityId, std::string>& names)
      : context_(context), targets_(names) {}

  Renaming rename(std::vector<std::string> files) {
    const std::map<EntityId, std::string> asked = targets_;
    for (const auto& [target, name] : asked) files.push_back(target.path);
    for (std::string& file : files) file = normalize_path(file);
    std::sort(files.begin(), files.end());
    files.erase(std::unique(files.begin(), files.end()), files.end());
    const auto models =
        std::stable_partition(files.begin(), files.end(),
                              [](const std::string& file) { return !parameter_format(file); });
    const std::vector<std::string> parameters(models, files.end());
    files.erase(models, files.end());
    for (std::size_t known = 0; known != targets_.size() && refused_.empty();) {
      known = targets_.size();
      for (const std::string& file : files) rename_in(file);
    }
    for (const auto& [path, edits] : expanded_edits_) prove(path, edits);
    if (!refused_.empty()) return {{}, refused_};
    for (const auto& [target, name] : asked) {
      if (parameters.empty()) break;
      const bool is_only = is_only_one(context_.graph.entity(target), files);
      for (const std::string& file : parameters)
        rename_parameters(context_.graph.entity(target), name, file, is_only);
    }
    std::vector<Edit> edits;
    for (const auto& [key, edit] : edits_) edits.push_back(edit);
    std::sort(edits.begin(), edits.end(), before);
    return {std::move(edits), {}, std::move(suspected_)};
  }

 private:
  using SpanKey =
      std::tuple<std::string, std::uint32_t, std::uint32_t>;  // by path: sources may be read twice

  SpanKey key_of(Span span) const {
    return {normalize_path(context_.sources.path(span.source)), span.begin, span.end};
  }

  void rename_in(const std::string& path) {
    const read::File& file = context_.graph.file(path);
    if (!file.document) return;
    for (const NameUse& use : context_.graph.uses(path)) {
      if (file.expanded && use.defines) take_shared(file, use);
      const auto target = targets_.find(use.target);
      if (target == targets_.end()) continue;
      if (!file.expanded) {
        add(use.where, target->second);
      } else {
        rename_expanded(path, file, use, target->second);
      }
    }
  }

  /// A definition in a file of macros that another robot uses, too.
  void take_shared(const read::File& file, const NameUse& use) {
    const read::Origin origin = file.expanded->origin(*file.document, use.where, context_.sources);
    if (!origin.literal) return;
    const auto edit = edits_.find(key_of(origin.where));
    if (edit != edits_.end()) targets_.try_emplace(use.target, edit->second.text);
  }

  void rename_expanded(const std::string& path, const read::File& file, const NameUse& use,
                       const std::string& name) {
    const read::Origin origin = file.expanded->origin(*file.document, use.where, context_.sources);
    const auto reads_so = [&](Span span) {
      return !span.nowhere() && context_.sources.bytes(span) == context_.sources.bytes(use.where);
    };
    if (origin.literal && reads_so(origin.where)) {
      add(origin.where, name);
    } else if (reads_so(origin.from)) {
      add(origin.from, name);
    } else if (refused_.empty()) {
      refused_ = fmt::format("an expression composes the name at {}",
                             place_of(context_.sources, origin.where));
    }
    auto& edits = expanded_edits_[path];
    const Edit edit{use.where, name};
    if (std::find(edits.begin(), edits.end(), edit) == edits.end()) edits.push_back(edit);
  }

  void add(Span where, const std::string& name) {
    edits_.try_emplace(key_of(where), Edit{where, name});
  }

  /// Whether no model of the files has something else of that kind and name.
  bool is_only_one(const NamedEntity& target, const std::vector<std::string>& files) {
    for (const std::string& file : files) {
      const std::vector<NamedEntity>& entities = context_.graph.names(file).entities;
      for (std::uint32_t i = 0; i < entities.size(); ++i) {
        if (entities[i].kind == target.kind && entities[i].name == target.name &&
            !targets_.contains({file, i}))
          return false;
      }
    }
    return true;
  }

  void rename_parameters(const NamedEntity& target, const std::string& name,
                         const std::string& path, bool is_only) {
    const auto format = parameter_format(path);
    const ReadResult read = context_.resolver.disk().read(path, kMaxParameterBytes);
    if (!format || !read.bytes || read.bytes->find(target.name) == std::string::npos) return;
    const SourceId source = context_.sources.add(path, *read.bytes);
    for (const ParameterName& use :
         parameter_names(context_.sources.bytes(source), *format, source, target.name)) {
      if (is_only && use.is_of({target.kind})) {
        add(use.where, name);
      } else if (!edits_.contains(key_of(use.where))) {
        suspected_.push_back(use.where);
      }
    }
  }

  /// That the edits of what was written change those names of the expansion, and nothing else.
  void prove(const std::string& path, const std::vector<Edit>& edits) {
    if (!refused_.empty()) return;
    const read::File& file = context_.graph.file(path);
    const auto expected = apply_edits(file.document->bytes(), edits);
    std::map<std::string, std::pair<SourceId, std::vector<Edit>>> by_file;
    for (const auto& [key, edit] : edits_) {
      auto& [source, list] = by_file[std::get<0>(key)];
      source = edit.span.source;
      list.push_back(edit);
    }
    read::TemplateExpander expander(context_.resolver);
    for (const auto& [written, change] : by_file) {
      if (const auto text = apply_edits(context_.sources.bytes(change.first), change.second))
        expander.replace(written, *text);
    }
    const auto again = expander.expand(path, context_.sources);
    if (!expected || !again->document || again->document->bytes() != *expected)
      refused_ = fmt::format("what the name is written in has other uses in the template {}", path);
  }

  RenameContext context_;
  std::map<EntityId, std::string> targets_;  ///< and what each will be called
  std::map<SpanKey, Edit> edits_;
  std::map<std::string, std::vector<Edit>> expanded_edits_;  // of expanded documents, by path
  std::vector<Span> suspected_;
  std::string refused_;
};

}  // namespace

std::string name_fault(std::string_view name) {
  if (name.empty()) return "a name cannot be empty";
  if (name.find("::") != std::string_view::npos)
    return "a name cannot contain '::', which separates scopes";
  if (name == "world") return "'world' is reserved";
  if (name.size() >= 4 && name.starts_with("__") && name.ends_with("__"))
    return "names that begin and end with '__' are reserved";
  if (name.find_first_of(" \t\r\n\"'<>&") != std::string_view::npos)
    return "a name cannot contain blanks, quotes, '<', '>' or '&'";
  return {};
}

Renaming renamed(const RenameContext& context, const std::map<EntityId, std::string>& names,
                 const std::vector<std::string>& files) {
  for (const auto& [target, name] : names) {
    if (std::string fault = name_fault(name); !fault.empty()) return {{}, std::move(fault)};
    // A URDF's link of this name is the world itself.
    if (context.graph.entity(target).name == "world") return {{}, "'world' is reserved"};
    const auto taken = context.graph.taken(target, name);
    if (!taken || names.contains(*taken)) continue;
    const NamedEntity& other = context.graph.entity(*taken);
    return {{}, fmt::format("a {} is named '{}' already", to_string(other.kind), name)};
  }
  return Renamer(context, names).rename(files);
}

Renaming renamed(const RenameContext& context, const EntityId& target, std::string_view name,
                 const std::vector<std::string>& files) {
  return renamed(context, {{target, std::string(name)}}, files);
}

}  // namespace rigor::author
