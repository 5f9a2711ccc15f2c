// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/names/rename.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include <fmt/core.h>

#include <rigor/author/names/parameter_names.h>
#include <rigor/author/names/text_mentions.h>
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

/// Edits of the literals around an expression, `${prefix}wheel`, that make `name` of `shown`; none where they cannot. What
/// the expression is elsewhere is left to the proof.
std::vector<Edit> literal_parts_renamed(Span where, std::string_view written,
                                        std::string_view shown, const std::string& name) {
  const std::size_t open = written.find('$');
  const std::size_t close = written.find_last_of("})");
  if (open == written.npos || close == written.npos || close < open) return {};
  const std::string_view head = written.substr(0, open), tail = written.substr(close + 1);
  if (head.empty() && tail.empty()) return {};
  if (shown.size() < head.size() + tail.size() || !shown.starts_with(head) ||
      !shown.ends_with(tail))
    return {};
  const std::string_view value =
      shown.substr(head.size(), shown.size() - head.size() - tail.size());
  const std::string behind = std::string(value) + std::string(tail);
  const std::string before = std::string(head) + std::string(value);
  std::string new_head(head), new_tail(tail);
  if (name.ends_with(behind)) {
    new_head = name.substr(0, name.size() - behind.size());
  } else if (name.starts_with(before)) {
    new_tail = name.substr(before.size());
  } else {
    const std::size_t at = value.empty() ? 0 : name.find(value);
    if (at == std::string::npos) return {};
    new_head = name.substr(0, at);
    new_tail = name.substr(at + value.size());
  }
  std::vector<Edit> edits;
  const auto begin = where.begin;
  if (new_head != head) {
    edits.push_back(
        {{where.source, begin, begin + static_cast<std::uint32_t>(head.size())}, new_head});
  }
  if (new_tail != tail) {
    edits.push_back(
        {{where.source, begin + static_cast<std::uint32_t>(close) + 1, where.end}, new_tail});
  }
  return edits;
}

/// Renames in one file after another; `refused` ends it.
class Renamer {
 public:
  Renamer(const RenameContext& context, const std::map<EntityId, std::string>& names)
      : context_(context), targets_(names) {}

  Renaming rename(const ReferringFiles& referring) {
    const std::map<EntityId, std::string> asked = targets_;
    std::vector<std::string> named = models_of(referring.named);
    for (const auto& [target, name] : asked) named.push_back(target.path);
    std::vector<std::string> files = models_of(referring.found);
    files.insert(files.end(), named.begin(), named.end());
    std::sort(files.begin(), files.end());
    files.erase(std::unique(files.begin(), files.end()), files.end());
    // What one template edits in a shared file makes targets of another's names, in whatever order they come.
    for (std::size_t known = 0; known != targets_.size() + edits_.size() && refused_.empty();) {
      known = targets_.size() + edits_.size();
      for (const std::string& file : files) rename_in(file);
    }
    for (const auto& [path, edits] : expanded_edits_) prove(path, edits);
    for (const std::string& file : files) {
      if (refused_.empty() && is_touched(file)) prove(file, {});
    }
    if (!refused_.empty()) return {{}, refused_};
    rename_texts(asked, referring.named, named);
    rename_texts(asked, referring.found, files);
    for (const std::string& file : files) suspect_namesakes(asked, file);
    std::vector<Edit> edits;
    for (const auto& [key, edit] : edits_) edits.push_back(edit);
    std::sort(edits.begin(), edits.end(), before);
    return {std::move(edits), {}, std::move(suspected_)};
  }

 private:
  static bool is_model(const std::string& path) {
    return !parameter_format(path) && !is_mentioning_text(path);
  }

