// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
#include <rigor/schema/schema.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <utility>

#include <rigor/schema/tables.h>

namespace rigor::schema {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};

bool named(const Entry& entry, std::string_view name) {
  return entry.length == name.size() && entry.name[0] == name[0] &&
         std::memcmp(entry.name, name.data(), name.size()) == 0;
}

// The entry of that name which exists in this version; kNone when there is none.
std::uint32_t find(const Tables& tables, std::uint32_t first, std::uint32_t last,
                   std::string_view name, int minor) {
  const VersionSet now = only(minor);
  for (std::uint32_t i = first; i < last; ++i) {
    if (named(tables.entries[i], name) && (tables.entries[i].exists & now) != 0) return i;
  }
  return kNone;
}

struct Elsewhere {
  std::uint32_t entry = kNone;
  int minor = 0;
};

// The entry of that name in the nearest later version, or else the nearest earlier one.
Elsewhere find_elsewhere(const Tables& tables, std::uint32_t first, std::uint32_t last,
                         std::string_view name, int minor) {
  const VersionSet later_than_now = ~VersionSet{0} << minor << 1;
  Elsewhere later{kNone, kVersionLimit};
  Elsewhere earlier{kNone, -1};
  for (std::uint32_t i = first; i < last; ++i) {
    if (!named(tables.entries[i], name)) continue;
    const VersionSet set = tables.lines[tables.entries[i].line].reachable;
    if ((set & only(minor)) != 0) return {};
    const int next = std::countr_zero(set & later_than_now);  // kVersionLimit when there is none
    if (next < later.minor) later = {i, next};
    const int last_one = kVersionLimit - 1 - std::countl_zero(set & ~later_than_now);
    if (last_one > earlier.minor) earlier = {i, last_one};
  }
  return later.entry != kNone ? later : earlier;
}

}  // namespace

std::string_view to_string(Cardinality cardinality) {
  constexpr std::array<std::string_view, 5> kWords = {"0", "1", "*", "+", "-1"};
  return kWords[static_cast<std::size_t>(cardinality)];
}

Enumeration::Iterator& Enumeration::Iterator::operator++() {
  const std::size_t bar = rest_.find('|');
  done_ = bar == std::string_view::npos;
  rest_ = done_ ? std::string_view() : rest_.substr(bar + 1);
  return *this;
}

Enumeration::Iterator Enumeration::Iterator::operator++(int) {
  const Iterator before = *this;
  ++*this;
  return before;
}

bool Enumeration::contains(std::string_view value) const {
  return std::find(begin(), end(), value) != end();
}

const Facet* Tables::facet(std::uint32_t place, std::uint32_t declaration, Key key,
                           int minor) const {
  if ((lines[place].keys & only(key)) == 0) return nullptr;
  const Facet* found = nullptr;
  for (const std::uint32_t at : {place, declaration}) {
    const Line& line = lines[at];
    // versions rise within a key, so the last that holds is the one
    for (std::uint32_t i = line.first_facet; i < line.last_facet && facets[i].key <= key; ++i) {
      if (facets[i].key == key && facets[i].from <= minor) found = &facets[i];
    }
    if (found || place == declaration) break;
  }
  return found && found->present ? found : nullptr;
}

std::string_view Node::name() const { return tables_->lines[place_].name; }

std::string_view Node::doc() const {
  const std::string_view own = tables_->lines[place_].doc;
  return own.empty() ? tables_->lines[declaration_].doc : own;
}

Type Node::type() const {
  if (const auto& type = tables_->lines[place_].only_type) return *type;
  const Facet* facet = tables_->facet(place_, declaration_, Key::kType, minor_);
  return facet ? static_cast<Type>(facet->number) : Type::kNone;
}

std::optional<Count> parse_count(std::string_view text) {
  const auto number = [](std::string_view digits) -> std::optional<std::size_t> {
    std::size_t value = 0;
    const char* const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    if (error != std::errc() || stop != end || value == 0) return std::nullopt;
    return value;
  };
  if (text.ends_with('*')) {
    const auto multiple = number(text.substr(0, text.size() - 1));
    if (!multiple) return std::nullopt;
    return Count{*multiple, std::nullopt, *multiple};
  }
  const std::size_t dots = text.find("..");
  const auto least = number(text.substr(0, dots));
  if (!least) return std::nullopt;
  if (dots == std::string_view::npos) return Count{*least, least};
  const std::string_view upper = text.substr(dots + 2);
  if (upper.empty()) return Count{*least};
  const auto most = number(upper);
  if (!most || *most < *least) return std::nullopt;
  return Count{*least, most};
}

