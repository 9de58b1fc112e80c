#include "waywright/io/yaml_text.hpp"

namespace waywright {
namespace {

constexpr std::size_t deepest_yaml = 32;

}  // namespace

std::optional<std::string> suspicious_yaml(const std::string& text) {
  std::size_t depth = 0;
  bool token_start = true;
  for (const char c : text) {
    if ((c == '[' || c == '{') && ++depth > deepest_yaml) return "the yaml is nested too deeply";
    if ((c == ']' || c == '}') && depth > 0) --depth;
    if (token_start && (c == '&' || c == '*')) return "the yaml uses anchors or aliases, which a map does not need";
    token_start = c == ' ' || c == '\n' || c == ':' || c == '-' || c == '[' || c == ',' || c == '{';
  }
  std::size_t indent = 0;
  std::size_t line = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') line = i + 1;
    else if (text[i] == ' ' && i == line + indent) indent = i - line + 1;
    if (indent > 4 * deepest_yaml) return "the yaml is nested too deeply";
    if (text[i] == '\n') indent = 0;
  }
  return std::nullopt;
}

}  // namespace waywright
