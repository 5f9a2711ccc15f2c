// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Recursive descent over Python's expression grammar (its reference, chapter 6), binary operators by
// precedence.

#include <algorithm>
#include <array>
#include <utility>

#include <rigor/xacro/bounds.h>
#include <rigor/xacro/expression/expression.h>
#include <rigor/xacro/expression/lexer.h>
#include <rigor/xacro/value/heap.h>
#include <rigor/xacro/value/number_text.h>

namespace rigor::xacro {
namespace {

constexpr std::array<std::string_view, 35> kKeywords{
    "False", "None",     "True",  "and",    "as",   "assert", "async",  "await",    "break",
    "class", "continue", "def",   "del",    "elif", "else",   "except", "finally",  "for",
    "from",  "global",   "if",    "import", "in",   "is",     "lambda", "nonlocal", "not",
    "or",    "pass",     "raise", "return", "try",  "while",  "with",   "yield"};

bool is_keyword(std::string_view word) {
  constexpr std::size_t kLongest = 8;
  if (word.size() > kLongest) return false;
  return std::any_of(kKeywords.begin(), kKeywords.end(), [word](std::string_view keyword) {
    return keyword[0] == word[0] && keyword == word;
  });
}

struct BinaryOperator {
  std::uint32_t code;
  int precedence;
  Operation operation;
};
constexpr std::array<BinaryOperator, 11> kBinaryOperators{
    {{operator_code("|"), 1, Operation::kBitOr},
     {operator_code("^"), 2, Operation::kBitXor},
     {operator_code("&"), 3, Operation::kBitAnd},
     {operator_code("<<"), 4, Operation::kShiftLeft},
     {operator_code(">>"), 4, Operation::kShiftRight},
     {operator_code("+"), 5, Operation::kAdd},
     {operator_code("-"), 5, Operation::kSubtract},
     {operator_code("*"), 6, Operation::kMultiply},
     {operator_code("/"), 6, Operation::kDivide},
     {operator_code("//"), 6, Operation::kFloorDivide},
     {operator_code("%"), 6, Operation::kModulo}}};
constexpr int kLowestPrecedence = 1;

constexpr std::array<std::pair<std::uint32_t, Operation>, 6> kComparisons{
    {{operator_code("<"), Operation::kLess},
     {operator_code("<="), Operation::kLessEqual},
     {operator_code(">"), Operation::kGreater},
     {operator_code(">="), Operation::kGreaterEqual},
     {operator_code("=="), Operation::kEqual},
     {operator_code("!="), Operation::kNotEqual}}};

using NodeId = std::uint32_t;
using NodeList = std::vector<NodeId>;

/// Room for the nodes of an expression as most are.
constexpr std::size_t kFirstNodes = 12;

/// Levels of the tree. A sum of 1,000 terms is a tree of 1,000 levels, which Python compiles, too.
constexpr std::uint16_t kMaxTreeDepth = 1'000;

class Parser {
 public:
  Parser(std::string_view text, Heap& heap, Symbols& symbols, std::pmr::memory_resource& memory)
      : heap_(heap),
        symbols_(symbols),
        lexer_(text),
        result_{text, std::pmr::vector<ExpressionNode>(&memory),
                std::pmr::vector<std::uint32_t>(&memory)} {}

  Expression run() {
    if (result_.text.size() > kMaxExpressionBytes) {
      fail(FactKind::kBoundReached, 0, 0,
           "an expression of " + std::to_string(kMaxExpressionBytes) + " bytes");
      return std::move(result_);
    }
    advance();
    if (!failed() && at_end()) fail(FactKind::kSyntax, 0, 0, "an empty expression");
    if (is_one_name()) {
      result_.root = parse_name();
    } else {
      result_.nodes.reserve(std::min(result_.text.size() / 2 + 1, kFirstNodes));
      result_.root = parse_tuple();
    }
    if (!failed() && !at_end()) unexpected();
    return std::move(result_);
  }

 private:
  bool failed() const { return result_.trouble.has_value(); }
  bool at_end() const { return token_.type == TokenType::kEnd; }