std::string to_string(const Count& count) {
  const std::string least = std::to_string(count.least);
  if (count.multiple > 1) return "a multiple of " + least + " numbers";
  if (!count.most) return count.least == 1 ? "numbers" : least + " or more numbers";
  if (*count.most != count.least) return least + " to " + std::to_string(*count.most) + " numbers";
  return least + (count.least == 1 ? " number" : " numbers");
}

std::optional<Count> Node::count() const {
  const Facet* facet = tables_->facet(place_, declaration_, Key::kCount, minor_);
  return facet ? parse_count(facet->value) : std::nullopt;
}

Cardinality Node::cardinality() const {
  const Facet* facet = tables_->facet(place_, declaration_, Key::kCard, minor_);
  return facet ? static_cast<Cardinality>(facet->number) : Cardinality::kOptional;
}

std::optional<std::string_view> Node::default_value() const {
  const Facet* facet = tables_->facet(place_, declaration_, Key::kDefault, minor_);
  return facet ? std::optional(facet->value) : std::nullopt;
}

std::optional<std::string_view> Node::minimum() const {
  const Facet* facet = tables_->facet(place_, declaration_, Key::kMin, minor_);
  return facet ? std::optional(facet->value) : std::nullopt;
}

std::optional<std::string_view> Node::maximum() const {
  const Facet* facet = tables_->facet(place_, declaration_, Key::kMax, minor_);
  return facet ? std::optional(facet->value) : std::nullopt;
}

Enumeration Node::enumeration() const {
  const Facet* facet = tables_->facet(place_, declaration_, Key::kEnum, minor_);
  return facet ? Enumeration(facet->value) : Enumeration();
}

bool Node::may_have_limits() const {
  constexpr KeySet kLimits = only(Key::kEnum) | only(Key::kMin) | only(Key::kMax);
  return (tables_->lines[place_].keys & kLimits) != 0;
}

std::optional<Version> Node::listed_since(std::string_view value) const {
  if (enumeration().contains(value)) return std::nullopt;
  for (int minor = minor_ + 1; minor <= tables_->versions.back().minor; ++minor) {
    const Facet* facet = tables_->facet(place_, declaration_, Key::kEnum, minor);
    if (facet && Enumeration(facet->value).contains(value)) return Version{minor};
  }
  return std::nullopt;
}

std::string_view Node::unit() const {
  const Facet* facet = tables_->facet(place_, declaration_, Key::kUnit, minor_);
  return facet ? facet->value : std::string_view();
}

Version Node::since() const { return Version{std::countr_zero(tables_->lines[place_].reachable)}; }

std::optional<Version> Node::until() const {
  const int last = kVersionLimit - 1 - std::countl_zero(tables_->lines[place_].reachable);
  return last < tables_->versions.back().minor ? std::optional(Version{last}) : std::nullopt;
}

std::optional<Version> Node::deprecated_since() const {
  const Facet* facet = tables_->facet(place_, declaration_, Key::kDeprecated, minor_);
  return facet && facet->number <= minor_ ? std::optional(Version{facet->number}) : std::nullopt;
}

std::string_view Node::instead() const {
  const Facet* facet = tables_->facet(place_, declaration_, Key::kInstead, minor_);
  return facet ? facet->value : std::string_view();
}

bool Node::open() const { return tables_->lines[declaration_].open; }

std::optional<Node> Node::child(std::string_view name) const {
  const Line& line = tables_->lines[declaration_];
  const std::uint32_t found = find(*tables_, line.first_child, line.last_child, name, minor_);
  if (found == kNone) return std::nullopt;
  const std::uint32_t place = tables_->entries[found].line;
  return Node(tables_, place, tables_->lines[place].declaration, minor_);
}

std::optional<Node> Node::attribute(std::string_view name) const {
  const Line& line = tables_->lines[declaration_];
  const std::uint32_t found =
      find(*tables_, line.first_attribute, line.last_attribute, name, minor_);
  if (found == kNone) return std::nullopt;
  const std::uint32_t place = tables_->entries[found].line;
  return Node(tables_, place, place, minor_);
}

std::optional<Node> Node::child_in_other_version(std::string_view name) const {
  const Line& line = tables_->lines[declaration_];
  const Elsewhere found = find_elsewhere(*tables_, line.first_child, line.last_child, name, minor_);
  if (found.entry == kNone) return std::nullopt;
  const std::uint32_t place = tables_->entries[found.entry].line;
  return Node(tables_, place, tables_->lines[place].declaration, found.minor);
}

