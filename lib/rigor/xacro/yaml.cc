// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xacro/yaml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>
#include <utility>
#include <vector>

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <rigor/xacro/plain_yaml.h>
#include <rigor/xacro/value/compare.h>
#include <rigor/xacro/value/heap.h>
#include <rigor/xacro/value/integer.h>
#include <rigor/xacro/value/number_text.h>

namespace rigor::xacro {
namespace {

struct YamlUnit {
  std::string_view tag;
  double factor;  ///< to radians or meters
};
constexpr std::array<YamlUnit, 6> kYamlUnits{{{"!radians", 1},
                                              {"!degrees", std::numbers::pi / 180},
                                              {"!meters", 1},
                                              {"!millimeters", 0.001},
                                              {"!foot", 0.3048},
                                              {"!inches", 0.0254}}};

constexpr std::string_view kStandardTag = "tag:yaml.org,2002:";

bool one_of(std::string_view text, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), text) != words.end();
}

bool all_in(std::string_view text, std::string_view characters) {
  return text.find_first_not_of(characters) == std::string_view::npos;
}

/// Digits, and `_` between them.
bool all_digits(std::string_view text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return (c >= '0' && c <= '9') || c == '_'; });
}

bool is_decimal_start(std::string_view text) {
  return !text.empty() && text[0] >= '0' && text[0] <= '9';
}

/// `1:30`, minutes and seconds: 60 to the next part. The text before the first colon is checked.
bool is_sexagesimal(std::string_view text) {
  std::size_t colon = text.find(':');
  if (colon == std::string_view::npos || colon == 0 || !all_digits(text.substr(0, colon)))
    return false;
  while (colon != std::string_view::npos) {
    text.remove_prefix(colon + 1);
    colon = text.find(':');
    const std::string_view part = text.substr(0, colon);
    const bool two =
        part.size() == 2 && part[0] >= '0' && part[0] <= '5' && part[1] >= '0' && part[1] <= '9';
    const bool one = part.size() == 1 && part[0] >= '0' && part[0] <= '9';
    if (!two && !one) return false;
  }
  return true;
}

/// PyYAML's pattern of a float: a point is a must, and so is the exponent's sign.
bool is_yaml_float(std::string_view text) {
  const bool is_signed = text.starts_with('-') || text.starts_with('+');
  if (is_signed) text.remove_prefix(1);
  if (one_of(text, {".inf", ".Inf", ".INF"})) return true;
  if (!is_signed && one_of(text, {".nan", ".NaN", ".NAN"})) return true;
  const std::size_t point = text.find('.');
  if (point == std::string_view::npos) return false;
  const std::string_view whole = text.substr(0, point);
  if (is_sexagesimal(whole)) return is_decimal_start(whole) && all_digits(text.substr(point + 1));
  if (whole.empty() ? is_signed : !is_decimal_start(whole) || !all_digits(whole)) return false;
  std::string_view rest = text.substr(point + 1);
  const std::size_t e = std::min(rest.find_first_of("eE"), rest.size());
  const std::string_view fraction = rest.substr(0, e);
  if (!all_digits(fraction) || (whole.empty() && !is_decimal_start(fraction))) return false;
  if (e == rest.size()) return true;
  const std::string_view exponent = rest.substr(e + 1);
  return exponent.size() > 1 && (exponent[0] == '+' || exponent[0] == '-') &&
         all_in(exponent.substr(1), "0123456789");
}

bool is_yaml_integer(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  if (!is_decimal_start(text)) return false;
  if (text == "0") return true;
  if (text.starts_with("0b")) return text.size() > 2 && all_in(text.substr(2), "01_");
  if (text.starts_with("0x"))
    return text.size() > 2 && all_in(text.substr(2), "0123456789abcdefABCDEF_");
  if (text[0] == '0') return all_in(text, "01234567_");
  return all_digits(text) || is_sexagesimal(text);
}

bool is_yaml_date(std::string_view text) {
  const auto digits = [text](std::size_t at, std::size_t count) {
    return at + count <= text.size() && all_in(text.substr(at, count), "0123456789");
  };
  if (!digits(0, 4) || text.size() < 8 || text[4] != '-' || !digits(5, 1)) return false;
  const std::size_t dash = text.find('-', 5);
  return dash != std::string_view::npos && dash <= 7 && digits(dash + 1, 1) &&
         all_in(text, "0123456789-:.TtZ +");
}

std::string without_joints(std::string_view text) {
  std::string plain(text);
  std::erase(plain, '_');
  return plain;
}

