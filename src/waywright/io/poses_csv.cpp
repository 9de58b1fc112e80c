// Anyone's poses as a path.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "waywright/io/csv_table.hpp"
#include "waywright/io/files.hpp"
#include "waywright/io/json_reader.hpp"
#include "waywright/io/plan_io.hpp"
#include "waywright/io/scenario_json.hpp"

namespace waywright {
namespace {

constexpr std::uint64_t largest_csv = 256ULL << 20;  // bytes
constexpr std::size_t most_rows = 1'000'000;
constexpr double same_place = 1e-6;            // m
constexpr double same_heading = 1e-9;          // rad

struct Row {
  Pose pose;
  std::optional<int> direction;  ///< 1, −1 or 0; absent where the file has no such column
  std::optional<double> speed{};  ///< m/s
};

enum Column { x_column, y_column, heading_column, direction_column, speed_column, columns };
constexpr std::array<const char*, columns> column_names{"x", "y", "heading", "direction", "speed"};

struct Named {
  Column column;
  bool degrees = false;
};

std::optional<Named> column_of(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return static_cast<char>(c < 0x80 ? std::tolower(c) : c); });
  if (name == "x") return Named{x_column};
  if (name == "y") return Named{y_column};
  if (name == "direction" || name == "dir" || name == "gear") return Named{direction_column};
  if (name == "speed") return Named{speed_column};
  constexpr std::string_view degrees = "_deg";
  const bool in_degrees = name.size() > degrees.size() && name.ends_with(degrees);
  if (in_degrees) name.resize(name.size() - degrees.size());
  if (name == "heading" || name == "theta" || name == "yaw" || name == "th") return Named{heading_column, in_degrees};
  return std::nullopt;
}

class PosesReader {
 public:
  explicit PosesReader(const std::string& name) : name_{name} {}

  Parsed<std::vector<Row>> read(const std::string& text) {
    const auto walked = walk_csv_table(text, name_, most_rows, "a header that names x, y, heading and optionally direction", [this](CsvRow&& row, bool is_header) {
      line_ = row.line;
      if (is_header) read_header(row.cells);
      else read_row(row.cells);
      return error_;
    });
    if (!walked) return tl::unexpected{walked.error()};
    return std::move(rows_);
  }

  /// Headings that look like degrees; empty where there are none.
  std::string doubt() const {
    if (doubts_ == 0) return {};
    const std::string more = doubts_ == 1 ? "" : fmt::format("; so are {} more", doubts_ - 1);
    return fmt::format("{}{}; a column heading_deg takes degrees", first_doubt_, more);
  }

 private:
  void read_header(const std::vector<std::string>& names) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto named = column_of(names[i]);
      if (!named) continue;
      if (where_[named->column]) return refuse(fmt::format("the header names two columns for {}", column_names[named->column]), "one");
      where_[named->column] = i;
      if (named->column == heading_column) in_degrees_ = named->degrees;
    }
    for (const Column column : {x_column, y_column, heading_column}) {
      if (where_[column]) continue;
      return refuse(fmt::format("the header names no column \"{}\"", column_names[column]), "x, y, heading (or theta, yaw, th; heading_deg for degrees) and optionally direction (or dir, gear)");
    }
  }

  void read_row(const std::vector<std::string>& cells) {
    std::array<double, columns> values{};
    for (const Column column : {x_column, y_column, heading_column, direction_column, speed_column}) {
      if (!where_[column]) continue;
      const char* name = column_names[column];
      const std::string& cell = cells[*where_[column]];
      if (column == speed_column && cell.empty()) continue;  // not told
      if (cell.empty()) return refuse(fmt::format("{} is missing", name), "a number");
      const auto value = csv_number(cell);
      if (!value) return refuse(fmt::format("{} is \"{}\"", name, shortened(cell)), "a finite number");
      if (std::abs(*value) > largest_coordinate) {
        return refuse(fmt::format("{} of {} is out of range", name, *value), fmt::format("{} to {}", -largest_coordinate, largest_coordinate));
      }
      values[column] = *value;
    }
    double& heading = values[heading_column];
    if (in_degrees_) heading = std::fmod(heading, 360.0) / 180.0 * pi;
    else if (const auto sentence = heading_doubt(heading); sentence && doubts_++ == 0) first_doubt_ = fmt::format("line {}: heading: {}", line_, *sentence);
    Row row{{values[x_column], values[y_column], wrap(heading)}, std::nullopt};
    if (where_[direction_column]) {
      const double d = values[direction_column];
      if (d != 1.0 && d != -1.0 && d != 0.0) return refuse(fmt::format("direction is {}", d), "1, -1, 0");
      row.direction = static_cast<int>(d);
    }
    if (where_[speed_column] && !cells[*where_[speed_column]].empty()) row.speed = values[speed_column];
    rows_.push_back(row);
  }

  void refuse(std::string problem, std::string allowed) { error_ = InputError{name_, fmt::format("line {}", line_), std::move(problem), std::move(allowed)}; }

  const std::string& name_;
  std::size_t line_ = 1;
  std::array<std::optional<std::size_t>, columns> where_{};
  bool in_degrees_ = false;
  std::size_t doubts_ = 0;
  std::string first_doubt_;
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

Parsed<Path> parse_poses_csv(const std::string& text, const std::string& name, std::vector<std::string>* notes, std::vector<PoseSpeed>* speeds) {
  PosesReader reader{name};
  const auto rows = reader.read(text);
  if (!rows) return tl::unexpected{rows.error()};
  if (std::string doubt = reader.doubt(); notes != nullptr && !doubt.empty()) notes->push_back(std::filesystem::path{name}.filename().string() + ": " + std::move(doubt));
  if (speeds != nullptr) {
    for (const Row& row : *rows) {
      if (row.speed) speeds->push_back({row.pose, *row.speed});
    }
  }
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

Parsed<Path> read_poses_csv(const std::filesystem::path& file, std::vector<std::string>* notes, std::vector<PoseSpeed>* speeds) {
  auto text = read_file(file, largest_csv);
  if (!text) return tl::unexpected{text.error()};
  return parse_poses_csv(*text, file.string(), notes, speeds);
}

}  // namespace waywright
