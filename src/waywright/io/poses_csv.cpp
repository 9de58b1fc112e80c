// Anyone's poses as a path.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "waywright/io/files.hpp"
#include "waywright/io/json_reader.hpp"
#include "waywright/io/plan_io.hpp"

namespace waywright {
namespace {

constexpr std::uint64_t largest_csv = 256ULL << 20;  // bytes
constexpr std::size_t most_rows = 1'000'000;
constexpr std::size_t longest_line = 1 << 16;  // bytes
constexpr double same_place = 1e-6;            // m
constexpr double same_heading = 1e-9;          // rad

struct Row {
  Pose pose;
  std::optional<int> direction;  ///< 1, −1 or 0; absent where the file has no such column
};

std::string_view trimmed(std::string_view text) {
  const auto outer = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '"'; };
  while (!text.empty() && outer(text.front())) text.remove_prefix(1);
  while (!text.empty() && outer(text.back())) text.remove_suffix(1);
  return text;
}

std::vector<std::string_view> split(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  for (;;) {
    const std::size_t end = line.find(separator);
    cells.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) return cells;
    line.remove_prefix(end + 1);
  }
}

enum Column { x_column, y_column, heading_column, direction_column, columns };
constexpr std::array<const char*, columns> column_names{"x", "y", "heading", "direction"};

std::optional<Column> column_of(std::string_view name) {
  std::string n{name};
  std::transform(n.begin(), n.end(), n.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (n == "x") return x_column;
  if (n == "y") return y_column;
  if (n == "heading" || n == "theta" || n == "yaw" || n == "th") return heading_column;
  if (n == "direction" || n == "dir" || n == "gear") return direction_column;
  return std::nullopt;
}

/// Decimal, whatever the locale; the whole cell.
std::optional<double> number(std::string_view text) {
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

class CsvReader {
 public:
  explicit CsvReader(const std::string& name) : name_{name} {}

  Parsed<std::vector<Row>> read(std::string_view rest) {
    if (rest.substr(0, 3) == "\xEF\xBB\xBF") rest.remove_prefix(3);
    bool header = false;
    for (line_ = 1; !rest.empty() && !error_; ++line_) {
      const std::size_t end = rest.find('\n');
      const std::string_view line = rest.substr(0, end);
      rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
      if (line.size() > longest_line)
        refuse("the line is too long", fmt::format("at most {} bytes", longest_line));
      else if (const std::string_view text = trimmed(line); text.empty() || text.front() == '#')
        continue;
      else if (header)
        read_row(line);
      else
        read_header(line), header = true;
    }
    if (!header && !error_)
      error_ = InputError{name_, "", "the file is empty: there is no header",
                          "a header that names x, y, heading and optionally direction"};
    if (error_) return tl::unexpected{*error_};
    return std::move(rows_);
  }

 private:
  void read_header(std::string_view line) {
    for (const char separator : {'\t', ';', ','}) {
      separator_ = separator;
      if (line.find(separator) != std::string_view::npos) break;
    }
    const auto names = split(line, separator_);
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto column = column_of(names[i]);
      if (!column) continue;
      if (where_[*column])
        return refuse(fmt::format("the header names two columns for {}", column_names[*column]), "one");
      where_[*column] = i;
    }
    for (const Column column : {x_column, y_column, heading_column}) {
      if (where_[column]) continue;
      return refuse(fmt::format("the header names no column \"{}\"", column_names[column]),
                    "x, y, heading (or theta, yaw, th) and optionally direction (or dir, gear)");
    }
  }

  void read_row(std::string_view line) {
    if (rows_.size() >= most_rows)
      return refuse("there are too many rows", fmt::format("at most {}", most_rows));
    const auto cells = split(line, separator_);
    std::array<double, columns> values{};
    for (const Column column : {x_column, y_column, heading_column, direction_column}) {
      if (!where_[column]) continue;
      const char* name = column_names[column];
      if (*where_[column] >= cells.size() || cells[*where_[column]].empty())
        return refuse(fmt::format("{} is missing", name), "a number");
      const std::string_view cell = cells[*where_[column]];
      const auto value = number(cell);
      if (!value)
        return refuse(fmt::format("{} is \"{}\"", name, shortened(std::string{cell})), "a finite number");
      if (std::abs(*value) > largest_coordinate) {
        return refuse(fmt::format("{} of {} is out of range", name, *value),
                      fmt::format("{} to {}", -largest_coordinate, largest_coordinate));
      }
      values[column] = *value;
    }
    Row row{{values[x_column], values[y_column], wrap(values[heading_column])}, std::nullopt};
    if (where_[direction_column]) {
      const double d = values[direction_column];
      if (d != 1.0 && d != -1.0 && d != 0.0) return refuse(fmt::format("direction is {}", d), "1, -1, 0");
      row.direction = static_cast<int>(d);
    }
    rows_.push_back(row);
  }

  void refuse(std::string problem, std::string allowed) {
    error_ = InputError{name_, fmt::format("line {}", line_), std::move(problem), std::move(allowed)};
  }

  const std::string& name_;
  std::size_t line_ = 1;
  char separator_ = ',';
  std::array<std::optional<std::size_t>, columns> where_{};
  std::vector<Row> rows_;
  std::optional<InputError> error_;
};

/// Which way the vehicle moves from a to b: forwards where the motion goes with its mean heading.
int direction_between(const Pose& a, const Pose& b) {
  const double middle = a.heading + 0.5 * shorter_turn(a.heading, b.heading);
  return dot(b.position() - a.position(), unit(middle)) >= 0.0 ? 1 : -1;
}

/// The direction of the motion from one row to the next: as both say; where the file says nothing or the rows
/// differ (some name the motion that begins, some the one that ends), as the vehicle moves.
int direction_of(const Row& from, const Row& to) {
  if (from.direction && from.direction == to.direction && *from.direction != 0) return *from.direction;
  return direction_between(from.pose, to.pose);
}

}  // namespace

Parsed<Path> parse_poses_csv(const std::string& text, const std::string& name) {
  const auto rows = CsvReader{name}.read(text);
  if (!rows) return tl::unexpected{rows.error()};
  Path path;
  Row at = rows->empty() ? Row{} : rows->front();  // where the path has come to
  bool stopped = false;                            // there, by a pose that stands twice
  for (const Row& row : *rows) {
    const double turn = shorter_turn(at.pose.heading, row.pose.heading);
    const bool stands = distance(at.pose.position(), row.pose.position()) <= same_place;
    if (stands && std::abs(turn) <= same_heading) {
      at.direction = row.direction;  // where the direction changes say
      stopped = stopped || row.pose == at.pose;
      continue;
    }
    if (stands) {
      // Placed at the path's end, so that a shift too small to be a motion leaves no jump.
      auto* turning = path.pieces.empty() ? nullptr : std::get_if<Turn>(&path.pieces.back().curve);
      if (turning != nullptr && (turning->angle > 0.0) == (turn > 0.0))
        turning->angle += turn;
      else
        path.pieces.push_back({Turn{at.pose.position(), at.pose.heading, turn}, 0});
      at = {end_pose(path), row.direction};
      continue;
    }
    const int direction = direction_of(at, row);
    if (!path.pieces.empty() && path.pieces.back().direction == direction && !stopped) {
      std::get<PoseSequence>(path.pieces.back().curve).poses.push_back(row.pose);
    } else {
      path.pieces.push_back({PoseSequence{{at.pose, row.pose}}, direction});
    }
    at = row;
    stopped = false;
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
