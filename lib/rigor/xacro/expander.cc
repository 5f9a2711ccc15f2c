// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xacro/expander.h>

#include <algorithm>
#include <utility>

#include <rigor/text/path.h>
#include <rigor/xacro/builtins.h>
#include <rigor/xacro/value/compare.h>
#include <rigor/xacro/value/literal.h>
#include <rigor/xacro/value/unicode.h>

namespace rigor::xacro {
namespace {

/// Whether two texts are the same; where they lie at one place, without a look at them.
bool is_same(std::string_view a, std::string_view b) {
  return a.size() == b.size() && (a.data() == b.data() || a == b);
}

}  // namespace

Expander::Expander(const World& world, const Options& options, Sources& sources)
    : world_(world),
      options_(options),
      sources_(sources),
      heap_(*(result_.heap = std::make_unique<Heap>(options.bounds.memory))),
      nodes_(*(result_.nodes = std::make_unique<Nodes>())),
      templates_(heap_, symbols_),
      evaluator_(heap_, symbols_, options.bounds, *this) {}

Value Expander::builtin(Symbol name) {
  if (name >= builtins_.size()) builtins_.resize(symbols_.size(), Value::none());
  Value& known = builtins_[name];
  // Found when it is first asked for: of all, a template uses a handful.
  if (known.is(Type::kNone)) known = global_builtin(symbols_.name(name)).value_or(Value::error());
  return known;
}

Expansion Expander::run(const std::string& path) {
  result_.frames.push_back({FactFrame::Kind::kInclude, 0, {}, heap_.keep(path)});
  own_path_is_absolute_ = is_absolute(path);
  for (const auto& [name, value] : options_.arguments) {
    arguments_[name] = {heap_.keep(value), {}, false, true, {}};
  }
  const File& file = file_at(path);
  if (!file.readable) {
    report(FactKind::kFileNotFound, {}, path, file.problem);
  } else {
    result_.frames[0].where = {file.source, 0, 0};
    file_stack_.push_back(file.path);
    report_faults(file);
    if (file.tree.root != nullptr) expand_document(file);
    // What failed may have been the use.
    if (result_.is_known()) report_unused();
    relate_definitions();
    result_.part_origins.sort();
  }
  return std::move(result_);
}

void Expander::expand_document(const File& file) {
  Scope& scope = scopes_.emplace_back(nullptr, ScopeKind::kFile);
  MacroScope& macros = macro_scopes_.emplace_back(nullptr);
  Node& document = fragment();
  for (const Node* node = file.tree.document->first; node != nullptr; node = node->next) {
    Node& made = new_node(*node);
    document.append(made);
    if (node != file.tree.root) {
      made.text = node->text;
      continue;
    }
    result_.root = &made;
    Node root = *node;
    if (const NodeAttribute* target = node->attribute("xacro:targetNamespace");
        target != nullptr && !target->value.empty()) {
      NodeAttribute xmlns = *target;
      xmlns.name = "xmlns";
      root.set_attribute(xmlns);
    }
    const Names names{&macros, &scope};
    expand_attributes(root, names, made);
    expand_children(*node, names, made);
  }
  result_.document = &document;
}

Node& Expander::new_node(const Node& like) {
  Node& node = nodes_.emplace_back();
  node.kind = like.kind;
  node.name = like.name;
  node.where = like.where;
  node.frame = frame_;
  if (++nodes_made_ > options_.bounds.nodes && !stopped_) {
    report(FactKind::kBoundReached, like.where, {}, "the size of an expansion");
    stopped_ = true;
  }
  return node;
}

Node& Expander::fragment() {
  ++nodes_made_;
  return nodes_.emplace_back();
}

Node& Expander::clone(const Node& node) {
  Node& copy = new_node(node);
  copy.text = node.text;
  copy.from = node.from;
  copy.tag = node.tag;
  copy.code = node.code;
  copy.is_partial = node.is_partial;
  copy.attributes = node.attributes;
  for (const Node* child = node.first; child != nullptr && !stopped_; child = child->next) {
    if (depth_ > options_.bounds.depth) continue;
    ++depth_;
    copy.append(clone(*child));
    --depth_;
  }
  return copy;
}

bool Expander::enter(const Node& node) {
  if (!stopped_ && !evaluator_.work(1)) {
    if (const auto failure = evaluator_.take_failure()) report_failure(*failure, node.where);
    stopped_ = true;
  }
  if (!stopped_ && depth_ >= options_.bounds.depth) {
    report(FactKind::kBoundReached, node.where, {}, "the depth of an expansion");
    stopped_ = true;
  }
  if (stopped_) return false;
  ++depth_;
  return true;
}

void Expander::expand_children(const Node& source, Names names, Node& out) {
  if (!enter(source)) return;
  bool in_comments = false;
  for (const Node* child = source.first; child != nullptr && !stopped_; child = child->next) {
    switch (child->kind) {
      case NodeKind::kElement:
        in_comments = false;
        if (child->tag == Tag::kPlain) {
          expand_plain(*child, child->name, names, out);
        } else {
          expand_element(*child, child->tag, child->name, names, out);
        }
        continue;
      case NodeKind::kText: {
        Node& made = new_node(*child);
        made.text = child->text;
        made.from = child->from;
        if (has_no_dollar(child->code)) {
          made.code = child->code;
        } else {
          used_ = child->from;
          const auto text = evaluate_text(child->text, *names.values, child->where, child->code);
          made.text = text.value_or(child->text);
          out.is_partial = out.is_partial || !text;
          made.where.verbatim = made.where.verbatim && is_same(made.text, child->text);
          made.from = used_;
        }
        if (in_comments && made.code != TextCode::kBlank && !stripped(made.text).empty())
          in_comments = false;
        out.append(made);
        continue;
      }
      case NodeKind::kComment: {
        if (child->text.find("xacro:eval-comments") != std::string_view::npos) {
          in_comments = child->text.find("xacro:eval-comments:off") == std::string_view::npos;
          continue;
        }
        Node& made = new_node(*child);
        made.text = child->text;
        if (in_comments)
          made.text = evaluate_text(child->text, *names.values, child->where).value_or(child->text);
        out.append(made);
        continue;
      }
      default: {
        Node& made = new_node(*child);
        made.text = child->text;
        out.append(made);
      }
    }
  }
  leave();
}

void Expander::expand_element(const Node& node, Tag tag, std::string_view name, Names names,
                              Node& out) {
  switch (tag == Tag::kUnknown ? tag_of(name) : tag) {
    case Tag::kUnknown:
    case Tag::kPlain: return expand_plain(node, name, names, out);
    case Tag::kProperty: return define_property(node, names, out);
    case Tag::kMacro: return define_macro(node, names, out);
    case Tag::kIf: return expand_condition(node, true, names, out);
    case Tag::kUnless: return expand_condition(node, false, names, out);
    case Tag::kInclude: return expand_include(node, names, out);
    case Tag::kInsertBlock: return insert_block(node, names, out);
    case Tag::kArgument: return define_argument(node, names, out);
    case Tag::kElement: return expand_renamed(node, names, out);
    case Tag::kAttribute: return expand_attribute_tag(node, names, out);
    case Tag::kDynamicCall: return expand_dynamic_call(node, names, out);
    case Tag::kCall: return expand_call(node, name.substr(kTagPrefix.size()), names, out);
  }
}

void Expander::expand_plain(const Node& node, std::string_view name, Names names, Node& out) {
  Node& made = new_node(node);
  made.name = name;
  made.is_partial = node.is_partial;  // of a block that was expanded before
  if (node.tag == Tag::kPlain) made.tag = Tag::kPlain;
  // In the robot itself, or in what is to become part of it.
  if (out.name.empty() || &out == result_.root) report_missing_prefix(node, *names.macros);
  out.append(made);
  expand_attributes(node, names, made);
  expand_children(node, names, made);
}

void Expander::expand_attributes(const Node& node, Names names, Node& out) {
  out.attributes.reserve(node.attributes.size());
  element_ = &node;
  // A tag has no attribute twice.
  const bool is_empty = out.attributes.empty();
  for (const NodeAttribute& attribute : node.attributes) {
    if (attribute.name.starts_with('x') &&
        (attribute.name.starts_with(kTagPrefix) || attribute.name == "xmlns:xacro"))
      continue;
    NodeAttribute made = attribute;
    if (!has_no_dollar(attribute.code)) {
      used_ = attribute.from;
      const auto value = evaluate_text(attribute, names);
      made.value = value.value_or(attribute.value);
      out.is_partial = out.is_partial || !value;
      made.where.verbatim = attribute.where.verbatim && is_same(made.value, attribute.value);
      made.from = used_;
      made.code = TextCode::kUnknown;
    }
    if (is_empty) {
      out.attributes.push_back(made);
    } else {
      out.set_attribute(made);
    }
  }
}

void Expander::check_attributes(const Node& node, Names names) {
  for (const NodeAttribute& attribute : node.attributes) {
    if (has_no_dollar(attribute.code) || attribute.name.starts_with(kTagPrefix)) continue;
    evaluate_text(attribute, names);
  }
}

void Expander::expand_renamed(const Node& node, Names names, Node& out) {
  const NodeAttribute* name = required(node, "xacro:name");
  if (name == nullptr) return;
  const auto tag = evaluate_text(*name, names);
  out.is_partial = out.is_partial || !tag;
  if (!tag) return;
  if (tag->empty()) return report(FactKind::kBadName, name->where, "xacro:element", "it is empty");
  if (*tag == "xacro:element")
    return report(FactKind::kBadName, name->where, "xacro:element", "it is its own");
  expand_element(node, tag_of(*tag), *tag, names, out);
}

void Expander::expand_attribute_tag(const Node& node, Names names, Node& out) {
  const NodeAttribute* name = required(node, "name");
  const NodeAttribute* value = required(node, "value");
  if (name == nullptr || value == nullptr) return;
  const auto key = evaluate_text(*name, names);
  used_ = {};
  const auto text = evaluate_text(*value, names);
  out.is_partial = out.is_partial || !key || !text;
  if (!key || !text) return;
  if (key->empty())
    return report(FactKind::kBadName, name->where, "xacro:attribute", "it is empty");
  if (out.name.empty()) report(FactKind::kLostAttribute, node.where, std::string(*key));
  out.set_attribute({*key, *text, value->where, used_});
}

void Expander::expand_condition(const Node& node, bool wanted, Names names, Node& out) {
  drop_comments_before(node, out);
  place_marker(node, out);
  const NodeAttribute* value = required(node, "value");
  check_known(node, {"value"});
  if (value == nullptr) {
    incomplete_ = true;
    return;
  }
  const std::optional<bool> is = evaluate_condition(*value, names);
  if (is && value->value.find('$') == std::string_view::npos)
    report(FactKind::kConstantCondition, value->where, *is ? "true" : "false");
  // What the branch defines is unknown.
  if (!is) incomplete_ = out.is_partial = true;
  if (is && *is != wanted) result_.skipped_conditions.push_back(node.where.span);
  if (is != wanted) return;
  check_attributes(node, names);
  Node& content = fragment();
  const std::uint32_t outer = frame_;
  frame_ = push_frame({FactFrame::Kind::kCondition, outer, node.where.span, value->value});
  expand_children(node, names, content);
  frame_ = outer;
  append_content(content, out);
}

void Expander::insert_block(const Node& node, Names names, Node& out) {
  const NodeAttribute* name = required(node, "name");
  if (name == nullptr) return;
  check_known(node, {"name"});
  const std::string single = '*' + std::string(name->value);
  Binding* binding = names.values->find(symbols_.of('*' + single));
  const bool content_only = binding != nullptr;
  if (binding == nullptr) binding = names.values->find(symbols_.of(single));
  if (binding == nullptr || !binding->value.is(Type::kBlock)) out.is_partial = true;
  if (binding == nullptr) {
    if (!incomplete_) report(FactKind::kUndefinedBlock, name->where, std::string(name->value));
    return;
  }
  if (binding->definition != kNoDefinition) definitions_[binding->definition].used = true;
  binding->used = true;
  if (!binding->value.is(Type::kBlock)) {
    ++lost_blocks_;
    return;
  }
  const Node* block = binding->value.node_;
  // A marker in the block would move while it is read.
  for (const Node* at = marker_; at != nullptr; at = at->parent) {
    if (at != block) continue;
    block = &clone(*block);
    break;
  }
  const std::uint32_t outer = frame_;
  frame_ = push_frame({FactFrame::Kind::kBlock, outer, node.where.span, name->value});
  if (content_only) {
    check_attributes(*block, names);
    Node& content = fragment();
    content.is_partial = block->is_partial;
    expand_children(*block, names, content);
    append_content(content, out);
  } else {
    // The element itself is no tag of xacro's any more: the call has expanded it.
    expand_plain(*block, block->name, names, out);
  }
  frame_ = outer;
}

void Expander::define_argument(const Node& node, Names names, Node& out) {
  const NodeAttribute* name = required(node, "name");
  const NodeAttribute* value = required(node, "default");
  if (name == nullptr) return;
  if (value == nullptr) {
    arguments_.try_emplace(std::string(name->value), Argument{{}, name->where, true, false, {}});
    return;
  }
  check_known(node, {"name", "default"});
  const auto found = arguments_.find(name->value);
  if (found == arguments_.end()) {
    used_ = {};
    const auto text = evaluate_text(*value, names);
    arguments_.emplace(name->value, Argument{text.value_or(std::string_view{}), value->where, !text,
                                             false, node.where.span});
  } else if (found->second.given && found->second.place.span.nowhere()) {
    found->second.place = name->where;
    found->second.declared = node.where.span;
  }
  drop_comments_before(node, out);
  place_marker(node, out);
}

void Expander::drop_comments_before(const Node&, Node& out) {
  Node* previous = out.last;
  while (previous != nullptr) {
    const bool skipped = previous->kind == NodeKind::kText &&
                         (previous->code == TextCode::kBlank || is_all_blank(previous->text)) &&
                         std::count(previous->text.begin(), previous->text.end(), '\n') <= 1;
    if (skipped) previous = previous->previous;
    if (previous == nullptr || previous->kind != NodeKind::kComment) return;
    Node* comment = previous;
    previous = previous->previous;
    out.remove(*comment);
  }
}

void Expander::place_marker(const Node& tag, Node& out) {
  if (tag.next == nullptr) return;
  if (marker_ == nullptr) {
    marker_ = &nodes_.emplace_back();
    marker_->kind = NodeKind::kText;
    marker_->text = "\n\n";
  }
  if (marker_->parent != nullptr) marker_->parent->remove(*marker_);
  out.append(*marker_);
}

void Expander::append_content(Node& content, Node& out) {
  const bool marked = marker_ != nullptr && marker_->parent == &out && out.last == marker_;
  if (marked) out.remove(*marker_);
  out.is_partial = out.is_partial || content.is_partial;
  out.take_children(content);
  if (marked) out.append(*marker_);
}

void Expander::lift_namespaces(const Node& from, Node& to) {
  for (const NodeAttribute& attribute : from.attributes) {
    if (!attribute.name.starts_with("xmlns:")) continue;
    const NodeAttribute* other = to.attribute(attribute.name);
    if (other != nullptr && other->value != attribute.value) {
      report(FactKind::kNamespaceConflict, attribute.where, std::string(attribute.name),
             std::string(other->value), other->where.span);
    } else {
      to.set_attribute(attribute);
    }
  }
}

}  // namespace rigor::xacro