std::optional<Node> Node::attribute_in_other_version(std::string_view name) const {
  const Line& line = tables_->lines[declaration_];
  const Elsewhere found =
      find_elsewhere(*tables_, line.first_attribute, line.last_attribute, name, minor_);
  if (found.entry == kNone) return std::nullopt;
  const std::uint32_t place = tables_->entries[found.entry].line;
  return Node(tables_, place, place, found.minor);
}

NodeRange Node::children() const {
  const Line& line = tables_->lines[declaration_];
  return {tables_, line.first_child, line.last_child, minor_, NodeRange::Filter::kAll};
}

NodeRange Node::attributes() const {
  const Line& line = tables_->lines[declaration_];
  return {tables_, line.first_attribute, line.last_attribute, minor_, NodeRange::Filter::kAll};
}

bool Node::requires_children() const {
  return (tables_->lines[declaration_].requires_child & only(minor_)) != 0;
}

bool Node::requires_attributes() const {
  return (tables_->lines[declaration_].requires_attribute & only(minor_)) != 0;
}

NodeRange Node::required_children() const {
  const Line& line = tables_->lines[declaration_];
  return {tables_, line.first_child, line.last_child, minor_, NodeRange::Filter::kRequired};
}

NodeRange Node::required_attributes() const {
  const Line& line = tables_->lines[declaration_];
  return {tables_, line.first_attribute, line.last_attribute, minor_, NodeRange::Filter::kRequired};
}

void NodeRange::Iterator::skip() {
  const VersionSet now = only(minor_);
  for (; at_ < last_; ++at_) {
    const Entry& entry = tables_->entries[at_];
    if (((required_ ? entry.required : entry.exists) & now) != 0) return;
  }
}

Node NodeRange::Iterator::operator*() const {
  const std::uint32_t place = tables_->entries[at_].line;
  return Node(tables_, place, tables_->lines[place].declaration, minor_);
}

NodeRange::Iterator& NodeRange::Iterator::operator++() {
  ++at_;
  skip();
  return *this;
}

NodeRange::Iterator NodeRange::Iterator::operator++(int) {
  const Iterator before = *this;
  ++*this;
  return before;
}

Schema::Schema(std::unique_ptr<const Tables> tables) : tables_(std::move(tables)) {}
Schema::Schema(Schema&&) noexcept = default;
Schema& Schema::operator=(Schema&&) noexcept = default;
Schema::~Schema() = default;

std::variant<Schema, Schema::Fault> Schema::parse(std::string_view text) {
  std::variant<Tables, Fault> parsed = parse_tables(text);
  if (Fault* fault = std::get_if<Fault>(&parsed)) return std::move(*fault);
  return Schema(std::make_unique<const Tables>(std::get<Tables>(std::move(parsed))));
}

const std::vector<Version>& Schema::versions() const { return tables_->versions; }

bool Schema::knows(Version version) const {
  return version.minor >= 0 && version.minor < kVersionLimit &&
         (tables_->known & only(version.minor)) != 0;
}

Version Schema::nearest(Version version) const {
  const auto after = std::upper_bound(versions().begin(), versions().end(), version);
  return after == versions().begin() ? versions().front() : *std::prev(after);
}

std::optional<Node> Schema::root(std::string_view element_name, Version version) const {
  if (!knows(version)) return std::nullopt;
  return Node(tables_.get(), tables_->root, tables_->root, version.minor).child(element_name);
}

NodeRange Schema::roots(Version version) const {
  const Line& line = tables_->lines[tables_->root];
  const std::uint32_t last = knows(version) ? line.last_child : line.first_child;
  const int minor = knows(version) ? version.minor : 0;
  return {tables_.get(), line.first_child, last, minor, NodeRange::Filter::kAll};
}

std::vector<std::string> Schema::parents_of(std::string_view name, Version version) const {
  std::vector<std::string> paths;
  if (!knows(version)) return paths;
  for (const Line& line : tables_->lines) {
    if (line.kind == Kind::kBlock || line.kind == Kind::kAttribute || line.name != name) continue;
    if ((line.reachable & only(version.minor)) == 0) continue;
    const Line* around = &tables_->lines[line.parent];
    if (line.kind == Kind::kElement && around->kind == Kind::kBlock) continue;  // its uses tell
    std::string path(around->name);
    for (around = &tables_->lines[around->parent]; around->kind != Kind::kBlock;
         around = &tables_->lines[around->parent]) {
      path = std::string(around->name) + "/" + path;
    }
    if (std::find(paths.begin(), paths.end(), path) == paths.end()) paths.push_back(path);
  }
  return paths;
}

}  // namespace rigor::schema
