// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers of the command line, read without locale and whole: "1,5" and "3kg" are no numbers.

#pragma once

#include <string>
#include <vector>

#include <rigor/model/pose.h>

namespace rigor::tool {

/// A UsageError that names the option when the text is no finite number.
double finite_number(const std::string& option, const std::string& text);

/// The same, above zero; `unit` is for the message.
double positive_number(const std::string& option, const std::string& text, const char* unit);

/// From words that each hold one or more numbers: `1 1 1` and `"1 1 1"` are the same.
std::vector<double> finite_numbers(const std::string& option,
                                   const std::vector<std::string>& words);

/// Three numbers above zero.
model::Vector3 positive_vector(const std::string& option, const std::vector<std::string>& words,
                               const char* unit);

/// The factors of `--scale`: one, or one per axis, none of them zero.
model::Vector3 scale_factors(const std::vector<std::string>& words);

}  // namespace rigor::tool
