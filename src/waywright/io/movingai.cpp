// MovingAI's maps of characters (N. Sturtevant, Benchmarks for Grid-Based Pathfinding, 2012).
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "waywright/io/files.hpp"
#include "waywright/io/image.hpp"
#include "waywright/io/map_io.hpp"

namespace waywright {
namespace {

constexpr std::uint64_t largest_file = (1ULL << 30) + (1ULL << 20);  // bytes: the most cells, and line ends

/// The lines of a text, without their ends of one or two characters.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_{text} {}
  bool is_done() const { return rest_.empty(); }
  std::string_view next() {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    ++number_;
    return line;
  }
  int number() const { return number_; }  ///< of the line given last, from 1

 private:
  std::string_view rest_;
  int number_ = 0;
};

std::string_view without_spaces(std::string_view text) {
  const auto is_space = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

/// "height 512": the number, 0 where it is none that can be used.
int side(std::string_view line, std::string_view name) {
  if (line.substr(0, name.size()) != name) return 0;
  line = without_spaces(line.substr(name.size()));
  int value = 0;
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), value);
  return error == std::errc{} && end == line.data() + line.size() && value >= 1 && value <= largest_side ? value : 0;
}

constexpr std::string_view free_characters = ".GS";
constexpr std::string_view blocked_characters = "@OTW";

}  // namespace

Parsed<LoadedGrid> decode_movingai_map(const std::string& bytes, const std::string& name, double cell) {
  Lines lines{bytes};
  const auto refuse = [&](std::string field, std::string problem, std::string allowed) {
    return tl::unexpected{InputError{name, std::move(field), std::move(problem), std::move(allowed)}};
  };
  if (without_spaces(lines.next()) != "type octile") return refuse("", "line 1 is not \"type octile\"", "a MovingAI map: type octile, height, width, map, then a line of characters a row");
  const std::string sides = fmt::format("a whole number, 1 to {}", largest_side);
  const int rows = side(without_spaces(lines.next()), "height");
  if (rows == 0) return refuse("height", "line 2 is not \"height\" and a number that can be used", sides);
  const int columns = side(without_spaces(lines.next()), "width");
  if (columns == 0) return refuse("width", "line 3 is not \"width\" and a number that can be used", sides);
  if (without_spaces(lines.next()) != "map") return refuse("", "line 4 is not \"map\"", "map");

  // Before memory is asked for: there must be as many characters as cells.
  const std::size_t cells = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  if (bytes.size() < cells) return refuse("", fmt::format("it has {} bytes, too few for {} x {} cells", bytes.size(), columns, rows), "a line of characters for each row");
  LoadedGrid loaded;
  loaded.grid.columns = columns;
  loaded.grid.rows = rows;
  loaded.grid.cell = cell;
  loaded.grid.blocked.reserve(cells);
  for (int row = 0; row < rows; ++row) {
    if (lines.is_done()) return refuse("", fmt::format("it ends after {} of {} rows", row, rows), "a line of characters for each row");
    const std::string_view line = lines.next();
    if (line.size() != static_cast<std::size_t>(columns)) return refuse("", fmt::format("line {} has {} characters", lines.number(), line.size()), fmt::format("as many as the width, {}", columns));
    for (std::size_t i = 0; i < line.size(); ++i) {
      const bool is_free = free_characters.find(line[i]) != std::string_view::npos;
      if (!is_free && blocked_characters.find(line[i]) == std::string_view::npos) {
        const bool is_plain = line[i] > 0x20 && line[i] < 0x7F;
        return refuse("", fmt::format("line {} has {} in column {}", lines.number(), is_plain ? fmt::format("\"{}\"", line[i]) : fmt::format("the byte {}", static_cast<unsigned char>(line[i])), i + 1),
                      ". G S (free), @ O T W (blocked)");
      }
      loaded.grid.blocked.push_back(is_free ? 0 : 1);
    }
  }
  while (!lines.is_done()) {
    if (!without_spaces(lines.next()).empty()) return refuse("", fmt::format("line {} comes after the last row", lines.number()), fmt::format("{} rows, as the height says", rows));
  }
  return loaded;
}

Parsed<LoadedGrid> load_movingai_map(const std::filesystem::path& path, double cell) {
  auto bytes = read_file(path, largest_file);
  if (!bytes) return tl::unexpected{bytes.error()};
  auto loaded = decode_movingai_map(*bytes, path.string(), cell);
  if (!loaded) return loaded;
  loaded->grid.name = path.filename().string();
  loaded->files = {{path.string(), sha256(*bytes)}};
  return loaded;
}

}  // namespace waywright
