// Data from elsewhere, read in place.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

namespace waywright::test {

inline constexpr const char* no_outside_data = "no outside data (WAYWRIGHT_TEST_DATA)";

/// A folder of it, below WAYWRIGHT_TEST_DATA or, without that, ../shared/data; empty where it is not there, and the test is to be skipped.
inline std::optional<std::filesystem::path> outside_data(const char* folder) {
  const char* given = std::getenv("WAYWRIGHT_TEST_DATA");
  std::filesystem::path path = std::filesystem::path{given != nullptr ? given : std::string{WAYWRIGHT_SOURCE_DIR} + "/../shared/data"} / folder;
  return std::filesystem::is_directory(path) ? std::optional{std::move(path)} : std::nullopt;
}

}  // namespace waywright::test
