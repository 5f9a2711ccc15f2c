// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `str(v)` and `repr(v)` of `Evaluator`.

#include <algorithm>
#include <utility>

#include <rigor/xacro/expression/evaluator.h>
#include <rigor/xacro/value/compare.h>
#include <rigor/xacro/value/integer.h>
#include <rigor/xacro/value/number_text.h>
#include <rigor/xacro/value/unicode.h>

namespace rigor::xacro {
namespace {

/// Between single quotes, or double ones where the text has single ones alone.
std::string quoted_text(std::string_view text) {
  const bool has_single = text.find('\'') != std::string_view::npos;
  const char quote = has_single && text.find('"') == std::string_view::npos ? '"' : '\'';
  std::string quoted(1, quote);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = at;
    const std::uint32_t c = next_code_point(text, at);
    constexpr std::string_view kHex = "0123456789abcdef";
    if (c == '\n') {
      quoted += "\\n";
    } else if (c == '\t') {
      quoted += "\\t";
    } else if (c == '\r') {
      quoted += "\\r";
    } else if (c == '\\' || c == static_cast<unsigned char>(quote)) {
      quoted += '\\';
      quoted += static_cast<char>(c);
    } else if (c < 0x20 || (c >= 0x7F && c <= 0xA0) || c == 0xAD) {
      quoted += "\\x";
      quoted += kHex[c >> 4U];
      quoted += kHex[c & 0xFU];
    } else {
      quoted += text.substr(begin, at - begin);
    }
  }
  return quoted + quote;
}

/// Writes values within values, as far as the bounds allow.
class Writer {
 public:
  explicit Writer(Evaluator& evaluator) : evaluator_(evaluator) {}

  bool write(Value v) {
    if (text.size() > evaluator_.bounds().text_bytes) {
      evaluator_.fail(FactKind::kBoundReached, {}, "the length of a text");
      return false;
    }
    if (!evaluator_.work(1)) return false;
    switch (v.type) {
      case Type::kNone: text += "None"; return true;
      case Type::kBool: text += v.integer_ != 0 ? "True" : "False"; return true;
      case Type::kInteger: text += std::to_string(v.integer_); return true;
      case Type::kBigInteger: {
        const auto digits = integer_to_text(v);
        if (!digits) evaluator_.fail(FactKind::kBoundReached, {}, "the digits of a number");
        text += digits.value_or("");
        return digits.has_value();
      }
      case Type::kReal: text += real_to_text(v.real_); return true;
      case Type::kText: text += quoted_text(v.as_text()); return true;
      case Type::kList: return write_items(v.sequence_->items->values, "[", "]");
      case Type::kTuple: {
        const bool single = v.sequence_->items->values.size() == 1;
        return write_items(v.sequence_->items->values, "(", single ? ",)" : ")");
      }
      case Type::kDictionary: return write_entries(v);
      case Type::kSet:
      case Type::kFrozenSet: return write_set(v);
      case Type::kView:
        return write_items(v.iterator_->values, std::string(v.iterator_->name) + "([", "])");
      case Type::kRange: {
        const std::vector<Value>& parts = v.iterator_->values;
        const std::size_t shown = parts[2].integer_ == 1 ? 2 : 3;
        return write_items({parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(shown)},
                           "range(", ")");
      }
      case Type::kSlice: return write_items(v.iterator_->values, "slice(", ")");
      case Type::kClass: text += "<class '" + std::string(v.function_->name) + "'>"; return true;
      case Type::kFunction:
        text += "<built-in function " + std::string(v.function_->name) + ">";
        return true;
      case Type::kModule:
      case Type::kNamespace: text += "{}"; return true;
      default: break;
    }
    evaluator_.wrong_type("a " + std::string(type_name(v)) + " has no text");
    return false;
  }

  std::string text;

 private:
  bool enter() {
    if (++depth_ <= kMaxValueDepth) return true;
    evaluator_.fail(FactKind::kBoundReached, {}, "the depth of a list");
    return false;
  }

  bool write_items(const std::vector<Value>& items, std::string_view open, std::string_view close) {
    if (!enter()) return false;
    text += open;
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (i > 0) text += ", ";
      if (!write(items[i])) return false;
    }
    text += close;
    --depth_;
    return true;
  }

  bool write_entries(Value v) {
    if (!enter()) return false;
    text += '{';
    bool first = true;
    for (const Entry& entry : v.dictionary_->entries->list) {
      if (!std::exchange(first, false)) text += ", ";
      if (!write(entry.key)) return false;
      text += ": ";
      if (!write(entry.value)) return false;
    }
    text += '}';
    --depth_;
    return true;
  }

  bool write_set(Value v) {
    std::vector<Value> items;
    for (const Entry& entry : v.dictionary_->entries->list) items.push_back(entry.key);
    const bool frozen = v.is(Type::kFrozenSet);
    if (items.empty()) {
      text += frozen ? "frozenset()" : "set()";
      return true;
    }
    // Python's order is that of hashes: of small whole numbers ascending, of texts another in each run.
    if (std::all_of(items.begin(), items.end(), [](Value i) { return i.is_integral(); })) {
      std::sort(items.begin(), items.end(),
                [](Value a, Value b) { return compare_integers(a, b) < 0; });
    }
    return write_items(items, frozen ? "frozenset({" : "{", frozen ? "})" : "}");
  }

  Evaluator& evaluator_;
  std::uint32_t depth_ = 0;
};

}  // namespace

std::optional<std::string> Evaluator::repr_of(Value v) {
  Writer writer(*this);
  if (v.failed() || !writer.write(v)) return std::nullopt;
  return std::move(writer.text);
}

std::optional<std::string> Evaluator::text_of(Value v) {
  if (v.is_text()) return std::string(v.as_text());
  return repr_of(v);
}

}  // namespace rigor::xacro