  NodeId fail(FactKind kind, std::uint32_t begin, std::uint32_t end, std::string detail) {
    if (!failed()) result_.trouble = ExpressionTrouble{kind, begin, end, std::move(detail)};
    token_ = {};
    return kNoNode;
  }

  NodeId unexpected() {
    if (at_end()) return fail(FactKind::kSyntax, token_.begin, token_.end, "an end too early");
    const std::string_view word = result_.text.substr(token_.begin, token_.end - token_.begin);
    if (word == "lambda" || word == "await" || word == "yield") return outside(std::string(word));
    if (word == ":=") return outside("assignments (:=)");
    if (word == "@") return outside("the matrix product (@)");
    if (word == "...") return outside("the ellipsis (...)");
    return fail(FactKind::kSyntax, token_.begin, token_.end, "'" + std::string(word) + "'");
  }

  /// As most expressions are: `${prefix}` needs no way down through the operators.
  bool is_one_name() const {
    return token_.type == TokenType::kName && token_.end == result_.text.size() &&
           !is_keyword(word());
  }

  NodeId outside(std::string what) {
    return fail(FactKind::kOutsideLanguage, token_.begin, token_.end, std::move(what));
  }

  void advance() {
    if (failed()) return;
    before_ = token_.end;
    token_ = lexer_.next();
    if (token_.type == TokenType::kTrouble)
      fail(token_.trouble, token_.begin, token_.end, std::string(token_.text));
  }

  std::string_view word() const {
    return result_.text.substr(token_.begin, token_.end - token_.begin);
  }
  bool is_operator(std::string_view text) const { return token_.code == operator_code(text); }
  /// Most differ in their length or first byte.
  bool is_word(std::string_view text) const {
    return token_.type == TokenType::kName && token_.end - token_.begin == text.size() &&
           result_.text[token_.begin] == text[0] && word() == text;
  }
  bool take(std::string_view op) {
    if (!is_operator(op)) return false;
    advance();
    return true;
  }
  bool take_word(std::string_view text) {
    if (!is_word(text)) return false;
    advance();
    return true;
  }
  void expect(std::string_view op) {
    if (!take(op)) unexpected();
  }

  std::uint16_t depth_of(NodeId id) const { return id == kNoNode ? 0 : result_.nodes[id].depth; }

  NodeId add(ExpressionNode node, std::uint16_t below) {
    if (failed()) return kNoNode;
    node.end = before_;
    node.depth = static_cast<std::uint16_t>(below + 1);
    if (node.depth > kMaxTreeDepth) {
      return fail(FactKind::kBoundReached, node.begin, node.end, "the depth of an expression");
    }
    result_.nodes.push_back(node);
    return static_cast<NodeId>(result_.nodes.size() - 1);
  }
  NodeId add(ExpressionNode node) {
    return add(node, std::max({depth_of(node.a),
                               node.op == Op::kCompare || has_list(node.op) ? std::uint16_t{0}
                                                                            : depth_of(node.b),
                               depth_of(node.c)}));
  }
  static bool has_list(Op op) {
    return op == Op::kCall || op == Op::kList || op == Op::kTuple || op == Op::kSet ||
           op == Op::kDictionary || op == Op::kListOf || op == Op::kSetOf ||
           op == Op::kDictionaryOf || op == Op::kGenerator;
  }
  NodeId add_with_list(ExpressionNode node, const NodeList& list) {
    std::uint16_t below = std::max(depth_of(node.a), depth_of(node.c));
    for (const NodeId id : list) below = std::max(below, depth_of(id));
    node.b = static_cast<std::uint32_t>(result_.lists.size());
    result_.lists.push_back(static_cast<std::uint32_t>(list.size()));
    result_.lists.insert(result_.lists.end(), list.begin(), list.end());
    return add(node, below);
  }
  NodeId constant(std::uint32_t begin, Value value) {
    ExpressionNode node{Op::kConstant, {}, 1, begin};
    node.constant = value;
    return add(node);
  }

