// Text that writers of several formats share.
#pragma once

#include <string>

#include "model/text/json_fields.h"

namespace tact {

// A document as text that ends with a line break.
std::string printed(const Json& document);

// Letters, digits and underscores, not a digit first: a name in source text.
std::string identifier(const std::string& name);

}  // namespace tact