Value yaml_integer(Heap& heap, std::string_view text) {
  std::string plain = without_joints(text);
  const bool negative = plain[0] == '-';
  if (negative || plain[0] == '+') plain.erase(0, 1);
  Value n = Value::integer(0);
  if (plain.find(':') != std::string::npos) {
    std::istringstream parts(plain);
    for (std::string part; std::getline(parts, part, ':');) {
      n = integer_operation(heap, IntegerOperation::kMultiply, n, Value::integer(60));
      const Value digits = integer_from_text(heap, part);
      n = n.failed() || digits.failed()
              ? Value::error()
              : integer_operation(heap, IntegerOperation::kAdd, n, digits);
      if (n.failed()) return n;
    }
  } else if (plain.starts_with("0b") || plain.starts_with("0x")) {
    n = integer_from_text(heap, plain.substr(2), plain[1] == 'b' ? 2 : 16);
  } else {
    n = integer_from_text(heap, plain, plain.size() > 1 && plain[0] == '0' ? 8 : 10);
  }
  return negative && !n.failed() ? negated_integer(heap, n) : n;
}

Value yaml_float(std::string_view text) {
  std::string plain = without_joints(text);
  const double sign = plain[0] == '-' ? -1 : 1;
  if (plain[0] == '-' || plain[0] == '+') plain.erase(0, 1);
  if (plain.size() > 1 && plain[0] == '.' && (plain[1] | 0x20) == 'i')
    return Value::real(sign * HUGE_VAL);
  if (plain.size() > 1 && plain[0] == '.' && (plain[1] | 0x20) == 'n')
    return Value::real(std::nan(""));
  // A stream costs more than the number.
  if (plain.find(':') == std::string::npos)
    return Value::real(sign * real_from_text(plain).value_or(0));
  double d = 0;
  std::istringstream parts(plain);
  for (std::string part; std::getline(parts, part, ':');)
    d = d * 60 + real_from_text(part).value_or(0);
  return Value::real(sign * d);
}

/// What is wrong with a value, thrown within this file as yaml-cpp throws what is wrong with the file.
struct YamlRefusal {
  FactKind kind;
  Span where;
  std::string detail;
};

class YamlBuilder final : public YAML::EventHandler {
 public:
  YamlBuilder(std::string_view bytes, SourceId source, Heap& heap,
              const std::function<Value(std::string_view, Span)>& evaluate)
      : bytes_(bytes), source_(source), heap_(heap), evaluate_(evaluate) {}

  Value root() const { return root_; }

  Span span_at(const YAML::Mark& mark, std::string_view value = {}) const {
    // Marks count bytes.
    const std::size_t begin =
        std::min(static_cast<std::size_t>(std::max(mark.pos, 0)), bytes_.size());
    const std::string_view line = bytes_.substr(begin, bytes_.find('\n', begin) - begin);
    if (const std::size_t at = line.find(value); !value.empty() && at != std::string_view::npos) {
      return span(begin + at, begin + at + value.size());
    }
    return span(begin, begin + line.find_last_not_of(" \t\r") + 1);
  }

