#include "waywright/study/front_folder.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "waywright/io/csv_table.hpp"
#include "waywright/io/files.hpp"

namespace waywright {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t largest_front = 1ULL << 20;  // bytes
constexpr std::size_t most_plans = 10'000;

/// How many plans the front.csv of a folder lists, as front_csv writes them; 0 where there is none, or another one.
std::size_t plans_listed(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return 0;
  const auto text = read_file(file, largest_front);
  if (!text) return 0;
  const auto table = parse_csv_table(*text, file.string(), most_plans, "");
  if (!table) return 0;
  const auto column = std::find(table->header.begin(), table->header.end(), "plan");
  if (column == table->header.end()) return 0;
  const auto at = static_cast<std::size_t>(column - table->header.begin());
  for (std::size_t i = 0; i < table->rows.size(); ++i) {
    if (table->rows[i].cells[at] != front_plan_folder(i) + "/plan.json") return 0;
  }
  return table->rows.size();
}

}  // namespace

std::string front_plan_folder(std::size_t index) { return fmt::format("{:02}", index + 1); }

Parsed<void> remove_earlier_plans(const fs::path& folder, std::size_t kept) {
  const std::size_t listed = plans_listed(folder / "front.csv");
  for (std::size_t i = kept; i < listed; ++i) {
    const fs::path place = folder / front_plan_folder(i);
    std::error_code error;
    for (const char* name : {"plan.json", "plan.svg", "report.html"}) {
      fs::remove(place / name, error);
      if (error && error != std::errc::not_a_directory) return tl::unexpected{InputError{(place / name).string(), "", "the file of an earlier front cannot be removed: " + error.message(), ""}};
    }
    fs::remove(place, error);  // which keeps it where something else is in it
  }
  return {};
}

}  // namespace waywright