  static std::vector<std::string> models_of(const std::vector<std::string>& paths) {
    std::vector<std::string> models;
    for (const std::string& path : paths) {
      if (is_model(path)) models.push_back(normalize_path(path));
    }
    return models;
  }

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
    } else {
      if (composed_.nowhere()) composed_ = origin.where;
      const std::string_view written = context_.sources.bytes(origin.where);
      for (Edit& edit :
           literal_parts_renamed(origin.where, written, context_.sources.bytes(use.where), name))
        edits_.try_emplace(key_of(edit.span), std::move(edit));
    }
    auto& edits = expanded_edits_[path];
    const Edit edit{use.where, name};
    if (std::find(edits.begin(), edits.end(), edit) == edits.end()) edits.push_back(edit);
  }

  void add(Span where, const std::string& name) {
    edits_.try_emplace(key_of(where), Edit{where, name});
  }

  std::string robot_of(const std::string& file) {
    const std::vector<NamedEntity>& entities = context_.graph.names(file).entities;
    return entities.empty() ? std::string() : entities[0].name;
  }

  /// What another file defines as the target's kind and name, if it does.
  std::optional<std::uint32_t> namesake(const EntityId& id, const std::string& file) {
    const NamedEntity& target = context_.graph.entity(id);
    const std::vector<NamedEntity>& entities = context_.graph.names(file).entities;
    for (std::uint32_t i = 0; i < entities.size(); ++i) {
      if (entities[i].kind == target.kind && entities[i].name == target.name &&
          !targets_.contains({file, i}))
        return i;
    }
    return std::nullopt;
  }

  /// Whether no other robot of the files has something of that kind and name. One robot is often in two files, its
  /// template and what it expands to.
  bool is_only_one(const EntityId& target, const std::vector<std::string>& files) {
    return std::none_of(files.begin(), files.end(), [&](const std::string& file) {
      const bool is_same_robot = file != target.path && robot_of(file) == robot_of(target.path);
      return !is_same_robot && namesake(target, file);
    });
  }

  /// Of a robot that is in two files, what the other one defines.
  void suspect_namesakes(const std::map<EntityId, std::string>& asked, const std::string& path) {
    for (const auto& [target, name] : asked) {
      if (path == target.path || robot_of(path) != robot_of(target.path)) continue;
      const auto other = namesake(target, path);
      if (!other) continue;
      const read::File& file = context_.graph.file(path);
      Span where = context_.graph.names(path).entities[*other].where;
      if (where.nowhere() || !file.document) continue;
      if (file.expanded) {
        const read::Origin origin = file.expanded->origin(*file.document, where, context_.sources);
        if (!origin.literal) continue;
        where = origin.where;
      }
      if (!edits_.contains(key_of(where))) suspected_.push_back(where);
    }
  }

  void rename_texts(const std::map<EntityId, std::string>& asked,
                    const std::vector<std::string>& files, const std::vector<std::string>& models) {
    std::map<EntityId, bool> is_only;
    for (const std::string& path : files) {
      if (is_model(path)) continue;
      const ReadResult read = context_.resolver.disk().read(path, kMaxParameterBytes);
      if (!read.bytes) continue;
      SourceId source = kNoSource;
      for (const auto& [target, name] : asked) {
        const std::string& old = context_.graph.entity(target).name;
        if (read.bytes->find(old) == std::string::npos) continue;
        if (source == kNoSource) source = context_.sources.add(path, *read.bytes);
        if (!is_only.contains(target)) is_only[target] = is_only_one(target, models);
        rename_in_text(path, source, target, name, is_only[target]);
      }
    }
  }

  void rename_in_text(const std::string& path, SourceId source, const EntityId& target,
                      const std::string& name, bool is_only) {
    const NamedEntity& entity = context_.graph.entity(target);
    const std::string_view bytes = context_.sources.bytes(source);
    const auto format = parameter_format(path);
    if (!format) {
      for (const Span where : text_mentions(path, bytes, source, entity.name))
        suspected_.push_back(where);
      return;
    }
    for (const ParameterName& use : parameter_names(bytes, *format, source, entity.name)) {
      if (is_only && use.is_of({entity.kind})) {
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
    if (expected && again->document && again->document->bytes() == *expected) return;
    if (!composed_.nowhere() && !edits.empty()) {
      refused_ = fmt::format("an expression composes the name at {}",
                             place_of(context_.sources, composed_));
    } else {
      refused_ = fmt::format("what the name is written in has other uses in the template {}", path);
    }
  }

  /// Whether a template that has none of the names reads a file that is edited.
  bool is_touched(const std::string& path) {
    const read::File& file = context_.graph.file(path);
    if (!file.expanded || expanded_edits_.contains(path)) return false;
    std::set<std::string> edited;
    for (const auto& [key, edit] : edits_) edited.insert(std::get<0>(key));
    const auto& files = file.expanded->expansion().files;
    return std::any_of(files.begin(), files.end(), [&](const auto& each) {
      return edited.contains(normalize_path(context_.sources.path(each.source)));
    });
  }

  RenameContext context_;
  std::map<EntityId, std::string> targets_;  ///< and what each will be called
  std::map<SpanKey, Edit> edits_;
  std::map<std::string, std::vector<Edit>> expanded_edits_;  // of expanded documents, by path
  std::vector<Span> suspected_;
  Span composed_;  ///< the first place where an expression makes a part of a name
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
                 const ReferringFiles& files) {
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
                 const ReferringFiles& files) {
  return renamed(context, {{target, std::string(name)}}, files);
}

}  // namespace rigor::author
