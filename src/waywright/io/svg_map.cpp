#include "waywright/io/svg_map.hpp"

#include <expat.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "waywright/io/json_reader.hpp"
#include "waywright/io/svg_path.hpp"

namespace waywright {
namespace {

constexpr std::size_t deepest = 128;          // elements in each other
constexpr std::size_t most_points = 2'000'000;
constexpr std::size_t most_in_one = 1000;        // outlines of one path: each is held against all of them
constexpr double closing = 1e-4;              // of an outline's diagonal: an end so near to its begin is the begin, rounded
constexpr double largest_raw_coordinate = 1e9;  // m, before a transform

/// Elements without anything to see, with all that is in them.
bool has_nothing_to_see(std::string_view element) {
  for (const std::string_view name : {"defs", "metadata", "title", "desc", "style", "script", "namedview", "perspective"}) {
    if (element == name) return true;
  }
  return false;
}

/// "fill" of "stroke:none;fill : #c7c7c7"; empty where it is not there.
std::string of_style(std::string_view style, std::string_view wanted) {
  std::string value;
  while (!style.empty()) {
    const std::size_t end = std::min(style.find(';'), style.size());
    const std::string_view entry = style.substr(0, end);
    style.remove_prefix(std::min(end + 1, style.size()));
    const std::size_t colon = entry.find(':');
    if (colon == std::string_view::npos) continue;
    const auto trimmed = [](std::string_view text) {
      while (!text.empty() && (text.front() == ' ' || text.front() == '\n' || text.front() == '\t')) text.remove_prefix(1);
      while (!text.empty() && (text.back() == ' ' || text.back() == '\n' || text.back() == '\t')) text.remove_suffix(1);
      return text;
    };
    if (trimmed(entry.substr(0, colon)) == wanted) value = trimmed(entry.substr(colon + 1));
  }
  return value;
}

class Attributes {
 public:
  explicit Attributes(const XML_Char** pairs) : pairs_{pairs} {}
  std::optional<std::string_view> get(std::string_view name) const {
    for (const XML_Char** p = pairs_; p[0] != nullptr; p += 2) {
      if (name == p[0]) return p[1];
    }
    return std::nullopt;
  }
  /// A property, which a style says before the attribute of its name does.
  std::string property(std::string_view name) const {
    if (const auto style = get("style")) {
      if (std::string value = of_style(*style, name); !value.empty()) return value;
    }
    return std::string{get(name).value_or("")};
  }

 private:
  const XML_Char** pairs_;
};

class Drawing {
 public:
  Drawing(const std::string& name, double scale) : name_{name}, scale_{scale} {}

  Parsed<Map> read(const std::string& bytes) {
    const std::unique_ptr<std::remove_pointer_t<XML_Parser>, decltype(&XML_ParserFree)> parser{XML_ParserCreate(nullptr), &XML_ParserFree};
    if (!parser) return tl::unexpected{InputError{name_, "", "there is not enough memory to read it", ""}};
    parser_ = parser.get();
    XML_SetUserData(parser_, this);
    XML_SetElementHandler(
        parser_, [](void* self, const XML_Char* element, const XML_Char** attributes) { static_cast<Drawing*>(self)->begin(element, Attributes{attributes}); },
        [](void* self, const XML_Char*) { static_cast<Drawing*>(self)->end(); });
    // Entities have no place in a drawing of polygons, and are where XML parsers suffer.
    XML_SetEntityDeclHandler(parser_, [](void* self, const XML_Char*, int, const XML_Char*, int, const XML_Char*, const XML_Char*, const XML_Char*, const XML_Char*) {
      static_cast<Drawing*>(self)->refuse("it declares entities", "a drawing without a DTD of its own");
    });
    const bool parsed = XML_Parse(parser_, bytes.data(), static_cast<int>(bytes.size()), XML_TRUE) == XML_STATUS_OK;
    if (error_) return tl::unexpected{*error_};
    if (!parsed) {
      return tl::unexpected{InputError{name_, fmt::format("line {}", XML_GetCurrentLineNumber(parser_)), fmt::format("not valid XML: {}", XML_ErrorString(XML_GetErrorCode(parser_))), ""}};
    }
    if (map_.obstacles.empty() && map_.lines.empty()) return tl::unexpected{InputError{name_, "", "there is nothing in it that can be taken", "path, polygon, polyline, line, rect of straight lines"}};
    for (const auto& [what, count] : left_out_) map_.notes.push_back(fmt::format("left out: {} ({})", what, count));
    return std::move(map_);
  }

