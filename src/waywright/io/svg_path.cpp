#include "waywright/io/svg_path.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <utility>

#include "waywright/core/angle.hpp"
#include "waywright/core/elementary.hpp"

namespace waywright::svg {
namespace {

constexpr bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

/// Goes through a text token by token.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_{text} {}

  bool at_end() {
    skip();
    return at_ >= text_.size();
  }
  /// A letter, or 0 where the next token is none.
  char letter() {
    skip();
    const char c = at_ < text_.size() ? text_[at_] : '\0';
    if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'))) return '\0';
    ++at_;
    return c;
  }
  std::string word() {
    std::string w;
    skip();
    while (at_ < text_.size() && ((text_[at_] >= 'a' && text_[at_] <= 'z') || (text_[at_] >= 'A' && text_[at_] <= 'Z'))) w += text_[at_++];
    return w;
  }
  bool take(char wanted) {
    skip();
    if (at_ >= text_.size() || text_[at_] != wanted) return false;
    ++at_;
    return true;
  }
  bool is_number_next() {
    skip();
    if (at_ >= text_.size()) return false;
    const char c = text_[at_];
    return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
  }
  std::optional<double> number() {
    if (!is_number_next()) return std::nullopt;
    if (text_[at_] == '+') ++at_;
    if (at_ < text_.size() && (text_[at_] == '+' || (text_[at_] == '-' && at_ > 0 && text_[at_ - 1] == '+'))) return std::nullopt;
    double value = 0.0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
    at_ = static_cast<std::size_t>(end - text_.data());
    return value;
  }

 private:
  void skip() {
    while (at_ < text_.size() && (is_space(text_[at_]) || text_[at_] == ',')) ++at_;
  }
  std::string_view text_;
  std::size_t at_ = 0;
};

constexpr const char* straight = "straight lines: M, L, H, V, Z and their small letters";

std::optional<Transform> one_transform(const std::string& name, const std::vector<double>& v) {
  const std::size_t n = v.size();
  if (name == "matrix" && n == 6) return Transform{v[0], v[1], v[2], v[3], v[4], v[5]};
  if (name == "translate" && (n == 1 || n == 2)) return Transform{1, 0, 0, 1, v[0], n == 2 ? v[1] : 0.0};
  if (name == "scale" && (n == 1 || n == 2)) return Transform{v[0], 0, 0, n == 2 ? v[1] : v[0], 0, 0};
  const auto angle = [&](double degrees) { return sin_cos(std::fmod(degrees, 360.0) * (pi / 180.0)); };
  if (name == "rotate" && (n == 1 || n == 3)) {
    const SinCos t = angle(v[0]);
    const Transform turn{t.cos, t.sin, -t.sin, t.cos, 0, 0};
    if (n == 1) return turn;
    return Transform{1, 0, 0, 1, v[1], v[2]} * turn * Transform{1, 0, 0, 1, -v[1], -v[2]};
  }
  if ((name == "skewX" || name == "skewY") && n == 1) {
    const SinCos t = angle(v[0]);
    const double slope = t.sin / t.cos;
    if (!std::isfinite(slope)) return std::nullopt;
    return name == "skewX" ? Transform{1, 0, slope, 1, 0, 0} : Transform{1, slope, 0, 1, 0, 0};
  }
  return std::nullopt;
}

}  // namespace

Transform operator*(const Transform& o, const Transform& i) {
  return {o.a * i.a + o.c * i.b, o.b * i.a + o.d * i.b, o.a * i.c + o.c * i.d, o.b * i.c + o.d * i.d, o.a * i.e + o.c * i.f + o.e, o.b * i.e + o.d * i.f + o.f};
}

std::optional<std::vector<double>> numbers(std::string_view text) {
  Scanner scanner{text};
  std::vector<double> all;
  while (!scanner.at_end()) {
    const auto value = scanner.number();
    if (!value) return std::nullopt;
    all.push_back(*value);
  }
  return all;
}

tl::expected<Transform, Wrong> transform(std::string_view text) {
  Scanner scanner{text};
  Transform all;
  while (!scanner.at_end()) {
    const std::string name = scanner.word();
    std::vector<double> values;
    bool is_right = !name.empty() && scanner.take('(');
    while (is_right && !scanner.take(')')) {
      const auto value = scanner.number();
      is_right = value.has_value() && values.size() < 6;
      if (is_right) values.push_back(*value);
    }
    const auto one = is_right ? one_transform(name, values) : std::nullopt;
    if (!one) return tl::unexpected{Wrong{"the transform cannot be read", "matrix(a b c d e f), translate, scale, rotate, skewX, skewY with their numbers"}};
    all = all * *one;
  }
  return all;
}

tl::expected<std::vector<Subpath>, Wrong> path(std::string_view text) {
  const auto refuse = [](std::string problem) { return tl::unexpected{Wrong{std::move(problem), straight}}; };
  Scanner scanner{text};
  std::vector<Subpath> all;
  Vec2 at{}, first{};
  char command = '\0';
  while (!scanner.at_end()) {
    if (const char letter = scanner.letter(); letter != '\0') {
      command = letter;
      if (command == 'Z' || command == 'z') {
        if (all.empty()) return refuse("the path does not begin with a place to move to");
        all.back().is_closed = true;
        at = first;
        command = '\0';
        continue;
      }
    } else if (command == '\0') {
      return refuse("the path has something that is no command");
    }
    const bool is_relative = command >= 'a';
    const Vec2 base = is_relative ? at : Vec2{};
    const auto one = [&] { return scanner.number(); };
    switch (command) {
      case 'M':
      case 'm':
      case 'L':
      case 'l': {
        const auto x = one(), y = x ? one() : std::nullopt;
        if (!y) return refuse("the path has a command without its numbers");
        at = base + Vec2{*x, *y};
        break;
      }
      case 'H':
      case 'h':
      case 'V':
      case 'v': {
        const auto value = one();
        if (!value) return refuse("the path has a command without its numbers");
        if (command == 'H' || command == 'h') at.x = base.x + *value;
        else at.y = base.y + *value;
        break;
      }
      case 'C':
      case 'c':
      case 'S':
      case 's':
      case 'Q':
      case 'q':
      case 'T':
      case 't':
      case 'A':
      case 'a':
        return refuse(fmt::format("the path has a curve ({})", command));
      default:
        return refuse(fmt::format("the path has an unknown command ({})", command));
    }
    if (!is_finite(at)) return refuse("the path reaches beyond all numbers");
    if (command == 'M' || command == 'm') {
      all.push_back({{at}, false});
      first = at;
      command = command == 'M' ? 'L' : 'l';  // further pairs are lines
      continue;
    }
    if (all.empty()) return refuse("the path does not begin with a place to move to");
    if (all.back().is_closed) all.push_back({{first}, false});  // what goes on after z begins where that ended
    all.back().points.push_back(at);
  }
  return all;
}

}  // namespace waywright::svg
