// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "option/numbers.h"

#include <cmath>
#include <sstream>
#include <variant>

#include <rigor/schema/value.h>

#include "command/command.h"

namespace rigor::tool {

double finite_number(const std::string& option, const std::string& text) {
  const auto parsed = schema::parse_double(text);
  const double* value = std::get_if<double>(&parsed);
  if (value != nullptr && std::isfinite(*value)) return *value;
  throw UsageError(option + ": \"" + text + "\" is no finite number");
}

double positive_number(const std::string& option, const std::string& text, const char* unit) {
  const double value = finite_number(option, text);
  if (value > 0) return value;
  throw UsageError(option + " " + text + ": must be above 0 " + unit);
}

std::vector<double> finite_numbers(const std::string& option,
                                   const std::vector<std::string>& words) {
  std::vector<double> numbers;
  for (const std::string& word : words) {
    std::istringstream parts(word);
    for (std::string part; parts >> part;) numbers.push_back(finite_number(option, part));
  }
  return numbers;
}

model::Vector3 positive_vector(const std::string& option, const std::vector<std::string>& words,
                               const char* unit) {
  const std::vector<double> numbers = finite_numbers(option, words);
  if (numbers.size() != 3) {
    throw UsageError(option + " takes three numbers, not " + std::to_string(numbers.size()));
  }
  for (const double number : numbers) {
    if (!(number > 0)) {
      throw UsageError(option + ": each number must be above 0 " + unit);
    }
  }
  return {numbers[0], numbers[1], numbers[2]};
}

model::Vector3 scale_factors(const std::vector<std::string>& words) {
  const std::vector<double> factors = finite_numbers("--scale", words);
  if (factors.size() != 1 && factors.size() != 3) {
    throw UsageError("--scale takes one number or three, not " + std::to_string(factors.size()));
  }
  for (const double factor : factors) {
    if (factor == 0) throw UsageError("--scale: a factor of 0 leaves nothing of the mesh");
  }
  if (factors.size() == 1) return {factors[0], factors[0], factors[0]};
  return {factors[0], factors[1], factors[2]};
}

}  // namespace rigor::tool