 private:
  struct Level {
    svg::Transform transform;
    bool is_filled = true;
    bool is_hidden = false;
  };

  void refuse(std::string problem, std::string allowed) {
    if (error_) return;
    error_ = InputError{name_, fmt::format("line {}", XML_GetCurrentLineNumber(parser_)) + (id_.empty() ? "" : fmt::format(" ({})", id_)), std::move(problem), std::move(allowed)};
    XML_StopParser(parser_, XML_FALSE);
  }

  void begin(std::string_view whole_name, const Attributes& attributes) {
    if (error_) return;
    // Prefixes are told apart by what follows: editors' own elements are among those without anything to see.
    const std::size_t colon = whole_name.find(':');
    const std::string_view element = colon == std::string_view::npos ? whole_name : whole_name.substr(colon + 1);
    id_ = shortened(std::string{attributes.get("id").value_or("")});
    if (levels_.size() >= deepest) return refuse("elements are nested too deeply", fmt::format("at most {} levels", deepest));
    Level level = levels_.empty() ? Level{} : levels_.back();
    if (levels_.empty() && element != "svg") return refuse(fmt::format("it is a document of <{}>", shortened(std::string{element})), "an SVG drawing");
    if (!level.is_hidden && has_nothing_to_see(element)) level.is_hidden = true;
    if (!level.is_hidden && !enter(element, attributes, level)) return;
    levels_.push_back(level);
  }

  void end() {
    if (!levels_.empty()) levels_.pop_back();
  }

  /// False where it is refused.
  bool enter(std::string_view element, const Attributes& attributes, Level& level) {
    if (attributes.property("display") == "none" || attributes.property("visibility") == "hidden") {
      ++left_out_["hidden elements"];
      level.is_hidden = true;
      return true;
    }
    if (const std::string fill = attributes.property("fill"); !fill.empty() && fill != "inherit") level.is_filled = fill != "none" && fill != "transparent";
    if (const auto text = attributes.get("transform")) {
      const auto transform = svg::transform(*text);
      if (!transform) return refused(transform.error());
      level.transform = level.transform * *transform;
    }
    if (element == "svg") return levels_.empty() ? place(attributes, level) : refused({"it has a drawing in a drawing", "one svg element"});
    if (element == "g" || element == "a" || element == "switch") return true;
    if (element == "text" || element == "flowRoot" || element == "image") {
      ++left_out_[element == "image" ? "images" : "texts"];
      level.is_hidden = true;
      return true;
    }
    return shape(element, attributes, level);
  }

  bool refused(const svg::Wrong& wrong) {
    refuse(wrong.problem, wrong.allowed);
    return false;
  }

  /// y upwards, from the lower left corner.
  bool place(const Attributes& attributes, Level& level) {
    Vec2 corner{};
    if (const auto text = attributes.get("viewBox")) {
      const auto box = svg::numbers(*text);
      if (!box || box->size() != 4 || !((*box)[2] > 0.0) || !((*box)[3] > 0.0)) return refused({"the viewBox cannot be read", "x, y, width, height with the last two over 0"});
      corner = {(*box)[0], (*box)[1] + (*box)[3]};
    }
    level.transform = svg::Transform{scale_, 0, 0, -scale_, -scale_ * corner.x, scale_ * corner.y} * level.transform;
    return true;
  }

