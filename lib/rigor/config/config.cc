// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/config/config.h>

#include <iterator>
#include <utility>

namespace rigor::config {
namespace {

template <class T>
void append(std::vector<T>& list, std::vector<T> more) {
  list.insert(list.end(), std::make_move_iterator(more.begin()),
              std::make_move_iterator(more.end()));
}

/// Adds the entries of `base` that have a name of their own.
template <class Map>
void add_missing(Map& map, Map base) {
  map.merge(base);
}

template <class T>
void default_to(std::optional<T>& value, std::optional<T> base) {
  if (!value) value = std::move(base);
}

RuleChoice over(RuleChoice choice, RuleChoice base) {
  default_to(choice.select, std::move(base.select));
  append(base.ignore, std::move(choice.ignore));
  choice.ignore = std::move(base.ignore);
  add_missing(choice.severity, std::move(base.severity));
  return choice;
}

}  // namespace

Config extended(Config config, Config base) {
  append(config.files, std::move(base.files));
  config.rules = over(std::move(config.rules), std::move(base.rules));
  default_to(config.fail_on, std::move(base.fail_on));
  default_to(config.targets, std::move(base.targets));
  append(config.exclude, std::move(base.exclude));
  default_to(config.baseline, std::move(base.baseline));
  // The base's come first: of two that cover a file the later one counts.
  append(base.per_file, std::move(config.per_file));
  config.per_file = std::move(base.per_file);
  append(config.resolve_paths, std::move(base.resolve_paths));
  add_missing(config.resolve_packages, std::move(base.resolve_packages));
  add_missing(config.materials, std::move(base.materials));
  append(config.templates, std::move(base.templates));
  default_to(config.layout.indent, std::move(base.layout.indent));
  default_to(config.layout.width, base.layout.width);
  default_to(config.layout.quotes, std::move(base.layout.quotes));
  default_to(config.layout.order, std::move(base.layout.order));
  append(config.problems, std::move(base.problems));
  return config;
}

RuleChoice rules_for(const Config& config, std::string_view path) {
  RuleChoice choice = config.rules;
  for (const PerFile& each : config.per_file) {
    if (each.files.covers(path, PathKind::kFile)) choice = over(each.rules, std::move(choice));
  }
  return choice;
}

const Name* excluding(const Config& config, std::string_view path, PathKind kind) {
  for (const PathPatterns& list : config.exclude) {
    if (const Name* pattern = list.covering(path, kind)) return pattern;
  }
  return nullptr;
}

}  // namespace rigor::config
