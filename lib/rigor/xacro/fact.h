// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the expander found, as data: errors, which the reference fails on too, and remarks on what it
// takes. `describe` gives the words; the place, the names and the stack of macro calls go with them.
//
//   for (const Fact& fact : expansion.facts) say(fact.where, describe(fact));

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/text/span.h>

namespace rigor::xacro {

enum class FactKind : std::uint8_t {
  // Errors: the result is not what the author wants, or there is none.
  kFileNotFound,      ///< `name` is the path, `detail` why it cannot be read
  kNotWellFormed,     ///< `detail` says what is wrong
  kYaml,              ///< a YAML file that cannot be parsed; `name` is its path
  kMissingAttribute,  ///< `name` the attribute, `detail` the tag
  kBadText,           ///< `$` that begins neither `${…}` nor `$(…)`
  kSyntax,            ///< an expression that is none; `detail` says what was expected
  kOutsideLanguage,   ///< Python that rigor does not evaluate: `lambda`, names with `__`
  kUndefinedName,     ///< no property, parameter or function `name`; `near` is one like it
  kUndefinedArgument,
  kUndefinedMacro,
  kUndefinedBlock,
  kUndefinedVariable,  ///< of the environment
  kUnknownCommand,     ///< `$(name …)`
  kBadCommand,         ///< `$(find)` without a package and such; `detail` says it
  kPackageNotFound,
  kPackageUnresolved,  ///< the same, where only texts of the result name its folder
  kUnknownParameter,   ///< an attribute of a call that the macro `detail` has no parameter for
  kMissingParameter,   ///< a parameter without default that a call does not give
  kMissingBlock,       ///< a call with fewer elements in it than the macro has block parameters
  kUnusedBlock,        ///< a call with more
  kBadName,            ///< of a property or macro; `detail` says why
  kPropertyConflict,   ///< more than one of value, default and remove
  kNotBoolean,         ///< `name` is what the condition evaluated to
  kNoParentScope,      ///< scope="parent" outside of macros
  kWrongType,          ///< an operation that its operands do not have
  kWrongValue,         ///< a value that a function does not take
  kDivisionByZero,
  kNoSuchItem,  ///< a key, index or attribute that a value does not have
  kCycle,       ///< properties that need each other; `detail` is the cycle
  kIncludeCycle,
  kBoundReached,  ///< `detail` names the bound
  kFatal,         ///< `xacro.fatal(…)`
  // Remarks: the reference takes it, some of them with a warning.
  kMessage,            ///< what `xacro.warning(…)` and its like say; `name` is the function
  kUnknownAttribute,   ///< of a xacro tag, which ignores it
  kRedefinedBuiltin,   ///< a property with the name of a function or constant
  kRedefinedProperty,  ///< `related` is the definition before
  kRedefinedMacro,
  kDeprecatedFunction,   ///< `sorted(…)` for `python.sorted(…)`; `detail` is the namespace
  kDeprecatedMacroName,  ///< `name="xacro:leg"` of a macro
  kIgnoredChildren,      ///< elements within an include
  kIgnoredScope,         ///< scope on a property with a default
  kNoMatch,              ///< an include's pattern matches no file
  kNamespaceConflict,    ///< an xmlns of an included file that says otherwise here
  kLostAttribute,  ///< `xacro:attribute` directly in a macro or conditional, which has no effect
  kUnusedProperty,
  kUnusedMacro,
  kUnusedArgument,
  kUnusedParameter,    ///< `detail` is the macro
  kUnusedInclude,      ///< nothing that the file defines is used, and it brings no elements
  kShadowedName,       ///< a parameter or property that hides one of an outer scope
  kRepeatedParameter,  ///< a macro that lists a parameter twice
  kDegrees,            ///< `sin(90)`: `name` is the function, `detail` the number, or "tilt = 90"
  kMissingPrefix,      ///< an element with the name and the parameters of a macro
  kConstantCondition,  ///< of `if` or `unless`, that no argument decides; `name` is it
  kDeadBranch,         ///< an `if` or `unless` that no set of arguments takes
  kOutsideRoots,  ///< a file that is read from a place that no argument names; `name` is its path
};

constexpr bool is_error(FactKind kind) { return kind <= FactKind::kFatal; }

/// The name of a kind as machines read it: "undefined-name".
std::string_view name_of(FactKind kind);

struct FactParameter {
  std::string name;
  std::string value;
};

/// One level of what brought a place into the result, innermost first.
struct FactFrame {
  enum class Kind : std::uint8_t { kMacro, kInclude, kCondition, kBlock };
  Kind kind = Kind::kMacro;
  Span where;                                  ///< of the tag: the call, the include, the condition
  std::string name;                            ///< of the macro, the file, the condition, the block
  std::vector<FactParameter> parameters = {};  ///< of a macro call, with their values
};

/// "macro", "include", "condition" or "block".
std::string_view name_of(FactFrame::Kind kind);

struct Fact {
  FactKind kind = FactKind::kSyntax;
  Span where;
  std::string name = {};
  std::string detail = {};
  std::string near = {};  ///< a name that exists and is spelled much like `name`
  Span related = {};      ///< the definition that matters, or where a lazy value is used
  std::vector<FactFrame> stack = {};  ///< of the first occurrence
  std::uint32_t count = 1;            ///< instances of a macro that show the same
};

/// The finding in words: lower case, without a full stop.
std::string describe(const Fact& fact);

}  // namespace rigor::xacro