  void take(const PlainYamlEvent& event) {
    YAML::Mark mark;
    mark.pos = static_cast<int>(event.offset);
    switch (event.kind) {
      case PlainYamlEvent::Kind::kMapStart: return begin(mark, "?", event.anchor, true);
      case PlainYamlEvent::Kind::kMapEnd: return OnMapEnd();
      case PlainYamlEvent::Kind::kNull: return OnNull(mark, YAML::NullAnchor);
      case PlainYamlEvent::Kind::kAlias: return OnAlias(mark, event.anchor);
      case PlainYamlEvent::Kind::kScalar: break;
    }
    take_scalar(mark, event.tag.empty() ? std::string_view("?") : event.tag, YAML::NullAnchor,
                event.text);
  }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    take(Value::none(), span_at(mark), anchor);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto found = anchors_.find(anchor);
    if (found == anchors_.end())
      refuse(FactKind::kYaml, span_at(mark), "an alias to what is not complete");
    take(found->second, span_at(mark), YAML::NullAnchor);
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    take_scalar(mark, tag, anchor, value);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    begin(mark, tag, anchor, false);
  }
  void OnSequenceEnd() override { end(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    begin(mark, tag, anchor, true);
  }
  void OnMapEnd() override { end(); }

 private:
  struct Open {
    bool map;
    Value value;
    Span where;
    YAML::anchor_t anchor;
    std::vector<Value> items;
    std::vector<Span> places;
    std::vector<Entry> entries;
    std::vector<Entry> merged;
    std::optional<Value> key;
    bool merging = false;
  };

  Span span(std::size_t begin, std::size_t end) const {
    const std::size_t size = bytes_.size();
    return {source_, static_cast<std::uint32_t>(std::min(begin, size)),
            static_cast<std::uint32_t>(std::min(std::max(begin, end), size))};
  }

  [[noreturn]] void refuse(FactKind kind, Span where, std::string detail) const {
    throw YamlRefusal{kind, where, std::move(detail)};
  }

  void take_scalar(const YAML::Mark& mark, std::string_view tag, YAML::anchor_t anchor,
                   std::string_view value) {
    const Span where = span_at(mark, value);
    merge_key_ =
        tag == "?" && value == "<<" && !open_.empty() && open_.back().map && !open_.back().key;
    take(scalar(tag, value, where), where, anchor);
  }

  void begin(const YAML::Mark& mark, std::string_view tag, YAML::anchor_t anchor, bool map) {
    const std::string_view standard = map ? "tag:yaml.org,2002:map" : "tag:yaml.org,2002:seq";
    if (!tag.empty() && tag != "?" && tag != "!" && tag != standard) {
      refuse_tag(tag, span_at(mark));
    }
    const Value value = map ? heap_.dictionary() : heap_.list({});
    // Known before it is complete: a list may hold itself.
    if (anchor != YAML::NullAnchor) anchors_[anchor] = value;
    open_.push_back({map, value, span_at(mark), anchor, {}, {}, {}, {}, std::nullopt});
  }

  void end() {
    Open done = std::move(open_.back());
    open_.pop_back();
    if (done.map) {
      // Merged entries come first, as if they were written there; own ones win.
      Entries& entries = *done.value.dictionary_->entries;
      entries.list.reserve(done.merged.size() + done.entries.size());
      for (const Entry& entry : done.merged)
        set_entry(entries, entry.key, entry.value, entry.place);
      for (const Entry& entry : done.entries)
        set_entry(entries, entry.key, entry.value, entry.place);
      heap_.charge(entries.list.size() * sizeof(Entry));
    } else {
      heap_.charge(done.items.size() * (sizeof(Value) + sizeof(Span)));
      done.value.sequence_->items->values = std::move(done.items);
      done.value.sequence_->items->places = std::move(done.places);
    }
    if (heap_.full()) refuse(FactKind::kBoundReached, done.where, "the memory of expressions");
    take(done.value, done.where, YAML::NullAnchor);
  }

  void merge(Open& into, Value value, Span where) {
    if (value.is(Type::kList)) {
      // The first that has a key wins.
      std::vector<Value> items = value.sequence_->items->values;
      std::reverse(items.begin(), items.end());
      for (const Value item : items) merge(into, item, where);
      return;
    }
    if (!value.is(Type::kDictionary))
      refuse(FactKind::kYaml, where, "<< takes a dictionary or a list of them");
    for (const Entry& entry : value.dictionary_->entries->list) into.merged.push_back(entry);
    heap_.charge(value.dictionary_->entries->list.size() * sizeof(Entry));
    if (heap_.full()) refuse(FactKind::kBoundReached, where, "the memory of expressions");
  }

  void take(Value value, Span where, YAML::anchor_t anchor) {
    if (anchor != YAML::NullAnchor) anchors_[anchor] = value;
    if (open_.empty()) {
      root_ = value;
      return;
    }
    Open& open = open_.back();
    if (!open.map) {
      open.items.push_back(value);
      open.places.push_back(where);
    } else if (!open.key) {
      open.merging = std::exchange(merge_key_, false);
      if (!is_hashable(value)) refuse(FactKind::kYaml, where, "a list or dictionary is no key");
      open.key = value;
    } else {
      if (open.merging) {
        merge(open, value, where);
      } else {
        open.entries.push_back({*open.key, value, where});
      }
      open.key.reset();
    }
  }

  Value scalar(std::string_view tag, std::string_view text, Span where) {
    if (tag == "?") return plain(text, where);
    if (tag == "!" || tag.empty()) return heap_.text(text);
    for (const YamlUnit& unit : kYamlUnits) {
      if (tag == unit.tag) return with_unit(unit, text, where);
    }
    if (tag.starts_with(kStandardTag)) {
      const std::string_view type = tag.substr(kStandardTag.size());
      if (type == "str") return heap_.text(text);
      if (type == "null") return Value::none();
      if (type == "int" && is_yaml_integer(text)) return plain(text, where);
      if (type == "float") {
        if (is_yaml_float(text)) return yaml_float(text);
        if (const auto d = real_from_text(text)) return Value::real(*d);
      }
      if (type == "bool") return plain(text, where);
    }
    refuse_tag(tag, where);
  }

  [[noreturn]] void refuse_tag(std::string_view tag, Span where) {
    if (!tag.starts_with('!'))
      refuse(FactKind::kOutsideLanguage, where, "the YAML tag " + std::string(tag));
    std::string known;
    for (const YamlUnit& unit : kYamlUnits)
      known.append(known.empty() ? "" : ", ").append(unit.tag);
    refuse(FactKind::kWrongValue, where,
           "xacro knows no unit " + std::string(tag) + "; it knows " + known);
  }

  Value with_unit(const YamlUnit& unit, std::string_view text, Span where) {
    const Value v = evaluate_(heap_.keep(text), where);
    if (v.failed()) return v;
    std::optional<double> d;
    if (v.is(Type::kReal)) d = v.real_;
    if (v.is_integral()) d = integer_to_double(v);
    if (v.is_text()) d = real_from_text(v.as_text());
    if (!d) refuse(FactKind::kWrongValue, where, std::string(unit.tag) + " takes a number");
    return Value::real(unit.factor == 1 ? *d : *d * unit.factor);
  }

  Value plain(std::string_view text, Span where) {
    // The longest of these words is `false`.
    constexpr std::size_t kLongestWord = 5;
    if (text.size() > kLongestWord) return number_or_text(text, where);
    if (text.empty() || one_of(text, {"~", "null", "Null", "NULL"})) return Value::none();
    if (one_of(text, {"yes", "Yes", "YES", "true", "True", "TRUE", "on", "On", "ON"}))
      return Value::boolean(true);
    if (one_of(text, {"no", "No", "NO", "false", "False", "FALSE", "off", "Off", "OFF"}))
      return Value::boolean(false);
    return number_or_text(text, where);
  }

  Value number_or_text(std::string_view text, Span where) {
    constexpr std::string_view kNumberStarts = "+-.0123456789";
    if (kNumberStarts.find(text[0]) != std::string_view::npos) {
      // As nearly all are; YAML takes a zero before other digits for a number to the base 8.
      const std::size_t first = text[0] == '-' || text[0] == '+' ? 1 : 0;
      if (text.size() > first + 1 ? text[first] != '0' || text[first + 1] == '.' : true) {
        if (const Value number = plain_decimal(text); !number.failed()) return number;
      }
      if (is_yaml_float(text)) return yaml_float(text);
      if (is_yaml_integer(text)) {
        const Value n = yaml_integer(heap_, text);
        if (n.failed()) refuse(FactKind::kYaml, where, "a whole number that is none");
        return n;
      }
      if (is_yaml_date(text)) refuse(FactKind::kOutsideLanguage, where, "dates of YAML");
    }
    return heap_.text(text);
  }

  std::string_view bytes_;
  SourceId source_;
  Heap& heap_;
  const std::function<Value(std::string_view, Span)>& evaluate_;
  std::vector<Open> open_;
  std::map<YAML::anchor_t, Value> anchors_;
  Value root_;
  bool merge_key_ = false;
};

}  // namespace

YamlResult read_yaml(std::string_view bytes, SourceId source, Heap& heap,
                     const std::function<Value(std::string_view, Span)>& evaluate) {
  YamlBuilder builder(bytes, source, heap, evaluate);
  try {
    if (const auto events = read_plain_yaml(bytes)) {
      for (const PlainYamlEvent& event : *events) builder.take(event);
      return {builder.root(), std::nullopt};
    }
    std::istringstream stream{std::string(bytes)};
    YAML::Parser parser(stream);
    if (parser.HandleNextDocument(builder) && parser) {
      // A second document is none for the reference.
      YamlBuilder second(bytes, source, heap, evaluate);
      if (parser.HandleNextDocument(second)) {
        return {Value::error(),
                YamlTrouble{FactKind::kYaml, {source, 0, 0}, "there is more than one document"}};
      }
    }
    return {builder.root(), std::nullopt};
  } catch (const YAML::Exception& problem) {
    return {Value::error(),
            YamlTrouble{FactKind::kYaml, builder.span_at(problem.mark), problem.msg}};
  } catch (const YamlRefusal& refusal) {
    return {Value::error(), YamlTrouble{refusal.kind, refusal.where, refusal.detail}};
  }
}

}  // namespace rigor::xacro