  /// `a, b` without parentheses is a tuple at the top and in subscripts.
  NodeId parse_tuple() {
    const std::uint32_t begin = token_.begin;
    const NodeId first = parse_item();
    if (!is_operator(",")) return first;
    NodeList items{first};
    while (!failed() && take(",")) {
      if (at_end() || is_operator("]") || is_operator(")")) break;
      items.push_back(parse_item());
    }
    return add_with_list({Op::kTuple, {}, 1, begin}, items);
  }

  NodeId parse_item() {
    const std::uint32_t begin = token_.begin;
    if (!take("*")) return parse_expression();
    const NodeId inner = parse_binary(kLowestPrecedence);
    return add({Op::kStarred, {}, 1, begin, 0, inner});
  }

  NodeId parse_expression() {
    if (failed() || !enter()) return kNoNode;
    const std::uint32_t begin = token_.begin;
    NodeId result = parse_or();
    if (is_word("if")) {
      advance();
      const NodeId condition = parse_or();
      if (!take_word("else")) unexpected();
      const NodeId other = parse_expression();
      result = add({Op::kConditional, {}, 1, begin, 0, result, condition, other});
    }
    --level_;
    return result;
  }

  bool enter() {
    if (++level_ <= kMaxExpressionDepth) return true;
    fail(FactKind::kBoundReached, token_.begin, token_.end, "the depth of an expression");
    return false;
  }

  NodeId parse_or() {
    const std::uint32_t begin = token_.begin;
    NodeId left = parse_and();
    while (take_word("or")) {
      const NodeId right = parse_and();
      left = add({Op::kOr, {}, 1, begin, 0, left, right});
    }
    return left;
  }

  NodeId parse_and() {
    const std::uint32_t begin = token_.begin;
    NodeId left = parse_not();
    while (take_word("and")) {
      const NodeId right = parse_not();
      left = add({Op::kAnd, {}, 1, begin, 0, left, right});
    }
    return left;
  }

  NodeId parse_not() {
    if (failed() || !is_word("not")) return parse_comparison();
    const std::uint32_t begin = token_.begin;
    if (!enter()) return kNoNode;
    advance();
    const NodeId inner = parse_not();
    --level_;
    return add({Op::kNot, {}, 1, begin, 0, inner});
  }

  std::optional<Operation> take_comparison() {
    if (token_.type == TokenType::kOperator) {
      for (const auto& [code, operation] : kComparisons) {
        if (token_.code != code) continue;
        advance();
        return operation;
      }
      return std::nullopt;
    }
    if (take_word("in")) return Operation::kIn;
    if (take_word("is")) return take_word("not") ? Operation::kIsNot : Operation::kIs;
    if (is_word("not")) {
      advance();
      if (!take_word("in")) unexpected();
      return Operation::kNotIn;
    }
    return std::nullopt;
  }

  NodeId parse_comparison() {
    const std::uint32_t begin = token_.begin;
    const NodeId first = parse_binary(kLowestPrecedence);
    NodeList rest;
    while (!failed()) {
      const std::uint32_t at = token_.begin;
      const std::optional<Operation> operation = take_comparison();
      if (!operation) break;
      const NodeId right = parse_binary(kLowestPrecedence);
      rest.push_back(add({Op::kComparison, *operation, 1, at, 0, right}));
    }
    if (rest.empty()) return first;
    return add_with_list({Op::kCompare, {}, 1, begin, 0, first}, rest);
  }

  NodeId parse_binary(int lowest) {
    if (failed()) return kNoNode;
    const std::uint32_t begin = token_.begin;
    NodeId left = parse_unary();
    while (!failed() && token_.type == TokenType::kOperator) {
      const auto* found = std::find_if(kBinaryOperators.begin(), kBinaryOperators.end(),
                                       [this](const auto& o) { return o.code == token_.code; });
      if (found == kBinaryOperators.end() || found->precedence < lowest) break;
      advance();
      const NodeId right = parse_binary(found->precedence + 1);
      left = add({Op::kBinary, found->operation, 1, begin, 0, left, right});
    }
    return left;
  }

