// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Why libsdformat skips a parameter of an `<include>`, or a part of one.

#pragma once

#include <cstdint>

namespace rigor::read {

enum class ParameterFault : std::uint8_t {
  kNoElementId,    ///< the parameter has no `element_id`
  kNoLastName,     ///< `element_id` ends in `::`; `detail` is it
  kNoAction,       ///< neither the parameter nor this child of it has an `action`
  kUnknownAction,  ///< `detail` is it
  kNoName,         ///< what is added has no name
  kExists,         ///< what is added is in the model already; `detail` is its name
  kNotFound,       ///< `element_id` does not exist; `detail` is it
  kOneLetterName,  ///< it exists, but libsdformat finds no name of one letter; `detail` is `element_id`
  kInInclude,      ///< rigor itself does not look for it in an include of the included model
  kNotSdf,         ///< no element that SDFormat describes by itself
  kNotAChild,      ///< SDFormat has no such child there; `detail` is the parent's element name
  kNotInElement,     ///< the element to change has no such child; `detail` is its element name
  kRemovesNothing,   ///< the same of `action="remove"`, where libsdformat 12 aborts
  kBadContent,       ///< libsdformat cannot read the new element; `detail` says what of it
  kNoSuchAttribute,  ///< of the element to change; `detail` is the attribute
  kBadValue,         ///< not a value of the element to change; `detail` is it
};

}  // namespace rigor::read
