// Numbers of a command line's argument.
#pragma once

#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>

namespace waywright::app {

/// "1,2=3": as many finite numbers as there are separators and one more, and nothing else; empty where it is something else.
template <std::size_t n>
std::optional<std::array<double, n + 1>> numbers_from(const std::string& text, const std::array<char, n>& separators) {
  std::array<double, n + 1> values{};
  const char* at = text.c_str();
  for (std::size_t i = 0; i <= n; ++i) {
    char* end = nullptr;
    values[i] = std::strtod(at, &end);
    if (end == at || *end != (i < n ? separators[i] : '\0') || !std::isfinite(values[i])) return std::nullopt;
    at = end + 1;
  }
  return values;
}

}  // namespace waywright::app