  NodeId parse_unary() {
    if (failed()) return kNoNode;
    if (token_.type != TokenType::kOperator) return parse_power();
    const std::uint32_t begin = token_.begin;
    const Operation operation = is_operator("-")   ? Operation::kNegate
                                : is_operator("+") ? Operation::kPlus
                                                   : Operation::kInvert;
    if (!is_operator("-") && !is_operator("+") && !is_operator("~")) return parse_power();
    if (!enter()) return kNoNode;
    advance();
    const NodeId inner = parse_unary();
    --level_;
    return add({Op::kUnary, operation, 1, begin, 0, inner});
  }

  /// Binds tighter than a sign before it, and less tight than one behind it: -2**-2.
  NodeId parse_power() {
    const std::uint32_t begin = token_.begin;
    const NodeId base = parse_primary();
    if (!is_operator("**")) return base;
    if (!enter()) return kNoNode;
    advance();
    const NodeId exponent = parse_unary();
    --level_;
    return add({Op::kBinary, Operation::kPower, 1, begin, 0, base, exponent});
  }

  NodeId parse_primary() {
    const std::uint32_t begin = token_.begin;
    NodeId node = parse_atom();
    while (!failed() && token_.type == TokenType::kOperator) {
      if (take(".")) {
        if (token_.type != TokenType::kName || is_keyword(word())) return unexpected();
        const Symbol symbol = name_symbol();
        advance();
        node = add({Op::kAttribute, {}, 1, begin, 0, node, kNoNode, kNoNode, symbol});
      } else if (is_operator("(")) {
        node = parse_call(begin, node);
      } else if (take("[")) {
        const NodeId index = parse_subscript();
        expect("]");
        node = add({Op::kSubscript, {}, 1, begin, 0, node, index});
      } else {
        break;
      }
    }
    return node;
  }

  /// Python's own names are what a template must not reach.
  Symbol name_symbol() {
    if (word().starts_with("__")) {
      outside("the name " + std::string(word()) + ", for its double underscore");
      return 0;
    }
    return symbols_.of(word());
  }

  NodeId parse_name() {
    const std::uint32_t begin = token_.begin;
    const Symbol symbol = name_symbol();
    advance();
    return add({Op::kName, {}, 1, begin, 0, kNoNode, kNoNode, kNoNode, symbol});
  }

  NodeId parse_subscript() {
    const std::uint32_t begin = token_.begin;
    const NodeId first = parse_slice();
    if (!is_operator(",")) return first;
    NodeList items{first};
    while (!failed() && take(",")) {
      if (is_operator("]")) break;
      items.push_back(parse_slice());
    }
    return add_with_list({Op::kTuple, {}, 1, begin}, items);
  }

  NodeId parse_slice() {
    const std::uint32_t begin = token_.begin;
    NodeId parts[3] = {kNoNode, kNoNode, kNoNode};
    if (!is_operator(":")) parts[0] = parse_expression();
    if (!is_operator(":")) return parts[0];
    for (int i = 1; i < 3 && take(":"); ++i) {
      if (!is_operator(":") && !is_operator("]") && !is_operator(","))
        parts[i] = parse_expression();
    }
    return add({Op::kSlice, {}, 1, begin, 0, parts[0], parts[1], parts[2]});
  }

  NodeId parse_call(std::uint32_t begin, NodeId callee) {
    if (!enter()) return kNoNode;
    advance();
    NodeList arguments;
    while (!failed() && !is_operator(")")) {
      arguments.push_back(parse_argument(arguments.empty()));
      if (!take(",")) break;
    }
    expect(")");
    --level_;
    return add_with_list({Op::kCall, {}, 1, begin, 0, callee}, arguments);
  }

