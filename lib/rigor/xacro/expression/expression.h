// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A parsed expression: a tree in one flat array, evaluated as often as its text occurs. A text that is
// no expression keeps its trouble, which each evaluation reports.

#pragma once

#include <cstdint>
#include <memory_resource>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/xacro/fact.h>
#include <rigor/xacro/value/symbol.h>
#include <rigor/xacro/value/value.h>

namespace rigor::xacro {

class Heap;

enum class Op : std::uint8_t {
  kConstant,
  kName,  ///< `symbol`
  kOr,    ///< a, b
  kAnd,
  kNot,            ///< a
  kCompare,        ///< a first operand, list b of operators' nodes
  kComparison,     ///< `operation` with a right operand a, within a kCompare
  kBinary,         ///< a, b, `operation`
  kUnary,          ///< a, `operation`
  kConditional,    ///< a if b else c
  kAttribute,      ///< a, `symbol`
  kSubscript,      ///< a[b]
  kSlice,          ///< a:b:c, each may be kNoNode
  kCall,           ///< a called with list b
  kStarred,        ///< *a, in calls and lists
  kDoubleStarred,  ///< **a
  kKeyword,        ///< symbol=a, in calls
  kList,           ///< list b
  kTuple,
  kSet,
  kDictionary,  ///< list b: key, value, key, value …; kDoubleStarred with kNoNode behind it
  kListOf,      ///< comprehensions: element a (value c of a dictionary), list b of clauses
  kSetOf,
  kDictionaryOf,
  kGenerator,
  kFor,     ///< clause: target a in b
  kFilter,  ///< clause: if a
};

enum class Operation : std::uint8_t {
  kAdd,
  kSubtract,
  kMultiply,
  kDivide,
  kFloorDivide,
  kModulo,
  kPower,
  kMatrix,
  kShiftLeft,
  kShiftRight,
  kBitAnd,
  kBitOr,
  kBitXor,
  kNegate,
  kPlus,
  kInvert,
  kLess,
  kLessEqual,
  kGreater,
  kGreaterEqual,
  kEqual,
  kNotEqual,
  kIn,
  kNotIn,
  kIs,
  kIsNot,
};

/// As it is written: "+", "not in".
std::string_view to_string(Operation operation);

inline constexpr std::uint32_t kNoNode = 0xffffffffU;

struct ExpressionNode {
  Op op = Op::kConstant;
  Operation operation = Operation::kAdd;
  std::uint16_t depth = 1;
  std::uint32_t begin = 0;  ///< byte offsets in the text
  std::uint32_t end = 0;
  std::uint32_t a = kNoNode;
  std::uint32_t b = kNoNode;
  std::uint32_t c = kNoNode;
  Symbol symbol = 0;
  Value constant = {};
};

struct ExpressionTrouble {
  FactKind kind = FactKind::kSyntax;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  std::string detail;
};

struct Expression {
  std::string_view text;
  std::pmr::vector<ExpressionNode> nodes;
  std::pmr::vector<std::uint32_t> lists;  ///< a list is its size, then its nodes
  std::uint32_t root = kNoNode;
  std::optional<ExpressionTrouble> trouble;
  /// The call of a trigonometric function with a whole number of degrees in it, else the first with a name alone, of
  /// which only its value tells.
  std::uint32_t degrees = kNoNode;
};

/// `text` must live as long as the expression; so must the heap, the symbols and the memory of its nodes.
Expression parse_expression(std::string_view text, Heap& heap, Symbols& symbols,
                            std::pmr::memory_resource& memory = *std::pmr::get_default_resource());

/// No angle in radians is a whole number over 6.
inline constexpr std::int64_t kMostRadians = 6;

/// Of `Expression::degrees`: `sin(90)`, `math.cos(180)`, `sin(tilt)`.
std::uint32_t find_degrees(const Expression& expression, const Symbols& symbols);

/// Whether Python takes it for a name: letters, digits and `_`, no keyword.
bool is_identifier(std::string_view text);

}  // namespace rigor::xacro
