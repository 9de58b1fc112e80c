#include "waywright/io/opentcs_map.hpp"

#include <expat.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

#include "waywright/core/angle.hpp"
#include "waywright/io/json_reader.hpp"

namespace waywright {
namespace {

constexpr std::size_t largest = 64U << 20U;  // bytes
constexpr std::size_t deepest = 32;          // elements in each other
constexpr std::size_t most_parts = 100'000;  // points, paths, locations, vehicles: of each kind
constexpr std::size_t most_controls = 1000;  // of one path
constexpr double millimetre = 1e-3;
constexpr double largest_raw_coordinate = 1e9;  // m, before a transform
constexpr double most_millimetres = 1e12;
constexpr double chord_error = 0.02;  // m
constexpr int most_chords = 64;
constexpr double doubtful = 0.01;  // of a length: stated ones that differ by more are told

class Attributes {
 public:
  explicit Attributes(const XML_Char** pairs) : pairs_{pairs} {}
  std::optional<std::string_view> get(std::string_view name) const {
    for (const XML_Char** p = pairs_; p[0] != nullptr; p += 2) {
      if (name == p[0]) return p[1];
    }
    return std::nullopt;
  }

 private:
  const XML_Char** pairs_;
};

std::optional<double> number_of(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// A path as it stands in the file: its points may come later.
struct DrawnPath {
  std::string name, from, to, form;
  std::size_t line = 0;
  double speed = 0.0, reverse_speed = 0.0;  // mm/s
  std::optional<double> stated{};           // mm
  bool is_locked = false;
  std::vector<Vec2> controls;  // units of the layout
};

struct DrawnLocation {
  std::string name;
  Vec2 at{};
  std::vector<std::pair<std::string, std::size_t>> links;  // point, line
};

/// A cubic or quadratic Bézier curve by chords: by the second differences of its control points they are within chord_error of it.
void add_chords(Polyline& course, const std::vector<Vec2>& hull) {
  double bend = 0.0;
  for (std::size_t i = 0; i + 2 < hull.size(); ++i) bend = std::max(bend, norm(hull[i] - 2.0 * hull[i + 1] + hull[i + 2]));
  const double degree = static_cast<double>(hull.size() - 1);
  const int chords = std::clamp(static_cast<int>(std::ceil(std::sqrt(degree * (degree - 1.0) * bend / (8.0 * chord_error)))), 1, most_chords);
  for (int k = 1; k < chords; ++k) {
    std::vector<Vec2> level = hull;
    const double t = static_cast<double>(k) / chords;
    for (std::size_t n = level.size() - 1; n > 0; --n) {
      for (std::size_t i = 0; i < n; ++i) level[i] = level[i] + t * (level[i + 1] - level[i]);
    }
    course.push_back(level.front());
  }
  course.push_back(hull.back());
}

class Model {
 public:
  explicit Model(const std::string& name) : name_{name} {}

  Parsed<PlantModel> read(const std::string& bytes) {
    const std::unique_ptr<std::remove_pointer_t<XML_Parser>, decltype(&XML_ParserFree)> parser{XML_ParserCreate(nullptr), &XML_ParserFree};
    if (!parser) return tl::unexpected{InputError{name_, "", "there is not enough memory to read it", ""}};
    parser_ = parser.get();
    XML_SetUserData(parser_, this);
    XML_SetElementHandler(
        parser_, [](void* self, const XML_Char* element, const XML_Char** attributes) { static_cast<Model*>(self)->begin(element, Attributes{attributes}); },
        [](void* self, const XML_Char*) { static_cast<Model*>(self)->end(); });
    XML_SetEntityDeclHandler(parser_, [](void* self, const XML_Char*, int, const XML_Char*, int, const XML_Char*, const XML_Char*, const XML_Char*, const XML_Char*) {
      static_cast<Model*>(self)->refuse("it declares entities", "a model without a DTD of its own");
    });
    const bool parsed = XML_Parse(parser_, bytes.data(), static_cast<int>(bytes.size()), XML_TRUE) == XML_STATUS_OK;
    if (error_) return tl::unexpected{*error_};
    if (!parsed) {
      return tl::unexpected{InputError{name_, fmt::format("line {}", XML_GetCurrentLineNumber(parser_)), fmt::format("not valid XML: {}", XML_ErrorString(XML_GetErrorCode(parser_))), ""}};
    }
    if (graph().places.empty()) return tl::unexpected{InputError{name_, "", "there is no point in it", "an openTCS plant model with points and paths"}};
    if (!take_paths() || !take_locations()) return tl::unexpected{*error_};
    tell();
    return std::move(plant_);
  }

 private:
  LaneGraph& graph() { return plant_.lanes; }

  bool refuse_at(std::size_t line, const std::string& what, std::string problem, std::string allowed) {
    if (!error_) error_ = InputError{name_, fmt::format("line {}", line) + (what.empty() ? "" : fmt::format(" ({})", shortened(what))), std::move(problem), std::move(allowed)};
    return false;
  }
  bool refuse(std::string problem, std::string allowed) {
    const bool first = !error_;
    refuse_at(line(), title_, std::move(problem), std::move(allowed));
    if (first) XML_StopParser(parser_, XML_FALSE);
    return false;
  }
  std::size_t line() const { return static_cast<std::size_t>(XML_GetCurrentLineNumber(parser_)); }

  void begin(std::string_view element, const Attributes& attributes) {
    if (error_) return;
    if (open_.size() >= deepest) {
      refuse("elements are nested too deeply", fmt::format("at most {} levels", deepest));
      return;
    }
    if (open_.empty() && element != "model") {
      refuse(fmt::format("it is a document of <{}>", shortened(std::string{element})), "<model>, the plant model of openTCS");
      return;
    }
    // What belongs to a part stands in it, and the part in the model; elsewhere the same names mean nothing.
    const std::string_view part = open_.size() > 1 ? std::string_view{open_[1]} : std::string_view{};
    if (open_.size() == 1) {
      title_ = std::string{attributes.get("name").value_or("")};
      if (element == "point") take_point(attributes);
      else if (element == "path") begin_path(attributes);
      else if (element == "location") begin_location(attributes);
      else if (element == "vehicle") take_vehicle(attributes);
      else if (element == "visualLayout") take_layout(attributes);
    } else if (open_.size() == 3 && part == "path" && open_.back() == "pathLayout" && element == "controlPoint") {
      take_control(attributes);
    } else if (open_.size() == 2 && part == "path" && element == "pathLayout") {
      paths_.back().form = std::string{attributes.get("connectionType").value_or("DIRECT")};
    } else if (open_.size() == 2 && part == "location" && element == "link") {
      locations_.back().links.emplace_back(std::string{attributes.get("point").value_or("")}, line());
    } else if (open_.size() == 2 && part == "vehicle" && element == "boundingBox") {
      take_box(attributes);
    }
    open_.emplace_back(element);
  }

  void end() {
    if (!open_.empty()) open_.pop_back();
  }

  /// A number in millimetres (a second, for speeds), by one of the names that versions give it.
  std::optional<double> millimetres(const Attributes& attributes, std::initializer_list<const char*> names, double least, std::optional<double> fallback = std::nullopt) {
    for (const char* name : names) {
      const auto text = attributes.get(name);
      if (!text) continue;
      const auto value = number_of(*text);
      if (!value || *value < least || *value > most_millimetres) {
        refuse(fmt::format("{} is \"{}\"", name, shortened(std::string{*text})), fmt::format("a number from {:g} to {:g}, in millimetres", least, most_millimetres));
        return std::nullopt;
      }
      return value;
    }
    if (!fallback) refuse(fmt::format("it has no {}", *names.begin()), "a number in millimetres");
    return fallback;
  }

  bool is_named(std::size_t count, const char* what) {
    if (title_.empty()) return refuse(fmt::format("a {} has no name", what), "a name");
    if (count >= most_parts) return refuse(fmt::format("it has over {} {}s", most_parts, what), fmt::format("at most {}", most_parts));
    return true;
  }

  void take_point(const Attributes& attributes) {
    if (!is_named(graph().places.size(), "point")) return;
    const auto x = millimetres(attributes, {"positionX", "xPosition"}, -most_millimetres), y = x ? millimetres(attributes, {"positionY", "yPosition"}, -most_millimetres) : x;
    if (!x || !y) return;
    LanePlace place{one_line(title_), {millimetre * *x, millimetre * *y}, {}};
    if (const auto angle = attributes.get("vehicleOrientationAngle"); angle && *angle != "NaN") {
      const auto degrees = number_of(*angle);
      if (!degrees || std::abs(*degrees) > 1e6) {
        refuse(fmt::format("vehicleOrientationAngle is \"{}\"", shortened(std::string{*angle})), "degrees, or NaN where any will do");
        return;
      }
      place.heading = wrap(*degrees * std::numbers::pi / 180.0);
    }
    if (!by_name_.emplace(title_, graph().places.size()).second) {
      refuse("another point has this name", "names that stand once");
      return;
    }
    graph().places.push_back(std::move(place));
  }

  void begin_path(const Attributes& attributes) {
    if (!is_named(paths_.size(), "path")) return;
    DrawnPath path;
    path.name = title_;
    path.line = line();
    path.from = std::string{attributes.get("sourcePoint").value_or("")};
    path.to = std::string{attributes.get("destinationPoint").value_or("")};
    path.form = "DIRECT";
    path.is_locked = attributes.get("locked").value_or("") == "true";
    const auto speed = millimetres(attributes, {"maxVelocity"}, 0.0), reverse = speed ? millimetres(attributes, {"maxReverseVelocity"}, 0.0, 0.0) : speed;
    if (!reverse) return;
    if (attributes.get("length")) {
      path.stated = millimetres(attributes, {"length"}, 0.0);
      if (!path.stated) return;
    }
    path.speed = *speed;
    path.reverse_speed = *reverse;
    paths_.push_back(std::move(path));
  }

  void take_control(const Attributes& attributes) {
    const auto x = millimetres(attributes, {"x"}, -most_millimetres), y = x ? millimetres(attributes, {"y"}, -most_millimetres) : x;
    if (!x || !y) return;
    std::vector<Vec2>& controls = paths_.back().controls;
    if (controls.size() >= most_controls) {
      refuse(fmt::format("it has over {} control points", most_controls), fmt::format("at most {}", most_controls));
      return;
    }
    controls.push_back({*x, *y});
  }

  void begin_location(const Attributes& attributes) {
    if (!is_named(locations_.size(), "location")) return;
    const auto x = millimetres(attributes, {"positionX", "xPosition"}, -most_millimetres), y = x ? millimetres(attributes, {"positionY", "yPosition"}, -most_millimetres) : x;
    if (!x || !y) return;
    locations_.push_back({title_, {millimetre * *x, millimetre * *y}, {}});
  }

  void take_vehicle(const Attributes& attributes) {
    if (!is_named(graph().vehicles.size(), "vehicle")) return;
    const auto speed = millimetres(attributes, {"maxVelocity"}, 0.0, 0.0);
    if (!speed) return;
    LaneVehicle vehicle{one_line(title_), 0.0, 0.0, {}, {}};
    if (*speed > 0.0) vehicle.speed = millimetre * *speed;
    if (const auto length = attributes.get("length")) {  // before version 6 its length alone
      const auto metres = millimetres(attributes, {"length"}, 0.0);
      if (!metres) return;
      vehicle.length = vehicle.width = millimetre * *metres;
    }
    graph().vehicles.push_back(std::move(vehicle));
  }

  void take_box(const Attributes& attributes) {
    const auto length = millimetres(attributes, {"length"}, 0.0), width = length ? millimetres(attributes, {"width"}, 0.0) : length;
    const auto x = width ? millimetres(attributes, {"referenceOffsetX"}, -most_millimetres, 0.0) : width, y = x ? millimetres(attributes, {"referenceOffsetY"}, -most_millimetres, 0.0) : x;
    if (!y) return;
    LaneVehicle& vehicle = graph().vehicles.back();
    vehicle.length = millimetre * *length;
    vehicle.width = millimetre * *width;
    vehicle.reference = {millimetre * *x, millimetre * *y};
  }

  void take_layout(const Attributes& attributes) {
    const auto x = millimetres(attributes, {"scaleX"}, 1e-6, 50.0), y = x ? millimetres(attributes, {"scaleY"}, 1e-6, 50.0) : x;
    if (x && y) layout_scale_ = {*x, *y};
  }

  std::optional<std::size_t> point(const std::string& name) const {
    const auto found = by_name_.find(name);
    return found == by_name_.end() ? std::nullopt : std::optional{found->second};
  }

  bool take_paths() {
    for (const DrawnPath& path : paths_) {
      const auto from = point(path.from), to = point(path.to);
      if (!from || !to) return refuse_at(path.line, path.name, fmt::format("its {} \"{}\" is no point of the model", from ? "destinationPoint" : "sourcePoint", shortened(from ? path.to : path.from)), "names of points");
      if (*from == *to) return refuse_at(path.line, path.name, "it leads from a point to itself", "two points");
      const bool is_forwards = path.speed > 0.0, is_backwards = path.reverse_speed > 0.0;
      if (path.is_locked || (!is_forwards && !is_backwards)) {
        ++(path.is_locked ? locked_ : still_);
        continue;
      }
      Lane lane;
      lane.name = one_line(path.name);
      lane.from = *from;
      lane.to = *to;
      lane.course = course_of(path, graph().places[*from].at, graph().places[*to].at);
      for (const Vec2 p : lane.course) {
        if (!(std::max(std::abs(p.x), std::abs(p.y)) <= largest_raw_coordinate)) return refuse_at(path.line, path.name, fmt::format("it is drawn through ({:g}, {:g})", p.x, p.y), "coordinates within 1e9 m");
      }
      lane.is_both_ways = is_forwards && is_backwards;
      if (!is_forwards) {
        std::swap(lane.from, lane.to);
        std::reverse(lane.course.begin(), lane.course.end());
      }
      // Of one that is driven both ways the slower speed holds for both: a zone knows no direction.
      lane.speed = millimetre * (lane.is_both_ways ? std::min(path.speed, path.reverse_speed) : std::max(path.speed, path.reverse_speed));
      const double drawn = length(lane);
      if (path.stated && std::abs(millimetre * *path.stated - drawn) > doubtful * drawn) ++otherwise_long_;
      graph().lanes.push_back(std::move(lane));
    }
    return true;
  }

  /// The layout's y axis points down, and its units are millimetres by its scale.
  Polyline course_of(const DrawnPath& path, Vec2 from, Vec2 to) {
    std::vector<Vec2> hull{from};
    for (const Vec2 c : path.controls) hull.push_back({millimetre * c.x * layout_scale_.x, -millimetre * c.y * layout_scale_.y});
    hull.push_back(to);
    Polyline course{from};
    if (path.form == "BEZIER" && (hull.size() == 3 || hull.size() == 4)) {
      add_chords(course, hull);
    } else if (path.form == "POLYPATH") {
      course = hull;
    } else {
      if (path.form != "DIRECT") ++straightened_[path.form];
      course.push_back(to);
    }
    course.erase(std::unique(course.begin(), course.end()), course.end());
    if (course.size() < 2) course = {from, to};
    return course;
  }

  bool take_locations() {
    for (const DrawnLocation& location : locations_) {
      LaneStation station{one_line(location.name), location.at, {}};
      for (const auto& [name, line] : location.links) {
        const auto place = point(name);
        if (!place) return refuse_at(line, location.name, fmt::format("its link \"{}\" is no point of the model", shortened(name)), "names of points");
        station.places.push_back(*place);
      }
      graph().stations.push_back(std::move(station));
    }
    return true;
  }

  void tell() {
    for (std::string& sentence : describe(graph())) plant_.notes.push_back(std::move(sentence));
    const auto counted = [](std::size_t n, const char* one) { return fmt::format("{} {}{}", n, one, n == 1 ? "" : "s"); };
    if (locked_ > 0) plant_.notes.push_back(fmt::format("left out: {}", counted(locked_, "locked path")));
    if (still_ > 0) plant_.notes.push_back(fmt::format("left out: {} whose velocities are 0", counted(still_, "path")));
    for (const auto& [form, count] : straightened_) plant_.notes.push_back(fmt::format("taken as straight lines: {} of form {}", counted(count, "path"), shortened(form)));
    if (otherwise_long_ > 0) plant_.notes.push_back(fmt::format("{} stated to be of another length than drawn; the drawn one counts", otherwise_long_ == 1 ? "1 path is" : fmt::format("{} paths are", otherwise_long_)));
  }

  std::string name_;
  XML_Parser parser_ = nullptr;
  std::optional<InputError> error_;
  std::vector<std::string> open_;
  std::string title_;  ///< of the part that is being read
  std::map<std::string, std::size_t> by_name_;
  std::vector<DrawnPath> paths_;
  std::vector<DrawnLocation> locations_;
  Vec2 layout_scale_{50.0, 50.0};
  std::size_t locked_ = 0, still_ = 0, otherwise_long_ = 0;
  std::map<std::string, std::size_t> straightened_;
  PlantModel plant_;
};

}  // namespace

Parsed<PlantModel> decode_opentcs_map(const std::string& bytes, const std::string& name) {
  if (bytes.size() > largest) return tl::unexpected{InputError{name, "", fmt::format("it has {} bytes", bytes.size()), fmt::format("at most {}", largest)}};
  return Model{name}.read(bytes);
}

}  // namespace waywright
