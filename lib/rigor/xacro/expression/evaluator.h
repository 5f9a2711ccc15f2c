// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Evaluates expressions over names that somebody else resolves. It never throws: what fails gives an
// error value, and `take_failure` says why, once; an error value that was handed in spreads in silence,
// since it has been reported where it arose.
//
//   Evaluator evaluator(heap, symbols, bounds, host);
//   Value v = evaluator.evaluate(parse_expression("2*pi", heap, symbols), names);
//   if (v.failed()) if (auto why = evaluator.take_failure()) report(*why);

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/xacro/bounds.h>
#include <rigor/xacro/expression/expression.h>
#include <rigor/xacro/expression/function.h>
#include <rigor/xacro/value/heap.h>
#include <rigor/xacro/value/symbol.h>

namespace rigor::xacro {

struct Failure {
  FactKind kind;
  std::uint32_t begin = 0;  ///< byte offsets in the expression
  std::uint32_t end = 0;
  std::string name;
  std::string detail;
};

/// What expressions reach of the world around them.
class Host {
 public:
  virtual ~Host() = default;
  /// A name's value in a scope; nothing where it is undefined.
  virtual std::optional<Value> look_up(Scope& scope, Symbol name) = 0;
  /// A name behind a namespace's dot.
  virtual Value load_yaml(std::string_view path) = 0;
  virtual std::optional<std::string_view> argument(std::string_view name) = 0;
  virtual std::string absolute_path(std::string_view path) = 0;
  virtual void message(std::string_view function, std::string text) = 0;
  /// A name like one that is undefined.
  virtual std::string name_near(Scope& scope, std::string_view name) = 0;
  /// A value from YAML was used, which is written there.
  virtual void used(Span place) = 0;
};

class Evaluator {
 public:
  Evaluator(Heap& heap, Symbols& symbols, const Bounds& bounds, Host& host)
      : heap_(heap), symbols_(symbols), bounds_(bounds), host_(host) {}

  Value evaluate(const Expression& expression, Scope& scope);

  std::optional<Failure> take_failure() { return std::exchange(failure_, std::nullopt); }

  // For functions.

  Heap& heap() { return heap_; }
  Host& host() { return host_; }
  const Bounds& bounds() const { return bounds_; }

  /// Records why, and gives the error value.
  Value fail(FactKind kind, std::string name, std::string detail = {});
  Value wrong_type(std::string why) { return fail(FactKind::kWrongType, std::move(why)); }
  Value wrong_value(std::string why) { return fail(FactKind::kWrongValue, std::move(why)); }

  /// Counts work; false when it is too much, which is a failure then.
  bool work(std::uint64_t steps) {
    steps_ += steps;
    return (steps_ <= bounds_.steps && !heap_.full()) || fail_of_work();
  }
  /// Whether a list of so many items may be; a failure when not.
  bool fits(std::uint64_t items);

  /// A value of a text, an integer or a list, within the bounds.
  Value text(std::string_view bytes);
  Value number(Value maybe_too_large);
  Value list(std::vector<Value> items);

  Value call(Value callee, Arguments& arguments);
  Value call(Value callee, std::vector<Value> values);

  /// The items of what can be iterated over; iterators are used up.
  std::optional<std::vector<Value>> items_of(Value iterable);

  /// `str(v)` and `repr(v)`; nothing on failure.
  std::optional<std::string> text_of(Value v);
  std::optional<std::string> repr_of(Value v);

  Value binary(Operation operation, Value a, Value b);
  /// A truth value, or an error.
  Value compare(Operation operation, Value a, Value b);
  Value subscript(Value of, Value index);
  Value attribute(Value of, std::string_view name);

 private:
  using Node = ExpressionNode;
  /// Always false.
  bool fail_of_work();
  Value eval(std::uint32_t id);
  Value eval_node(const Node& node);
  Value eval_name(const Node& node);
  Value eval_compare(const Node& node);
  Value eval_unary(const Node& node);
  Value eval_subscript(const Node& node);
  Value eval_call(const Node& node);
  Value eval_items(const Node& node, Type type);
  Value eval_dictionary(const Node& node);
  Value eval_comprehension(const Node& node);
  bool eval_clauses(const Node& node, std::uint32_t clause, std::vector<Entry>& into);
  bool bind(std::uint32_t target, Value value);
  bool gather(const Node& node, Arguments& arguments);
  Value slice_of(Value of, Value index);
  Value item_at(Value of, Value index);
  Value integer_binary(Operation operation, Value a, Value b);
  Value real_binary(Operation operation, double a, double b);
  Value sequence_binary(Operation operation, Value a, Value b);
  Value set_binary(Operation operation, Value a, Value b);
  Value contains(Value item, Value in);
  Value unsupported(Operation operation, Value a, Value b);
  Value call_function(const Function& function, Value self, Arguments& arguments);

  std::uint32_t list_size(std::uint32_t list) const { return expression_->lists[list]; }
  std::uint32_t list_item(std::uint32_t list, std::uint32_t i) const {
    return expression_->lists[list + 1 + i];
  }

  Heap& heap_;
  Symbols& symbols_;
  const Bounds& bounds_;
  Host& host_;
  std::optional<Failure> failure_;
  const Expression* expression_ = nullptr;
  const Node* node_ = nullptr;
  Scope* scope_ = nullptr;
  std::vector<std::pair<Symbol, Value>> locals_;  // of comprehensions under way, innermost last
  std::size_t first_local_ = 0;                   // of this expression
  std::uint64_t steps_ = 0;
  std::uint32_t depth_ = 0;
};

}  // namespace rigor::xacro
