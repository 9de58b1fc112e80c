// A look at YAML before its parser sees it.
#pragma once

#include <optional>
#include <string>

namespace waywright {

/// Aliases and deep nesting have no place in a map, and are where YAML parsers suffer: what is wrong with a text in this respect.
std::optional<std::string> suspicious_yaml(const std::string& text);

}  // namespace waywright
