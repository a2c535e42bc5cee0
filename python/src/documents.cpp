// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "documents.hpp"

namespace taut::python {

nb::dict dict_of(const std::string& json) {
    return nb::cast<nb::dict>(
        nb::module_::import_("json").attr("loads")(nb::str(json.c_str(), json.size())));
}

}  // namespace taut::python
