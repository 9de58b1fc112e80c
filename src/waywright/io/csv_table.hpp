// A table from a CSV file: a header and rows of cells.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/core/result.hpp"

namespace waywright {

struct CsvRow {
  std::size_t line = 0;  ///< in the file, from 1
  std::vector<std::string> cells;  ///< as many as the header has
};

struct CsvTable {
  std::vector<std::string> header;
  std::vector<CsvRow> rows;
};

/// The whole cell as a finite number with a decimal point, whatever the locale; empty where it is none.
std::optional<double> csv_number(std::string_view cell);

/// The header, then each row as it is read, for tables that are too long to be kept; stops at the first error that `take` returns.
/// The rules are those of parse_csv_table.
Parsed<void> walk_csv_table(const std::string& text, const std::string& name, std::size_t most_rows, const std::string& wanted,
                            const std::function<std::optional<InputError>(CsvRow&&, bool is_header)>& take);

/// UTF-8; separated by tab, semicolon or comma, whichever the header has first in this order; cells that hold one stand in double quotes, a
/// quote in them twice. Blanks about a cell do not count, lines that begin with # are skipped, cells missing at a row's end are empty.
/// Refuses rows longer than the header (but for empty cells), text that is not UTF-8, and quotes that are not closed on their line. `wanted` says what header is
/// asked for.
Parsed<CsvTable> parse_csv_table(const std::string& text, const std::string& name, std::size_t most_rows, const std::string& wanted);

}  // namespace waywright