  NodeId parse_argument(bool first) {
    const std::uint32_t begin = token_.begin;
    if (take("**")) {
      const NodeId inner = parse_expression();
      return add({Op::kDoubleStarred, {}, 1, begin, 0, inner});
    }
    const NodeId value = parse_item();
    if (failed()) return kNoNode;
    if (is_operator("=")) {
      const ExpressionNode name = result_.nodes[value];
      if (name.op != Op::kName) return unexpected();
      advance();
      const NodeId given = parse_expression();
      return add({Op::kKeyword, {}, 1, begin, 0, given, kNoNode, kNoNode, name.symbol});
    }
    if (is_word("for") && first)
      return parse_comprehension({Op::kGenerator, {}, 1, begin, 0, value});
    return value;
  }

  NodeId parse_comprehension(ExpressionNode node) {
    NodeList clauses;
    while (!failed() && (is_word("for") || is_word("if") || is_word("async"))) {
      const std::uint32_t begin = token_.begin;
      if (take_word("if")) {
        const NodeId condition = parse_or();
        clauses.push_back(add({Op::kFilter, {}, 1, begin, 0, condition}));
        continue;
      }
      if (!take_word("for")) return unexpected();
      const NodeId target = parse_target();
      if (!take_word("in")) return unexpected();
      const NodeId iterable = parse_or();
      clauses.push_back(add({Op::kFor, {}, 1, begin, 0, target, iterable}));
    }
    return add_with_list(node, clauses);
  }

  NodeId parse_target() {
    const std::uint32_t begin = token_.begin;
    NodeList names;
    bool tuple = false;
    do {
      if (is_word("in")) break;
      names.push_back(parse_target_part());
      if (is_operator(",")) tuple = true;
    } while (!failed() && take(","));
    if (names.size() == 1 && !tuple) return names[0];
    return add_with_list({Op::kTuple, {}, 1, begin}, names);
  }

  NodeId parse_target_part() {
    const bool round = is_operator("(");
    if (round || is_operator("[")) {
      if (!enter()) return kNoNode;
      advance();
      const NodeId inner = parse_target();
      expect(round ? ")" : "]");
      --level_;
      return inner;
    }
    if (token_.type != TokenType::kName || is_keyword(word())) return unexpected();
    const std::uint32_t begin = token_.begin;
    const Symbol symbol = name_symbol();
    advance();
    return add({Op::kName, {}, 1, begin, 0, kNoNode, kNoNode, kNoNode, symbol});
  }

  NodeId parse_atom() {
    if (failed()) return kNoNode;
    const std::uint32_t begin = token_.begin;
    switch (token_.type) {
      case TokenType::kNumber: return parse_number();
      case TokenType::kText: return parse_texts();
      case TokenType::kName: {
        if (take_word("None")) return constant(begin, Value::none());
        if (take_word("True")) return constant(begin, Value::boolean(true));
        if (take_word("False")) return constant(begin, Value::boolean(false));
        if (is_keyword(word())) return unexpected();
        return parse_name();
      }
      default: break;
    }
    if (is_operator("(")) return parse_round();
    if (is_operator("[")) return parse_square();
    if (is_operator("{")) return parse_curly();
    return unexpected();
  }

  NodeId parse_number() {
    const std::uint32_t begin = token_.begin;
    if (const Value number = plain_decimal(word()); !number.failed()) {
      advance();
      return constant(begin, number);
    }
    std::string digits(word());
    std::erase(digits, '_');
    advance();
    const bool prefixed =
        digits.size() > 1 && digits[0] == '0' && digits.find_first_of("xXoObB") == 1;
    if (!prefixed && digits.find_first_of(".eE") != std::string::npos) {
      return constant(begin, Value::real(plain_real(digits).value_or(0)));
    }
    const Value number = integer_from_text(heap_, digits, 0);
    if (number.failed())
      return fail(FactKind::kBoundReached, begin, before_, "the digits of a number");
    return constant(begin, number);
  }

