// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What client and server tell each other at the beginning.

#pragma once

#include <rigor/lsp/protocol/json.h>
#include <rigor/lsp/session/state.h>

namespace rigor::lsp {

/// Of the parameters of `initialize`.
Client client_of(const Json& params);

Json server_capabilities(const Client& client);

}  // namespace rigor::lsp