  bool shape(std::string_view element, const Attributes& attributes, const Level& level) {
    const auto number = [&](const char* name) -> std::optional<double> {
      const auto text = attributes.get(name);
      if (!text) return 0.0;
      const auto values = svg::numbers(*text);
      if (!values || values->size() != 1) return std::nullopt;
      return values->front();
    };
    if (element == "path") {
      const auto subpaths = svg::path(attributes.get("d").value_or(""));
      if (!subpaths) return refused(subpaths.error());
      return take(*subpaths, level);
    }
    if (element == "polygon" || element == "polyline") {
      const auto values = svg::numbers(attributes.get("points").value_or(""));
      if (!values || values->size() % 2 != 0) return refused({"the points cannot be read", "x, y of each"});
      svg::Subpath one{{}, element == "polygon"};
      for (std::size_t i = 0; i < values->size(); i += 2) one.points.push_back({(*values)[i], (*values)[i + 1]});
      return take({one}, level);
    }
    if (element == "line") {
      const auto x1 = number("x1"), y1 = number("y1"), x2 = number("x2"), y2 = number("y2");
      if (!x1 || !y1 || !x2 || !y2) return refused({"a coordinate of the line cannot be read", "a number in user units"});
      Level walls = level;
      walls.is_filled = false;
      return take({{{{*x1, *y1}, {*x2, *y2}}, false}}, walls);
    }
    if (element == "rect") {
      const auto x = number("x"), y = number("y"), width = number("width"), height = number("height"), rx = number("rx"), ry = number("ry");
      if (!x || !y || !width || !height || !rx || !ry) return refused({"a number of the rect cannot be read", "numbers in user units"});
      if (*rx != 0.0 || *ry != 0.0) return refused({"the rect has round corners", "straight lines"});
      if (!(*width > 0.0) || !(*height > 0.0)) return true;  // SVG does not draw it
      return take({{{{*x, *y}, {*x + *width, *y}, {*x + *width, *y + *height}, {*x, *y + *height}}, true}}, level);
    }
    return refused({fmt::format("<{}> is not read", shortened(std::string{element})), "path, polygon, polyline, line and rect of straight lines, in groups"});
  }

  bool take(const std::vector<svg::Subpath>& subpaths, const Level& level) {
    const std::size_t first = map_.obstacles.size();
    for (const svg::Subpath& subpath : subpaths) {
      std::vector<Vec2> points;
      for (const Vec2 p : subpath.points) {
        const Vec2 placed = level.transform.apply(p);
        if (!(std::abs(placed.x) <= largest_raw_coordinate && std::abs(placed.y) <= largest_raw_coordinate)) return refused({fmt::format("it reaches ({:g}, {:g})", placed.x, placed.y), "coordinates within 1e9 m"});
        if (points.empty() || points.back() != placed) points.push_back(placed);
      }
      points_ += points.size();
      if (points_ > most_points) return refused({fmt::format("it has over {} corners", most_points), fmt::format("at most {}", most_points)});
      if (points.size() < 2) continue;  // nothing to see
      if (level.is_filled && points.size() > 2) {
        if (!take_ring(std::move(points), first)) return false;
        continue;
      }
      if (subpath.is_closed && points.front() != points.back()) points.push_back(points.front());
      map_.lines.push_back(std::move(points));
    }
    return true;
  }

  bool take_ring(std::vector<Vec2> points, std::size_t first_of_element) {
    const Box box = bounding_box(points);
    const double near = closing * distance(box.low, box.high);
    while (points.size() > 3 && distance(points.back(), points.front()) <= near) points.pop_back();
    RingRepair repair = repair_ring(points);
    if (repair.refused) return refused({*repair.refused, "outlines that enclose an area and do not cross themselves; fill: none makes walls of them"});
    if (map_.obstacles.size() - first_of_element > most_in_one) return refused({fmt::format("the path has over {} outlines", most_in_one), "a path for each outline"});
    for (std::size_t i = first_of_element; i < map_.obstacles.size(); ++i) {
      const Ring& other = map_.obstacles[i];
      if (contains(other, repair.ring.front()) || contains(repair.ring, other.front())) return refused({"the path has an outline within another (a hole)", "outlines beside each other; fill: none makes walls of them"});
    }
    map_.obstacles.push_back(std::move(repair.ring));
    return true;
  }

  std::string name_;
  double scale_;
  XML_Parser parser_ = nullptr;
  std::optional<InputError> error_;
  std::vector<Level> levels_;
  std::string id_;
  std::size_t points_ = 0;
  std::map<std::string, int> left_out_;
  Map map_;
};

}  // namespace

Parsed<Map> decode_svg_map(const std::string& bytes, const std::string& name, double scale) {
  constexpr std::size_t largest = 64U << 20U;  // bytes
  if (bytes.size() > largest) return tl::unexpected{InputError{name, "", fmt::format("it has {} bytes", bytes.size()), fmt::format("at most {}", largest)}};
  return Drawing{name, scale}.read(bytes);
}

}  // namespace waywright