  NodeId parse_texts() {
    const std::uint32_t begin = token_.begin;
    // Most are one alone, and a part of the expression, which lives as long.
    const std::string_view first = token_.text;
    const bool is_part = first.data() >= result_.text.data() &&
                         first.data() + first.size() <= result_.text.data() + result_.text.size();
    std::string text(is_part ? std::string_view() : first);
    advance();
    if (is_part) {
      if (token_.type != TokenType::kText) return constant(begin, Value::text(first));
      text = first;
    }
    while (token_.type == TokenType::kText) {
      text += token_.text;
      advance();
    }
    return constant(begin, heap_.text(text));
  }

  NodeId parse_round() {
    const std::uint32_t begin = token_.begin;
    if (!enter()) return kNoNode;
    advance();
    NodeId result = kNoNode;
    if (take(")")) {
      result = add_with_list({Op::kTuple, {}, 1, begin}, {});
    } else {
      result = parse_tuple();
      if (is_word("for")) result = parse_comprehension({Op::kGenerator, {}, 1, begin, 0, result});
      expect(")");
    }
    --level_;
    return result;
  }

  NodeId parse_square() {
    const std::uint32_t begin = token_.begin;
    if (!enter()) return kNoNode;
    advance();
    NodeList items;
    while (!failed() && !is_operator("]")) {
      items.push_back(parse_item());
      if (is_word("for") && items.size() == 1) {
        const NodeId result = parse_comprehension({Op::kListOf, {}, 1, begin, 0, items[0]});
        expect("]");
        --level_;
        return result;
      }
      if (!take(",")) break;
    }
    expect("]");
    --level_;
    return add_with_list({Op::kList, {}, 1, begin}, items);
  }

  NodeId parse_curly() {
    const std::uint32_t begin = token_.begin;
    if (!enter()) return kNoNode;
    advance();
    NodeList items;
    bool dictionary = is_operator("}");
    while (!failed() && !is_operator("}")) {
      const std::uint32_t at = token_.begin;
      NodeId value = kNoNode;
      if (take("**")) {
        dictionary = true;
        const NodeId inner = parse_binary(kLowestPrecedence);
        items.push_back(add({Op::kDoubleStarred, {}, 1, at, 0, inner}));
      } else {
        items.push_back(parse_item());
        if (take(":")) {
          dictionary = true;
          value = parse_expression();
        }
      }
      if (is_word("for")) {
        const NodeId result = parse_comprehension({dictionary ? Op::kDictionaryOf : Op::kSetOf,
                                                   {},
                                                   1,
                                                   begin,
                                                   0,
                                                   items[0],
                                                   kNoNode,
                                                   value});
        expect("}");
        --level_;
        return result;
      }
      if (dictionary) items.push_back(value);
      if (!take(",")) break;
    }
    expect("}");
    --level_;
    // A set's items beside a dictionary's.
    for (std::size_t i = 1; dictionary && !failed() && i < items.size(); i += 2) {
      if (items[i] == kNoNode && result_.nodes[items[i - 1]].op != Op::kDoubleStarred) {
        return fail(FactKind::kSyntax, begin, before_, "a dictionary's key without a value");
      }
    }
    return add_with_list({dictionary ? Op::kDictionary : Op::kSet, {}, 1, begin}, items);
  }

  Heap& heap_;
  Symbols& symbols_;
  Lexer lexer_;
  Expression result_;
  Token token_;
  std::uint32_t before_ = 0;  // end of the token before
  std::uint32_t level_ = 0;
};

}  // namespace

std::string_view to_string(Operation operation) {
  constexpr std::array<std::string_view, 26> kTexts{
      "+", "-", "*", "/", "//", "%", "**", "@",  "<<", ">>", "&",      "|",  "^",
      "-", "+", "~", "<", "<=", ">", ">=", "==", "!=", "in", "not in", "is", "is not"};
  return kTexts[static_cast<std::size_t>(operation)];
}

Expression parse_expression(std::string_view text, Heap& heap, Symbols& symbols,
                            std::pmr::memory_resource& memory) {
  return Parser(text, heap, symbols, memory).run();
}

bool is_identifier(std::string_view text) { return is_name(text) && !is_keyword(text); }

}  // namespace rigor::xacro
