// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xacro/expression/evaluator.h>

#include <utility>

#include <rigor/xacro/value/compare.h>
#include <rigor/xacro/value/integer.h>

namespace rigor::xacro {
namespace {

/// Evaluations within each other on this thread's stack, lazy properties among them.
constexpr std::uint32_t kMaxEvaluationDepth = 1'500;

}  // namespace

Value Evaluator::fail(FactKind kind, std::string name, std::string detail) {
  if (!failure_) {
    failure_ = Failure{kind, node_ != nullptr ? node_->begin : 0, node_ != nullptr ? node_->end : 0,
                       std::move(name), std::move(detail)};
  }
  return Value::error();
}

bool Evaluator::fail_of_work() {
  fail(FactKind::kBoundReached, {},
       heap_.full() ? "the memory of expressions" : "the steps of an expansion");
  return false;
}

bool Evaluator::fits(std::uint64_t items) {
  if (items <= bounds_.items) return work(1 + items / 8);
  fail(FactKind::kBoundReached, {}, "the items of a list");
  return false;
}

Value Evaluator::text(std::string_view bytes) {
  if (bytes.size() > bounds_.text_bytes)
    return fail(FactKind::kBoundReached, {}, "the length of a text");
  if (!work(1 + bytes.size() / 64)) return Value::error();
  return heap_.text(bytes);
}

Value Evaluator::number(Value maybe_too_large) {
  if (!maybe_too_large.failed()) return maybe_too_large;
  return fail(FactKind::kBoundReached, {}, "the digits of a number");
}

Value Evaluator::list(std::vector<Value> items) {
  return fits(items.size()) ? heap_.list(std::move(items)) : Value::error();
}

Value Evaluator::evaluate(const Expression& expression, Scope& scope) {
  if (expression.trouble) {
    const ExpressionTrouble& trouble = *expression.trouble;
    if (!failure_) failure_ = Failure{trouble.kind, trouble.begin, trouble.end, {}, trouble.detail};
    return Value::error();
  }
  const auto* outer_expression = std::exchange(expression_, &expression);
  const auto* outer_node = std::exchange(node_, nullptr);
  auto* outer_scope = std::exchange(scope_, &scope);
  const std::size_t outer_local = std::exchange(first_local_, locals_.size());
  const Value result = eval(expression.root);
  locals_.resize(first_local_);
  expression_ = outer_expression;
  node_ = outer_node;
  scope_ = outer_scope;
  first_local_ = outer_local;
  return result;
}

Value Evaluator::eval(std::uint32_t id) {
  if (id == kNoNode) return Value::none();
  const Node& node = expression_->nodes[id];
  if (node.op == Op::kConstant) return node.constant;
  if (!work(1)) return Value::error();
  if (depth_ >= kMaxEvaluationDepth)
    return fail(FactKind::kBoundReached, {}, "the depth of evaluation");
  ++depth_;
  const Value result = eval_node(node);
  --depth_;
  return result;
}

Value Evaluator::eval_node(const Node& node) {
  switch (node.op) {
    case Op::kName: return eval_name(node);
    case Op::kOr:
    case Op::kAnd: {
      const Value left = eval(node.a);
      if (left.failed() || is_true(left) == (node.op == Op::kOr)) return left;
      return eval(node.b);
    }
    case Op::kNot: {
      const Value inner = eval(node.a);
      return inner.failed() ? inner : Value::boolean(!is_true(inner));
    }
    case Op::kCompare: return eval_compare(node);
    case Op::kBinary: {
      const Value left = eval(node.a);
      if (left.failed()) return left;
      const Value right = eval(node.b);
      if (right.failed()) return right;
      node_ = &node;
      return binary(node.operation, left, right);
    }
    case Op::kUnary: return eval_unary(node);
    case Op::kConditional: {
      const Value condition = eval(node.b);
      if (condition.failed()) return condition;
      return eval(is_true(condition) ? node.a : node.c);
    }
    case Op::kAttribute: {
      const Value of = eval(node.a);
      if (of.failed()) return of;
      node_ = &node;
      return attribute(of, symbols_.name(node.symbol));
    }
    case Op::kSubscript: return eval_subscript(node);
    case Op::kSlice: {
      std::vector<Value> parts{eval(node.a), eval(node.b), eval(node.c)};
      for (const Value part : parts) {
        if (part.failed()) return part;
      }
      return heap_.iterator(Type::kSlice, std::move(parts), "slice");
    }
    case Op::kCall: return eval_call(node);
    case Op::kList: return eval_items(node, Type::kList);
    case Op::kTuple: return eval_items(node, Type::kTuple);
    case Op::kSet: return eval_items(node, Type::kSet);
    case Op::kDictionary: return eval_dictionary(node);
    case Op::kListOf:
    case Op::kSetOf:
    case Op::kDictionaryOf:
    case Op::kGenerator: return eval_comprehension(node);
    default: break;
  }
  node_ = &node;
  return fail(FactKind::kSyntax, {}, "a star outside of a list or call");
}

Value Evaluator::eval_name(const Node& node) {
  for (std::size_t i = locals_.size(); i > first_local_; --i) {
    if (locals_[i - 1].first == node.symbol) return locals_[i - 1].second;
  }
  node_ = &node;
  if (const std::optional<Value> found = host_.look_up(*scope_, node.symbol)) return *found;
  node_ = &node;
  const std::string_view name = symbols_.name(node.symbol);
  return fail(FactKind::kUndefinedName, std::string(name), host_.name_near(*scope_, name));
}

Value Evaluator::eval_compare(const Node& node) {
  Value left = eval(node.a);
  if (left.failed()) return left;
  Value result = Value::boolean(true);
  for (std::uint32_t i = 0; i < list_size(node.b); ++i) {
    const Node& comparison = expression_->nodes[list_item(node.b, i)];
    const Value right = eval(comparison.a);
    if (right.failed()) return right;
    node_ = &node;
    result = compare(comparison.operation, left, right);
    if (result.failed() || !is_true(result)) return result;
    left = right;
  }
  return result;
}

Value Evaluator::eval_unary(const Node& node) {
  const Value inner = eval(node.a);
  if (inner.failed()) return inner;
  node_ = &node;
  if (inner.is(Type::kReal) && node.operation != Operation::kInvert) {
    return node.operation == Operation::kNegate ? Value::real(-inner.real_) : inner;
  }
  if (inner.is_integral()) {
    if (node.operation == Operation::kPlus) {
      return inner.is(Type::kBool) ? Value::integer(inner.integer_) : inner;
    }
    const Value negated = number(negated_integer(heap_, inner));
    if (negated.failed() || node.operation == Operation::kNegate) return negated;
    return number(
        integer_operation(heap_, IntegerOperation::kSubtract, negated, Value::integer(1)));
  }
  return wrong_type("a " + std::string(type_name(inner)) +
                    " has no sign: " + std::string(to_string(node.operation)) + " takes a number");
}

Value Evaluator::eval_subscript(const Node& node) {
  const Value of = eval(node.a);
  if (of.failed()) return of;
  const Value index = eval(node.b);
  if (index.failed()) return index;
  node_ = &node;
  return subscript(of, index);
}

bool Evaluator::gather(const Node& node, Arguments& arguments) {
  for (std::uint32_t i = 0; i < list_size(node.b); ++i) {
    const Node& item = expression_->nodes[list_item(node.b, i)];
    const bool plain =
        item.op != Op::kStarred && item.op != Op::kKeyword && item.op != Op::kDoubleStarred;
    const Value value = eval(plain ? list_item(node.b, i) : item.a);
    if (value.failed()) return false;
    node_ = &node;
    if (plain) {
      arguments.values.push_back(value);
    } else if (item.op == Op::kKeyword) {
      arguments.named.emplace_back(symbols_.name(item.symbol), value);
    } else if (item.op == Op::kStarred) {
      const auto items = items_of(value);
      if (!items || !fits(arguments.values.size() + items->size())) return false;
      arguments.values.insert(arguments.values.end(), items->begin(), items->end());
    } else if (value.is(Type::kDictionary)) {
      for (const Entry& entry : value.dictionary_->entries->list) {
        if (!entry.key.is_text()) {
          wrong_type("keywords must be texts");
          return false;
        }
        arguments.named.emplace_back(entry.key.as_text(), entry.value);
      }
    } else {
      wrong_type("a " + std::string(type_name(value)) + " behind ** is no dictionary");
      return false;
    }
  }
  return true;
}

Value Evaluator::eval_call(const Node& node) {
  const Value callee = eval(node.a);
  if (callee.failed()) return callee;
  Arguments arguments;
  if (!gather(node, arguments)) return Value::error();
  node_ = &node;
  return call(callee, arguments);
}

Value Evaluator::eval_items(const Node& node, Type type) {
  Arguments items;
  if (!gather(node, items)) return Value::error();
  node_ = &node;
  if (!items.named.empty()) return fail(FactKind::kSyntax, {}, "a name in a list");
  if (type != Type::kSet) return heap_.sequence(type, std::move(items.values));
  Entries entries;
  for (const Value item : items.values) {
    if (!is_hashable(item))
      return wrong_type("unhashable type: '" + std::string(type_name(item)) + "'");
    set_entry(entries, item, Value::none());
  }
  return heap_.entries(Type::kSet, std::move(entries));
}

Value Evaluator::eval_dictionary(const Node& node) {
  Entries entries;
  for (std::uint32_t i = 0; i + 1 < list_size(node.b); i += 2) {
    const std::uint32_t id = list_item(node.b, i);
    if (expression_->nodes[id].op == Op::kDoubleStarred) {
      const Value inner = eval(expression_->nodes[id].a);
      if (inner.failed()) return inner;
      node_ = &node;
      if (!inner.is(Type::kDictionary)) return wrong_type("what is behind ** is no dictionary");
      for (const Entry& entry : inner.dictionary_->entries->list)
        set_entry(entries, entry.key, entry.value);
      continue;
    }
    const Value key = eval(id);
    if (key.failed()) return key;
    const Value value = eval(list_item(node.b, i + 1));
    if (value.failed()) return value;
    node_ = &node;
    if (!is_hashable(key))
      return wrong_type("unhashable type: '" + std::string(type_name(key)) + "'");
    set_entry(entries, key, value);
  }
  return heap_.entries(Type::kDictionary, std::move(entries));
}

bool Evaluator::bind(std::uint32_t target, Value value) {
  const Node& node = expression_->nodes[target];
  if (node.op == Op::kName) {
    locals_.emplace_back(node.symbol, value);
    return true;
  }
  node_ = &node;
  const auto items = items_of(value);
  if (!items) return false;
  if (items->size() != list_size(node.b)) {
    wrong_value("cannot unpack " + std::to_string(items->size()) + " values into " +
                std::to_string(list_size(node.b)) + " names");
    return false;
  }
  for (std::uint32_t i = 0; i < list_size(node.b); ++i) {
    if (!bind(list_item(node.b, i), (*items)[i])) return false;
  }
  return true;
}

bool Evaluator::eval_clauses(const Node& node, std::uint32_t clause, std::vector<Entry>& into) {
  if (clause == list_size(node.b)) {
    Entry entry;
    entry.key = eval(node.a);
    if (entry.key.failed()) return false;
    if (node.op == Op::kDictionaryOf) entry.value = eval(node.c);
    if (entry.value.failed()) return false;
    into.push_back(entry);
    node_ = &node;
    return fits(into.size() & ~std::uint64_t{7});
  }
  const Node& now = expression_->nodes[list_item(node.b, clause)];
  if (now.op == Op::kFilter) {
    const Value condition = eval(now.a);
    if (condition.failed()) return false;
    return !is_true(condition) || eval_clauses(node, clause + 1, into);
  }
  const Value iterable = eval(now.b);
  if (iterable.failed()) return false;
  node_ = &now;
  const auto items = items_of(iterable);
  if (!items) return false;
  const std::size_t before = locals_.size();
  for (const Value item : *items) {
    const bool going = work(1) && bind(now.a, item) && eval_clauses(node, clause + 1, into);
    locals_.resize(before);
    if (!going) return false;
  }
  return true;
}

Value Evaluator::eval_comprehension(const Node& node) {
  std::vector<Entry> found;
  if (!eval_clauses(node, 0, found)) return Value::error();
  node_ = &node;
  if (node.op == Op::kListOf || node.op == Op::kGenerator) {
    std::vector<Value> values;
    values.reserve(found.size());
    for (const Entry& entry : found) values.push_back(entry.key);
    if (node.op == Op::kListOf) return list(std::move(values));
    return heap_.iterator(Type::kIterator, std::move(values), "generator");
  }
  Entries entries;
  for (const Entry& entry : found) {
    if (!is_hashable(entry.key)) {
      return wrong_type("unhashable type: '" + std::string(type_name(entry.key)) + "'");
    }
    set_entry(entries, entry.key, entry.value);
  }
  return heap_.entries(node.op == Op::kSetOf ? Type::kSet : Type::kDictionary, std::move(entries));
}

}  // namespace rigor::xacro
