// Every place of a site planned and proven, and only what changed planned again.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "waywright/core/result.hpp"
#include "waywright/io/place_record.hpp"
#include "waywright/scenario/scenario.hpp"

namespace waywright {

/// One mission at one place. Places of the same map share it.
struct Place {
  std::string name;
  std::string folder;  ///< of its files, below the check's
  std::string origin;  ///< file, or file and line, for messages
  Scenario scenario;   ///< as used, parameters complete; its map holds nothing but the notes
  std::shared_ptr<const Map> map;
  std::string map_sha256;  ///< of its content
};

/// Maps by content: one of each is kept.
class SharedMaps {
 public:
  /// The map as it is kept, and the hash of its content; `map` is emptied but for its notes.
  std::pair<std::shared_ptr<const Map>, std::string> take(Map& map);

 private:
  std::map<std::string, std::shared_ptr<const Map>> maps_;
};

/// Completes the planner's parameters, finds every place a folder of its own, and holds vehicle and mission against each other; what cannot
/// be used is told with the place's origin.
Parsed<void> complete_places(std::vector<Place>& places);

/// Lower-case hexadecimal SHA-256 of all that the answer depends on: map, vehicle, mission, planner, parameters, seed, program version.
std::string key_of(const Place& place);

/// A name as a folder's: letters, digits, '-', '_', '.' and what is beyond ASCII are kept, the rest becomes '-'; at most 80 bytes.
std::string folder_name(const std::string& name);

struct CheckOptions {
  std::filesystem::path folder;  ///< must be there
  bool fresh = false;            ///< nothing is taken over
  unsigned threads = 0;          ///< 0: all cores
  std::function<void(std::size_t, std::size_t)> progress;  ///< done, total
  const std::atomic<bool>* cancel = nullptr;
};

struct Checked {
  std::size_t place = 0;
  bool taken_over = false;
  PlaceFigures figures;
};

/// Plans and proves every place that has no whole result with the same key in its folder, and writes plan.json, plan.svg, report.html, small.svg
/// and place.json there, all or none. What ran out of time is tried again. Places come back in their order, whatever the number of threads;
/// what was canceled is left out. An error is one of writing.
Parsed<std::vector<Checked>> check(const std::vector<Place>& places, const CheckOptions& options);

}  // namespace waywright
