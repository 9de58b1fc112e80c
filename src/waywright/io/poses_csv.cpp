// Anyone's poses as a path.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "waywright/io/files.hpp"
#include "waywright/io/plan_io.hpp"

namespace waywright {
namespace {

constexpr std::uint64_t largest_csv = 256ULL << 20;
constexpr std::size_t most_rows = 1'000'000;
constexpr double largest = 1e6;
constexpr double same_place = 1e-6;  // m

struct Row {
  Pose pose;
  std::optional<int> direction;
};

std::vector<std::string> split(std::string_view line, char separator) {
  std::vector<std::string> cells;
  std::string cell;
  for (const char c : line) {
    if (c == separator) {
      cells.push_back(cell);
      cell.clear();
    } else if (c != '"' && c != '\r' && !(c == ' ' && cell.empty())) {
      cell += c;
    }
  }
  cells.push_back(cell);
  for (std::string& text : cells) {
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.pop_back();
  }
  return cells;
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

enum Column { x_column, y_column, heading_column, direction_column, columns };

std::optional<Column> column_of(const std::string& name) {
  const std::string n = lower(name);
  if (n == "x") return x_column;
  if (n == "y") return y_column;
  if (n == "heading" || n == "theta" || n == "yaw" || n == "th") return heading_column;
  if (n == "direction" || n == "dir" || n == "gear") return direction_column;
  return std::nullopt;
}

std::optional<double> number(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value)) return std::nullopt;
  return value;
}

class Reader {
 public:
  explicit Reader(const std::string& name) : name_{name} {}

  Parsed<std::vector<Row>> read(const std::string& text) {
    std::string_view rest{text};
    if (rest.substr(0, 3) == "\xEF\xBB\xBF") rest.remove_prefix(3);
    std::vector<Row> rows;
    std::array<std::optional<std::size_t>, columns> where{};
    char separator = ',';
    bool header = false;
    for (std::size_t line = 1; !rest.empty(); ++line) {
      const std::size_t end = rest.find('\n');
      const std::string_view text_line = rest.substr(0, end);
      rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
      if (text_line.empty() || text_line[0] == '#' || text_line == "\r") continue;
      if (!header) {
        header = true;
        separator = text_line.find('\t') != std::string_view::npos  ? '\t'
                    : text_line.find(';') != std::string_view::npos ? ';'
                                                                    : ',';
        const auto names = split(text_line, separator);
        for (std::size_t i = 0; i < names.size(); ++i) {
          if (const auto column = column_of(names[i])) where[*column] = i;
        }
        for (const auto& [column, word] : {std::pair{x_column, "x"}, {y_column, "y"}, {heading_column, "heading"}}) {
          if (!where[column]) return refuse(line, fmt::format("the header names no column \"{}\"", word), "x, y, heading and optionally direction");
        }
        continue;
      }
      if (rows.size() >= most_rows) return refuse(line, "there are too many rows", fmt::format("at most {}", most_rows));
      const auto cells = split(text_line, separator);
      std::array<double, columns> values{};
      for (const Column column : {x_column, y_column, heading_column, direction_column}) {
        if (!where[column]) continue;
        const auto value = *where[column] < cells.size() ? number(cells[*where[column]]) : std::nullopt;
        if (!value || std::abs(*value) > largest) return refuse(line, "a value is missing or is not a number that can be used", "finite numbers within 1e6");
        values[column] = *value;
      }
      Row row{{values[x_column], values[y_column], wrap(values[heading_column])}, std::nullopt};
      if (where[direction_column]) {
        const double d = values[direction_column];
        if (d != 1.0 && d != -1.0 && d != 0.0) return refuse(line, fmt::format("the direction is {}", d), "1, -1, 0");
        row.direction = static_cast<int>(d);
      }
      rows.push_back(row);
    }
    if (!header) return refuse(1, "the file is empty", "a header and at least two rows");
    return rows;
  }

 private:
  tl::unexpected<InputError> refuse(std::size_t line, std::string problem, std::string allowed) const {
    return tl::unexpected{InputError{name_, fmt::format("line {}", line), std::move(problem), std::move(allowed)}};
  }
  const std::string& name_;
};

/// Which way the vehicle moves from a to b: forwards where the motion goes with its mean heading.
int direction_between(const Pose& a, const Pose& b) {
  const double middle = a.heading + 0.5 * shorter_turn(a.heading, b.heading);
  return dot(b.position() - a.position(), unit(middle)) >= 0.0 ? 1 : -1;
}

}  // namespace

Parsed<Path> parse_poses_csv(const std::string& text, const std::string& name) {
  auto rows = Reader{name}.read(text);
  if (!rows) return tl::unexpected{rows.error()};
  Path path;
  for (std::size_t i = 0; i + 1 < rows->size(); ++i) {
    const Pose& a = path.pieces.empty() ? (*rows)[i].pose : end_pose(path);
    const Pose& b = (*rows)[i + 1].pose;
    const double turn = shorter_turn(a.heading, b.heading);
    if (distance(a.position(), b.position()) <= same_place) {
      if (std::abs(turn) <= 1e-9) continue;  // the pose stands twice
      if (!path.pieces.empty() && std::holds_alternative<Turn>(path.pieces.back().curve)) {
        std::get<Turn>(path.pieces.back().curve).angle += turn;
      } else {
        path.pieces.push_back({Turn{a.position(), a.heading, turn}, 0});
      }
      continue;
    }
    // A row's direction is that of the motion that begins there, or of the one that ends at the next where only that moves.
    int direction = direction_between(a, b);
    if ((*rows)[i].direction && *(*rows)[i].direction != 0) direction = *(*rows)[i].direction;
    if ((*rows)[i].direction && (*rows)[i + 1].direction && *(*rows)[i].direction != *(*rows)[i + 1].direction) {
      direction = direction_between(a, b);
    }
    if (!path.pieces.empty() && path.pieces.back().direction == direction) {
      std::get<PoseSequence>(path.pieces.back().curve).poses.push_back(b);
    } else {
      path.pieces.push_back({PoseSequence{{a, b}}, direction});
    }
  }
  if (path.pieces.empty()) {
    return tl::unexpected{InputError{name, "", "there are fewer than two different poses", "at least two"}};
  }
  return path;
}

Parsed<Path> read_poses_csv(const std::filesystem::path& file) {
  auto text = read_file(file, largest_csv);
  if (!text) return tl::unexpected{text.error()};
  return parse_poses_csv(*text, file.string());
}

}  // namespace waywright
