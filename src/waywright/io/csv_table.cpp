#include "waywright/io/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace waywright {
namespace {

constexpr std::size_t longest_line = 1 << 16;  // bytes
constexpr std::size_t most_columns = 1000;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// Well formed, without surrogates and overlong forms.
bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t more = lead < 0x80 ? 0 : lead >= 0xC2 && lead < 0xE0 ? 1 : lead >= 0xE0 && lead < 0xF0 ? 2 : lead >= 0xF0 && lead < 0xF5 ? 3 : 4;
    if (more == 4 || i + more >= text.size()) return false;
    for (std::size_t k = 1; k <= more; ++k) {
      const auto c = static_cast<unsigned char>(text[i + k]);
      unsigned char low = 0x80, high = 0xBF;
      if (k == 1 && lead == 0xE0) low = 0xA0;
      if (k == 1 && lead == 0xED) high = 0x9F;
      if (k == 1 && lead == 0xF0) low = 0x90;
      if (k == 1 && lead == 0xF4) high = 0x8F;
      if (c < low || c > high) return false;
    }
    i += more + 1;
  }
  return true;
}

/// The separators outside of quotes that a line has; tab before semicolon before comma.
char separator_of(std::string_view line) {
  char best = ',';
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == '\t') return c;
    if (c == ';') best = c;
  }
  return best;
}

/// The cells of a line; empty where a quote is not closed, or more than blanks stand beside a quoted cell.
std::optional<std::vector<std::string>> cells_of(std::string_view line, char separator) {
  std::vector<std::string> cells;
  std::size_t at = 0;
  const auto skip_blanks = [&] {
    while (at < line.size() && is_blank(line[at]) && line[at] != separator) ++at;
  };
  for (;;) {
    skip_blanks();
    std::string cell;
    if (at < line.size() && line[at] == '"') {
      for (++at;; ++at) {
        if (at >= line.size()) return std::nullopt;
        if (line[at] != '"') cell += line[at];
        else if (at + 1 < line.size() && line[at + 1] == '"') cell += line[at++];
        else break;
      }
      ++at;
      skip_blanks();
      if (at < line.size() && line[at] != separator) return std::nullopt;
      cell = trimmed(cell);
    } else {
      const std::size_t end = std::min(line.find(separator, at), line.size());
      cell = trimmed(line.substr(at, end - at));
      at = end;
    }
    cells.push_back(std::move(cell));
    if (at >= line.size()) return cells;
    ++at;
  }
}

}  // namespace

std::optional<double> csv_number(std::string_view cell) {
  if (cell.size() > 1 && cell.front() == '+' && cell[1] != '-') cell.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (cell.empty() || error != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

Parsed<void> walk_csv_table(const std::string& text, const std::string& name, std::size_t most_rows, const std::string& wanted,
                            const std::function<std::optional<InputError>(CsvRow&&, bool)>& take) {
  std::string_view rest = text;
  if (rest.substr(0, 3) == "\xEF\xBB\xBF") rest.remove_prefix(3);
  char separator = ',';
  std::size_t number = 0, columns = 0, rows = 0;
  const auto refuse = [&](std::string problem, std::string allowed) {
    return tl::unexpected{InputError{name, fmt::format("line {}", number), std::move(problem), std::move(allowed)}};
  };
  while (!rest.empty()) {
    ++number;
    const std::size_t end = rest.find('\n');
    const std::string_view line = rest.substr(0, end);
    rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
    if (line.size() > longest_line) return refuse("the line is too long", fmt::format("at most {} bytes", longest_line));
    if (const std::string_view content = trimmed(line); content.empty() || content.front() == '#') continue;
    if (!is_utf8(line)) return refuse("the text is not UTF-8", "a file saved as UTF-8");
    const bool header = columns == 0;
    if (header) separator = separator_of(line);
    auto cells = cells_of(line, separator);
    if (!cells) return refuse("a quoted cell does not end where it should", "\"…\" about a whole cell, on one line, a quote in it twice");
    if (header) {
      columns = cells->size();
      if (columns > most_columns) return refuse(fmt::format("there are {} columns", columns), fmt::format("at most {}", most_columns));
    } else {
      while (cells->size() > columns && cells->back().empty()) cells->pop_back();
      if (cells->size() > columns) {
        return refuse(fmt::format("there are {} cells, and the header names {}", cells->size(), columns),
                      "no more cells than columns; a cell that holds the separator stands in double quotes");
      }
      if (std::all_of(cells->begin(), cells->end(), [](const std::string& c) { return c.empty(); })) continue;
      if (++rows > most_rows) return refuse("there are too many rows", fmt::format("at most {}", most_rows));
      cells->resize(columns);
    }
    if (auto error = take({number, std::move(*cells)}, header)) return tl::unexpected{*error};
  }
  if (columns == 0) return tl::unexpected{InputError{name, "", "the file is empty: there is no header", wanted}};
  return {};
}

Parsed<CsvTable> parse_csv_table(const std::string& text, const std::string& name, std::size_t most_rows, const std::string& wanted) {
  CsvTable table;
  const auto walked = walk_csv_table(text, name, most_rows, wanted, [&](CsvRow&& row, bool is_header) -> std::optional<InputError> {
    if (is_header) table.header = std::move(row.cells);
    else table.rows.push_back(std::move(row));
    return std::nullopt;
  });
  if (!walked) return tl::unexpected{walked.error()};
  return table;
}

}  // namespace waywright
