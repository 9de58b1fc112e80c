// stations.csv: the places of a site, one a line.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "waywright/core/result.hpp"
#include "waywright/io/scenario_io.hpp"

namespace waywright {

/// For rows that do not say it themselves.
struct SiteDefaults {
  std::optional<double> clearance;  ///< m
  std::string planner;              ///< empty: the scenario's default
  std::optional<std::uint64_t> seed;
};

struct SiteRow {
  std::string name;
  std::string origin;  ///< "stations.csv: line 7", for messages
  Scenario scenario;   ///< without the map, which is the site's; its notes are there
  std::vector<std::string> notes;  ///< of them, those of this row alone
};

/// Every row becomes a scenario object that the scenario's reader reads: what it refuses is told with the row's line, its name and the
/// column. docs/formats.md lists the columns.
Parsed<std::vector<SiteRow>> read_site_csv(const std::filesystem::path& file, const Site& site, const SiteDefaults& defaults = {});
Parsed<std::vector<SiteRow>> parse_site_csv(const std::string& text, const std::string& name, const Site& site, const SiteDefaults& defaults = {});

}  // namespace waywright
