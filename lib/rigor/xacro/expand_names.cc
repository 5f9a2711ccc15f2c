// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Properties, macros and includes: what gives names a meaning.

#include <algorithm>
#include <utility>

#include <rigor/text/path.h>
#include <rigor/xacro/expander.h>
#include <rigor/xacro/file_pattern.h>
#include <rigor/xacro/value/literal.h>

namespace rigor::xacro {

void Expander::define_property(const Node& node, Names names, Node& out) {
  drop_comments_before(node, out);
  place_marker(node, out);
  const NodeAttribute* name_attribute = required(node, "name");
  check_known(node, {"name", "value", "default", "remove", "scope", "lazy_eval"});
  if (name_attribute == nullptr) {
    incomplete_ = true;
    return;
  }
  const auto name = evaluate_text(*name_attribute, names);
  if (!name) {
    incomplete_ = true;
    return;
  }
  const std::string key(*name);
  const bool is_usable = is_identifier(key) && !key.starts_with("__");
  // What it was to define is unknown from here on.
  incomplete_ = incomplete_ || !is_usable;
  if (!is_identifier(key))
    return report(FactKind::kBadName, name_attribute->where, key, "it is no identifier of Python");
  if (key.starts_with("__"))
    return report(FactKind::kBadName, name_attribute->where, key,
                  "it starts with a double underscore");
  const NodeAttribute* value = node.attribute("value");
  const NodeAttribute* otherwise = node.attribute("default");
  const NodeAttribute* scope = node.attribute("scope");
  const auto flag = [&](std::string_view attribute, bool usual) -> std::optional<bool> {
    const NodeAttribute* found = node.attribute(attribute);
    if (found == nullptr || found->value.empty()) return usual;
    return evaluate_condition(*found, names);
  };
  const std::optional<bool> remove = flag("remove", false);
  if (!remove) return;
  if ((value != nullptr) + (otherwise != nullptr) + (*remove ? 1 : 0) > 1) {
    return report(FactKind::kPropertyConflict, name_attribute->where, key);
  }
  Symbol symbol = symbols_.of(key);
  const bool known = names.values->find(symbol) != nullptr || !builtin(symbol).failed();
  if (*remove && known) {
    for (Scope* at = names.values; at != nullptr; at = at->parent()) at->own().erase(symbol);
    return;
  }
  if (otherwise != nullptr) {
    if (scope != nullptr) report(FactKind::kIgnoredScope, scope->where, key);
    if (known) return;
    value = otherwise;
  }
  const std::optional<bool> lazy_flag = flag("lazy_eval", true);
  if (!lazy_flag) return;
  bool lazy = *lazy_flag;
  Scope* target = names.values;
  if (scope != nullptr && scope->value == "global") {
    target = &target->top();
    lazy = false;
  } else if (scope != nullptr && scope->value == "parent") {
    const bool in_macro = target->kind() != ScopeKind::kNamespace;
    target = target->parent();
    while (in_macro && target != nullptr && target->kind() == ScopeKind::kNamespace)
      target = target->parent();
    if (target == nullptr) return report(FactKind::kNoParentScope, scope->where, key);
    lazy = false;
  }
  Binding binding;
  binding.place = value != nullptr ? value->where : node.where;
  binding.definition = static_cast<std::uint32_t>(definitions_.size());
  if (!builtin(symbol).failed()) report(FactKind::kRedefinedBuiltin, name_attribute->where, key);
  const Binding* before = otherwise == nullptr ? target->own().find(symbol) : nullptr;
  if (before != nullptr && before->definition != kNoDefinition &&
      definitions_[before->definition].where != name_attribute->where.span) {
    report(FactKind::kRedefinedProperty, name_attribute->where, key, {},
           definitions_[before->definition].where);
  }
  if (target->kind() == ScopeKind::kMacro && target->parent() != nullptr &&
      target->own().find(symbol) == nullptr) {
    // Macros that call each other have properties of the same name all the time.
    Scope* home = nullptr;
    const Binding* hidden = target->parent()->find(symbol, &home);
    if (hidden != nullptr && home->kind() == ScopeKind::kFile &&
        hidden->definition != kNoDefinition) {
      report(FactKind::kShadowedName, name_attribute->where, key, {},
             definitions_[hidden->definition].where);
    }
  }
  definitions_.push_back({symbols_.name(symbol), name_attribute->where.span, false});
  if (value == nullptr) {
    symbol = symbols_.of("**" + key);
    binding.value = Value::block(node);
    target->own()[symbol] = binding;
    return;
  }
  Value given = Value::text(value->value);
  if (!lazy) {
    used_ = {};
    given = evaluate(value->value, *names.values, value->where, value->code);
    binding.from = used_;
  }
  binding.lazy = lazy;
  binding.code = value->code;
  bind(*target, symbol, given, binding);
}

void Expander::bind(Scope& scope, Symbol symbol, Value value, Binding binding) {
  binding.value = literal_value(heap_, value);
  // What is a literal needs no evaluation any more.
  binding.lazy = binding.lazy && binding.value.is_text();
  // The code is that of the text with its quotes.
  if (binding.lazy && binding.value.size != value.size)
    binding.code = templates_.code_of(binding.value.as_text());
  scope.own()[symbol] = binding;
}

void Expander::define_macro(const Node& node, Names names, Node& out) {
  drop_comments_before(node, out);
  place_marker(node, out);
  const NodeAttribute* name_attribute = required(node, "name");
  check_known(node, {"name", "params"});
  if (name_attribute == nullptr) return;
  std::string_view name = name_attribute->value;
  if (name == "call")
    return report(FactKind::kBadName, name_attribute->where, "call",
                  "xacro:call is a tag of xacro's own");
  if (name.find('.') != std::string_view::npos) {
    return report(FactKind::kBadName, name_attribute->where, std::string(name),
                  "a dot separates namespaces");
  }
  if (name.starts_with("xacro:")) {
    report(FactKind::kDeprecatedMacroName, name_attribute->where, std::string(name));
    name.remove_prefix(6);
  }
  Macro& macro = macros_.emplace_back();
  macro.name = name;
  macro.body = &node;
  macro.file = file_stack_.back();
  if (const NodeAttribute* params = node.attribute("params")) {
    macro.parameters = parse_parameters(params->value, params->where, symbols_);
    for (MacroParameter& parameter : macro.parameters)
      parameter.code = templates_.code_of(parameter.text);
  }
  MacroEntry& entry = names.macros->own()[symbols_.of(name)];
  if (entry.macro != nullptr && entry.macro->body != &node) {
    report(FactKind::kRedefinedMacro, name_attribute->where, std::string(name), {},
           entry.macro->body->where.span);
  }
  entry = {&macro, nullptr};
}

Expander::File& Expander::file_at(const std::string& path) {
  File*& known = files_by_path_[path];
  if (known != nullptr) return *known;
  File& file = files_.emplace_back();
  known = &file;
  file.path = path;
  std::string found = path;
  ReadResult read = read_file(found);
  if (!read.bytes) {
    file.problem = read.problem;
    return file;
  }
  file.readable = true;
  file.source = sources_.add(shown_path(found), std::move(*read.bytes));
  result_.files.push_back({found, file.source});
  heap_.charge(sources_.bytes(file.source).size());
  file.tree = read_source_tree(sources_.bytes(file.source), file.source, nodes_, heap_, templates_);
  return file;
}

ReadResult Expander::read_file(std::string& path) {
  ReadResult read = world_.disk.read(path, options_.bounds.file_bytes);
  if (read.bytes || !world_.locate) return read;
  const std::optional<std::string> elsewhere = world_.locate(path);
  if (!elsewhere) return read;
  path = *elsewhere;
  return world_.disk.read(path, options_.bounds.file_bytes);
}

void Expander::report_if_outside(const std::string& path, Place place) {
  if (world_.outside && world_.outside(path))
    report(FactKind::kOutsideRoots, place, shown_path(path));
}

std::string Expander::shown_path(const std::string& path) const {
  const std::string& here = world_.working_folder;
  const bool below = is_absolute(here) && path.starts_with(here + '/');
  return below && !own_path_is_absolute_ ? relative_path(here, path) : path;
}

void Expander::expand_include(const Node& node, Names names, Node& out) {
  const NodeAttribute* name = required(node, "filename");
  check_known(node, {"filename", "ns", "optional"});
  if (name == nullptr) return;
  Names inner = names;
  if (const NodeAttribute* ns = node.attribute("ns"); ns != nullptr && !ns->value.empty()) {
    const auto space = evaluate_text(*ns, names);
    if (!space) return;
    name_spaces_made_ = true;
    inner.macros = &macro_scopes_.emplace_back(nullptr);
    inner.values = &scopes_.emplace_back(names.values, ScopeKind::kNamespace);
    const Symbol symbol = symbols_.of(*space);
    names.macros->own()[symbol] = {nullptr, inner.macros};
    Binding binding;
    binding.value = Value::name_space(*inner.values);
    binding.place = ns->where;
    names.values->own()[symbol] = binding;
  }
  bool optional = false;
  if (const NodeAttribute* flag = node.attribute("optional")) {
    const auto is = boolean_value(heap_, Value::text(flag->value));
    if (!is) return report(FactKind::kNotBoolean, flag->where, std::string(flag->value));
    optional = *is;
  }
  if (const Node* child = node.first_element()) report(FactKind::kIgnoredChildren, child->where);
  const auto written = evaluate_text(*name, names);
  Node& content = fragment();
  if (!written || needs_missing_package(*written)) {
    incomplete_ = true;
    out.is_partial = true;
  } else {
    const std::string path = absolute_path(*written);
    if (is_file_pattern(path)) {
      const std::vector<std::string> paths =
          matching_files(world_.disk, path, options_.bounds.files);
      if (paths.empty()) report(FactKind::kNoMatch, name->where, path);
      for (const std::string& match : paths)
        include_file(node, match, optional, inner, content, out);
    } else {
      include_file(node, path, optional, inner, content, out);
    }
  }
  drop_comments_before(node, out);
  place_marker(node, out);
  append_content(content, out);
}

void Expander::include_file(const Node& node, const std::string& path, bool optional, Names names,
                            Node& content, Node& out) {
  const Place place = node.attribute("filename")->where;
  if (file_stack_.size() >= options_.bounds.include_depth ||
      files_.size() >= options_.bounds.files) {
    const bool again = std::find(file_stack_.begin(), file_stack_.end(), path) != file_stack_.end();
    report(again ? FactKind::kIncludeCycle : FactKind::kBoundReached, place, path,
           "the number of includes");
    stopped_ = true;
    return;
  }
  report_if_outside(path, place);
  File& file = file_at(path);
  if (!file.readable) {
    if (optional) return;
    report(FactKind::kFileNotFound, place, shown_path(path), file.problem);
    out.is_partial = true;
    incomplete_ = true;
    lacks_files_ = true;
    return;
  }
  report_faults(file);
  incomplete_ = incomplete_ || !file.tree.faults.empty();
  if (file.tree.root == nullptr) return;
  const std::uint32_t outer = frame_;
  frame_ = push_frame({FactFrame::Kind::kInclude, outer, node.where.span, heap_.keep(file.path)});
  const bool is_own = file_stack_.size() == 1;
  if (is_own) includes_.push_back({place, path, {}, false});
  if (!includes_.empty()) includes_.back().sources.push_back(file.source);
  file_stack_.push_back(file.path);
  Node& included = fragment();
  expand_attributes(*file.tree.root, names, included);
  expand_children(*file.tree.root, names, included);
  lift_namespaces(included, out);
  if (is_own) includes_.back().brings_elements = included.first_element() != nullptr;
  content.is_partial = content.is_partial || included.is_partial;
  content.take_children(included);
  file_stack_.pop_back();
  frame_ = outer;
}

std::string Expander::absolute_path(std::string_view path) {
  if (path.starts_with('/') || file_stack_.empty()) return std::string(path);
  const std::string_view file = file_stack_.back();
  const std::size_t slash = file.rfind('/');
  if (slash == std::string_view::npos) return std::string(path);
  std::string folder(file.substr(0, slash));
  // As os.path.dirname has it: "/a" lies in "/".
  if (folder.find_first_not_of('/') == std::string::npos) folder = file.substr(0, slash + 1);
  if (!folder.ends_with('/')) folder += '/';
  return folder += path;
}

}  // namespace rigor::xacro
