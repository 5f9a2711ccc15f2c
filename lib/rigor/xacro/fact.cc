// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xacro/fact.h>

namespace rigor::xacro {
namespace {

std::string quoted_name(std::string_view name) { return "'" + std::string(name) + "'"; }

std::string did_you_mean_near(const Fact& fact) {
  return fact.near.empty() ? "" : "; did you mean " + quoted_name(fact.near) + "?";
}

}  // namespace

std::string_view name_of(FactKind kind) {
  constexpr std::string_view kNames[] = {"file-not-found",
                                         "not-well-formed",
                                         "yaml",
                                         "missing-attribute",
                                         "bad-text",
                                         "syntax",
                                         "outside-language",
                                         "undefined-name",
                                         "undefined-argument",
                                         "undefined-macro",
                                         "undefined-block",
                                         "undefined-variable",
                                         "unknown-command",
                                         "bad-command",
                                         "package-not-found",
                                         "package-unresolved",
                                         "unknown-parameter",
                                         "missing-parameter",
                                         "missing-block",
                                         "unused-block",
                                         "bad-name",
                                         "property-conflict",
                                         "not-boolean",
                                         "no-parent-scope",
                                         "wrong-type",
                                         "wrong-value",
                                         "division-by-zero",
                                         "no-such-item",
                                         "cycle",
                                         "include-cycle",
                                         "bound-reached",
                                         "fatal",
                                         "message",
                                         "unknown-attribute",
                                         "redefined-builtin",
                                         "redefined-property",
                                         "redefined-macro",
                                         "deprecated-function",
                                         "deprecated-macro-name",
                                         "ignored-children",
                                         "ignored-scope",
                                         "no-match",
                                         "namespace-conflict",
                                         "lost-attribute",
                                         "unused-property",
                                         "unused-macro",
                                         "unused-argument",
                                         "unused-parameter",
                                         "unused-include",
                                         "shadowed-name",
                                         "repeated-parameter",
                                         "degrees",
                                         "missing-prefix",
                                         "constant-condition",
                                         "dead-branch",
                                         "outside-roots"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::string_view name_of(FactFrame::Kind kind) {
  switch (kind) {
    case FactFrame::Kind::kMacro: return "macro";
    case FactFrame::Kind::kInclude: return "include";
    case FactFrame::Kind::kCondition: return "condition";
    case FactFrame::Kind::kBlock: return "block";
  }
  return "";
}

std::string describe(const Fact& f) {
  const std::string name = quoted_name(f.name);
  switch (f.kind) {
    case FactKind::kFileNotFound: return name + " cannot be read: " + f.detail;
    case FactKind::kNotWellFormed: return "not well-formed: " + f.detail;
    case FactKind::kYaml: return "not YAML: " + f.detail;
    case FactKind::kMissingAttribute: return "<" + f.detail + "> has no attribute " + name;
    case FactKind::kBadText:
      return "'$' begins neither ${…} nor $(…): use $$ for a dollar sign before a brace";
    case FactKind::kSyntax: return "the expression has a syntax error: " + f.detail;
    case FactKind::kOutsideLanguage:
      return "rigor does not evaluate this part of Python: " + f.detail;
    case FactKind::kUndefinedName: return name + " is undefined" + did_you_mean_near(f);
    case FactKind::kUndefinedArgument:
      return "argument " + name + " has no value and no default" + did_you_mean_near(f);
    case FactKind::kUndefinedMacro: return "macro " + name + " is undefined" + did_you_mean_near(f);
    case FactKind::kUndefinedBlock: return "block " + name + " is undefined";
    case FactKind::kUndefinedVariable: return "environment variable " + name + " is not set";
    case FactKind::kUnknownCommand:
      return "$(" + f.name + " …) does not exist: use find, arg, env, optenv, eval or cwd";
    case FactKind::kBadCommand: return "$(" + f.name + "): " + f.detail;
    case FactKind::kPackageNotFound:
    case FactKind::kPackageUnresolved: return "package " + name + " is not found";
    case FactKind::kUnknownParameter:
      return "macro '" + f.detail + "' has no parameter " + name + did_you_mean_near(f);
    case FactKind::kMissingParameter: return "macro '" + f.detail + "' needs the parameter " + name;
    case FactKind::kMissingBlock:
      return "macro '" + f.detail + "' needs an element for the block " + name;
    case FactKind::kUnusedBlock:
      return "macro '" + f.detail + "' has no block parameter for <" + f.name + ">";
    case FactKind::kBadName: return name + " is no usable name: " + f.detail;
    case FactKind::kPropertyConflict:
      return "property " + name + " has more than one of value, default and remove";
    case FactKind::kNotBoolean: return name + " is neither true nor false";
    case FactKind::kNoParentScope:
      return "property " + name + ": scope=\"parent\" outside of a macro";
    case FactKind::kWrongType:
    case FactKind::kWrongValue: return f.name;
    case FactKind::kDivisionByZero: return "division by zero";
    case FactKind::kNoSuchItem: return f.detail;
    case FactKind::kCycle: return "properties need each other: " + f.detail;
    case FactKind::kIncludeCycle: return name + " includes itself without end";
    case FactKind::kBoundReached: return f.detail + " exceeds the limit";
    case FactKind::kFatal: return "xacro.fatal: " + f.detail;
    case FactKind::kMessage: return "xacro." + f.name + ": " + f.detail;
    case FactKind::kUnknownAttribute: return "<" + f.detail + "> ignores the attribute " + name;
    case FactKind::kRedefinedBuiltin:
      return "property " + name + " hides a function or constant of that name";
    case FactKind::kRedefinedProperty: return "property " + name + " is defined again";
    case FactKind::kRedefinedMacro: return "macro " + name + " is defined again";
    case FactKind::kDeprecatedFunction:
      return f.name + "() is deprecated: use " + f.detail + "." + f.name + "()";
    case FactKind::kDeprecatedMacroName:
      return "macro name " + name + " must not have the prefix xacro:";
    case FactKind::kIgnoredChildren: return "elements within <xacro:include> are ignored";
    case FactKind::kIgnoredScope: return "property " + name + " with a default ignores its scope";
    case FactKind::kNoMatch: return "no file matches " + name;
    case FactKind::kNamespaceConflict:
      return name + " is another namespace here: '" + f.detail + "'";
    case FactKind::kLostAttribute:
      return "attribute " + name + " is lost: <xacro:attribute> is in no element";
    case FactKind::kUnusedProperty: return "property " + name + " is not used";
    case FactKind::kUnusedMacro: return "macro " + name + " is not called";
    case FactKind::kUnusedArgument: return "argument " + name + " is not used";
    case FactKind::kUnusedParameter:
      return "parameter " + name + " of macro '" + f.detail + "' is not used";
    case FactKind::kUnusedInclude: return "nothing of " + name + " is used";
    case FactKind::kShadowedName: return name + " hides a name of an outer scope";
    case FactKind::kRepeatedParameter:
      return "macro '" + f.detail + "' lists parameter " + name + " twice";
    case FactKind::kDegrees:
      return f.name + "(" + f.detail.substr(0, f.detail.find(' ')) +
             ") takes radians: " + f.detail + " looks like degrees";
    case FactKind::kMissingPrefix:
      return "<" + f.name + "> is written like a call of macro " + name + " without xacro:";
    case FactKind::kConstantCondition: return "the condition is always " + name;
    case FactKind::kDeadBranch: return "no set of arguments takes this branch";
    case FactKind::kOutsideRoots: return name + " is outside of the packages and of the repository";
  }
  return {};
}

}  // namespace rigor::xacro
