// Every place of a site planned and proven, and only what changed planned again.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "waywright/core/result.hpp"
#include "waywright/io/place_record.hpp"
#include "waywright/map/world.hpp"
#include "waywright/scenario/scenario.hpp"

namespace waywright {

/// A map that several places share, with what is made of it for distance questions.
class SharedMap {
 public:
  SharedMap(Map map, std::string sha256) : map_{std::move(map)}, sha256_{std::move(sha256)} {}
  const Map& map() const { return map_; }
  const std::string& sha256() const { return sha256_; }  ///< of its content
  /// World{map()}, not built; made when it is asked for first, by whichever thread.
  const World& world() const;

 private:
  Map map_;
  std::string sha256_;
  mutable std::once_flag made_;
  mutable World world_;
};

/// One mission at one place. Places of the same map share it.
struct Place {
  std::string name;
  std::string folder;  ///< of its files, below the check's
  std::string origin;  ///< file, or file and line, for messages
  Scenario scenario;   ///< as used, parameters complete; its map holds nothing but the notes
  std::shared_ptr<const SharedMap> map;
};

/// Maps by content: one of each is kept.
class SharedMaps {
 public:
  /// The map as it is kept; `map` is emptied but for its notes.
  std::shared_ptr<const SharedMap> take(Map& map);

 private:
  std::map<std::string, std::shared_ptr<const SharedMap>> maps_;
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
