#include "waywright/dxf/floor_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "waywright/dxf/chains.hpp"
#include "waywright/dxf/drawing.hpp"
#include "waywright/dxf/expand.hpp"
#include "waywright/dxf/layers.hpp"

namespace waywright::dxf {
namespace {

constexpr double least_step = 0.01, most_step = 15.0;      // degrees of one chord: 0.01 serves up to 130 km within 1 mm
constexpr double class_width = 16.0;                       // of radii that are read with one step: four times the points that it takes, at most
constexpr std::size_t most_raw_points = 100'000'000;     // as GDAL gives them
constexpr std::size_t most_points = 4'000'000;             // of the whole plan; a map holds half as many edges
constexpr double least_size = 2.0, most_size = 1000.0;     // m, of a floor plan whose unit nobody has given
constexpr double outline_share = 0.5;                      // of the other pieces, that an outline of the plan is about
constexpr std::size_t least_within_outline = 4;
constexpr std::size_t most_comparisons = 500'000'000;    // of pieces with corners of the outline
constexpr double least_room = 4.0;                         // m²: what is smaller is no room for a vehicle

struct Unit {
  const char* name;   // as options have it
  const char* words;  // in a sentence
  double metres;
  int insunits;  // the header's number for it
};
constexpr std::array units{Unit{"mm", "mm", 1e-3, 4}, Unit{"cm", "cm", 1e-2, 5}, Unit{"m", "m", 1.0, 6}, Unit{"in", "inches", 0.0254, 1}, Unit{"ft", "feet", 0.3048, 2}};
constexpr const char* unit_names = "mm, cm, m, in, ft";

Parsed<Unit> unit_of(const Drawing& drawing, const std::string& name, const Options& options) {
  for (const Unit& unit : units) {
    if (options.unit.empty() ? unit.insunits == drawing.unit : unit.name == options.unit) return unit;
  }
  if (!options.unit.empty()) return tl::unexpected{InputError{name, "unit", fmt::format("\"{}\" is not known", one_line(options.unit)), "mm, cm, m, in, ft"}};
  const Vec2 size = drawing.box.high - drawing.box.low;
  const std::string why = drawing.unit == 0 ? "the drawing names no unit ($INSUNITS)" : fmt::format("the drawing's unit ($INSUNITS {}) is not one of floor plans", drawing.unit);
  return tl::unexpected{InputError{name, "", fmt::format("{}; it is about {:.0f} x {:.0f} units: give unit (--unit)", why, size.x, size.y), unit_names}};
}

/// "1 line", "2 lines".
std::string count_of(double n, const char* one, const char* more) { return fmt::format("{:.0f} {}", n, n == 1.0 ? one : more); }
std::string count_of(std::size_t n, const char* one, const char* more) { return count_of(static_cast<double>(n), one, more); }

std::string metres(double v) { return v < 1000.0 ? fmt::format("{:.3g} m", v) : fmt::format("{:.3g} km", v / 1000.0); }

/// A unit out of the header is believed where it gives the size of a hall: drawings often name one and are drawn in another.
std::optional<InputError> check_size(const std::vector<Piece>& pieces, const Unit& unit, const std::string& name) {
  Box box{};
  bool any = false;
  for (const Piece& piece : pieces) {
    const Box b = bounding_box(piece.points);
    box = any ? Box{{std::min(box.low.x, b.low.x), std::min(box.low.y, b.low.y)}, {std::max(box.high.x, b.high.x), std::max(box.high.y, b.high.y)}} : b;
    any = true;
  }
  const Vec2 size = box.high - box.low;
  const double longest = std::max(size.x, size.y);
  if (longest >= least_size && longest <= most_size) return std::nullopt;
  std::string others;
  for (const Unit& other : units) {
    const double k = other.metres / unit.metres;
    if (other.insunits != unit.insunits && k * longest >= least_size && k * longest <= most_size) {
      others += fmt::format("{}{} in {}", others.empty() ? "; it would be " : ", ", metres(k * size.x), other.words);
    }
  }
  return InputError{name, "", fmt::format("this hall would be {} wide and {} deep in the unit that the drawing names, {}{}: give unit (--unit)", metres(size.x), metres(size.y), unit.words, others),
                    unit_names};
}

class Plan {
 public:
  Plan(const Drawing& drawing, const std::string& name, const Options& options, std::vector<Role> roles)
      : drawing_{drawing}, name_{name}, options_{options}, roles_{std::move(roles)} {}

  std::optional<InputError> read(std::string_view text, const Unit& unit) {
    // Half of the tolerance for what GDAL makes of arcs, half for leaving out points of it. GDAL has one step for all arcs, so that the
    // largest would make far too many points of the small ones: they are read by classes of radius.
    const double tolerance = 0.5 * options_.tolerance / unit.metres;
    deviation_ = options_.tolerance;
    for (double radius = drawing_.largest_radius; !last_class_;) {
      const double step = step_for(radius, tolerance);
      last_class_ = step >= most_step || radius == 0.0;
      const double next = radius / class_width;
      const std::size_t before = raw_points_;
      if (auto error = read_class(text, unit, tolerance, step, last_class_ ? -1.0 : next, radius)) return error;
      if (step <= least_step && raw_points_ > before) deviation_ = std::max(deviation_, (tolerance + radius * (1.0 - std::cos(0.5 * step * pi / 180.0))) * unit.metres);
      radius = next;
    }
    if (options_.unit.empty() && !pieces_.empty()) return check_size(pieces_, unit, name_);
    return std::nullopt;
  }

  Parsed<FloorPlan> finish(const Unit& unit) {
    if (pieces_.empty()) {
      return tl::unexpected{InputError{name_, "", "there is nothing to take in it" + (left_.empty() ? std::string{} : "; left out: " + counted(left_, drawing_)),
                                       "lines, polylines, arcs, circles, ellipses or splines in model space, on layers that are taken"}};
    }
    note_taken(unit);
    find_outline();
    std::vector<Polyline> boundary_lines;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      Piece& piece = pieces_[i];
      const bool boundary = roles_[piece.layer] == Role::boundary;
      const bool closed = is_closed(piece);
      if (boundary && !closed) boundary_lines.push_back(std::move(piece.points));
      else if (closed && i == outline_) add_walls(std::move(piece.points));
      else if (closed) add_ring(std::move(piece), boundary, i == room_);
      else plan_.lines.push_back(std::move(piece.points));
    }
    join_boundary(std::move(boundary_lines));
    note_repairs();
    if (auto error = check_boundaries()) return tl::unexpected{*error};
    return std::move(plan_);
  }

 private:
  static double step_for(double radius, double tolerance) {
    const double needed = radius > tolerance ? 2.0 * std::acos(1.0 - tolerance / radius) * 180.0 / pi : most_step;
    return std::clamp(needed, least_step, most_step);
  }

  std::optional<InputError> read_class(std::string_view text, const Unit& unit, double tolerance, double step, double above, double up_to) {
    auto clean = cleaned(text, name_, drawing_, tolerance, above, up_to);
    if (!clean) return clean.error();
    if (clean->empty()) return std::nullopt;
    std::optional<InputError> error;
    auto expanded = expand(*clean, name_, step, [&](Piece&& piece) {
      error = take(std::move(piece), unit);
      return !error;
    });
    return expanded ? error : expanded.error();
  }

  std::optional<InputError> take(Piece&& piece, const Unit& unit) {
    raw_points_ += piece.points.size();
    const Role role = roles_[piece.layer];
    if (role != Role::obstacle && role != Role::boundary) {
      ++(role == Role::off ? off_ : role == Role::frozen ? frozen_ : left_)[{piece.kind, piece.layer}];
      return std::nullopt;
    }
    for (Vec2& p : piece.points) {
      p = unit.metres * p;
      if (!is_finite(p)) return InputError{name_, "", fmt::format("a {} on layer {} reaches a point that is not finite once its block is inserted", piece.kind, drawing_.layers[piece.layer].name), "numbers of a floor plan's size"};
    }
    if (piece.curved || piece.kind == "SPLINE") piece.points = simplified(piece.points, 0.5 * options_.tolerance);
    piece.points.erase(std::unique(piece.points.begin(), piece.points.end()), piece.points.end());
    if (piece.points.size() < 2) return ++empty_, std::nullopt;
    points_ += piece.points.size();
    if (points_ > most_points || raw_points_ > most_raw_points) return InputError{name_, "", fmt::format("it needs more than {} points", most_points), "fewer entities, named by obstacle_layers, or a coarser tolerance"};
    by_fit_points_ += piece.by_fit_points ? 1 : 0;
    ++taken_[{piece.kind, piece.layer}];
    pieces_.push_back(std::move(piece));
    return std::nullopt;
  }

  void note(std::string text) { plan_.notes.push_back(std::filesystem::path{name_}.filename().string() + ": " + std::move(text)); }

  void note_taken(const Unit& unit) {
    note(fmt::format("in {}{}; taken: {}", unit.words, options_.unit.empty() ? " as the drawing says" : "", counted(taken_, drawing_)));
    if (!left_.empty()) note((options_.obstacle_layers.empty() ? "left out, layers of annotations: " : "left out, layers that are not named: ") + counted(left_, drawing_));
    Counts writing, unread;
    for (const auto& [key, count] : drawing_.left_out) (is_annotation_kind(key.first) ? writing : unread)[key] = count;
    if (!writing.empty()) note("left out, writing and the like: " + counted(writing, drawing_));
    if (!unread.empty()) note("left out, though it may stand for walls: " + counted(unread, drawing_) + ": explode in CAD what does");
    if (!frozen_.empty()) note("left out, frozen layers: " + counted(frozen_, drawing_));
    if (!off_.empty()) note("left out, layers that are off: " + counted(off_, drawing_));
    const auto some = [&](double count, const char* one, const char* more) {
      if (count > 0.0) note("left out: " + count_of(count, one, more));
    };
    some(drawing_.on_frozen_inserts, "inserted block on a frozen layer", "inserted blocks on frozen layers");
    some(drawing_.in_paper_space, "entity of paper space", "entities of paper space");
    some(drawing_.invisible, "invisible entity", "invisible entities");
    some(drawing_.external_blocks, "reference to another drawing (xref), which is not in this file: bind it in CAD", "references to other drawings (xref), which are not in this file: bind them in CAD");
    some(drawing_.missing_blocks, "inserted block that the drawing does not define", "inserted blocks that the drawing does not define");
    some(static_cast<double>(empty_), "entity without length", "entities without length");
    if (by_fit_points_ > 0) {
      note(count_of(by_fit_points_, "spline is given by its fit points alone, which were joined by straight lines: look at it", "splines are given by fit points alone, which were joined by straight lines: look at them"));
    }
    if (std::any_of(pieces_.begin(), pieces_.end(), [](const Piece& p) { return p.curved || p.kind == "SPLINE"; })) {
      note(fmt::format("curves are drawn by chords no farther than {:.2g} mm from them", 1e3 * deviation_));
    }
  }

  /// Closed as it is, or nearly.
  bool is_closed(Piece& piece) {
    if (piece.points.size() < 3) return false;
    const double gap = distance(piece.points.front(), piece.points.back());
    if (gap == 0.0) {
      piece.points.pop_back();
      return piece.points.size() > 2;
    }
    if (piece.kind == "SOLID" || piece.kind == "TRACE") return true;
    const Box box = bounding_box(piece.points);
    // What is small itself is not closed by a gap of its own size.
    if (gap > options_.closing || gap > 0.1 * norm(box.high - box.low)) return false;
    if (gap > 1e-6) {
      ++closed_;
      widest_gap_ = std::max(widest_gap_, gap);
    }
    return true;
  }

  /// The largest closed piece, where most of the others lie within it.
  void find_outline() {
    double largest = 0.0;
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const Piece& piece = pieces_[i];
      boxes.push_back(bounding_box(piece.points));
      const double gap = distance(piece.points.front(), piece.points.back());
      if (roles_[piece.layer] != Role::obstacle || piece.points.size() < 4 || gap > options_.closing) continue;
      const double area = std::abs(signed_area(piece.points));
      if (area > largest) {
        largest = area;
        outline_ = i;
      }
    }
    if (outline_ == none) return;
    std::size_t within = 0, others = 0;
    const auto inside = [&](Vec2 p) { return contains(pieces_[outline_].points, p); };
    // Of very many pieces in an outline of very many corners, some stand for all.
    const std::size_t stride = 1 + pieces_.size() * pieces_[outline_].points.size() / most_comparisons;
    for (std::size_t i = 0; i < pieces_.size(); i += stride) {
      if (i == outline_) continue;
      ++others;
      within += inside(0.5 * (boxes[i].low + boxes[i].high)) && inside(pieces_[i].points.front()) ? 1 : 0;
    }
    const std::string& layer = drawing_.layers[pieces_[outline_].layer].name;
    const bool is_about_most = static_cast<double>(within) >= outline_share * static_cast<double>(others);
    if (within < least_within_outline || !is_about_most) {
      if (is_about_most && options_.boundary_layer.empty() && largest >= least_room) {
        const std::string rest = others == 0 ? "and there is nothing else" : within == others ? "with everything else inside" : fmt::format("with {} of the {} others inside", within, others);
        room_ = outline_;
        room_note_ = fmt::format("the largest closed {} ({:.1f} m², on {}) is taken as solid, {}: if it is the outline of a room, name its layer as boundary_layer", pieces_[outline_].kind, largest, layer, rest);
      }
      outline_ = none;
      return;
    }
    note(fmt::format("the largest closed {} ({:.1f} m², on {}) is about most of the rest: taken as walls, not as solid (boundary_layer makes it the boundary)", pieces_[outline_].kind, largest, layer));
  }

  void add_walls(Polyline ring) {
    ring.push_back(ring.front());
    plan_.lines.push_back(std::move(ring));
  }

  void add_ring(Piece piece, bool boundary, bool may_be_room) {
    Polyline points = std::move(piece.points);
    if (piece.kind == "SOLID" || piece.kind == "TRACE") mend_bow_tie(points);
    RingRepair repair = repair_ring(points);
    if (repair.refused) {
      if (refused_ == 0) first_refused_ = fmt::format("a {} on {}, {}", piece.kind, drawing_.layers[piece.layer].name, *repair.refused);
      ++refused_;
      return add_walls(std::move(points));
    }
    duplicates_ += std::any_of(repair.mended.begin(), repair.mended.end(), [](const std::string& m) { return m.find("duplicate") != m.npos; }) ? 1 : 0;
    (boundary ? plan_.boundaries : plan_.obstacles).push_back(std::move(repair.ring));
    if (may_be_room) note(room_note_);
  }

  /// Corners of a solid are stored in the order of a Z; whichever way they come, the hull of its four is meant.
  static void mend_bow_tie(Polyline& corners) {
    if (corners.size() == 4) corners = convex_hull(corners);
  }

  void join_boundary(std::vector<Polyline> lines) {
    if (lines.empty()) return;
    const std::size_t given = lines.size();
    Joined found = joined(std::move(lines), options_.closing);
    for (Polyline& ring : found.closed) {
      RingRepair repair = repair_ring(ring);
      if (repair.refused) {
        if (refused_ == 0) first_refused_ = "lines of the boundary layer, " + *repair.refused;
        ++refused_;
        add_walls(std::move(ring));
      } else {
        plan_.boundaries.push_back(std::move(repair.ring));
      }
    }
    if (!found.closed.empty()) {
      const std::string gaps = found.widest_gap > 1e-6 ? fmt::format(" (gaps up to {:.2g} mm)", 1e3 * found.widest_gap) : "";
      note(fmt::format("{} of the boundary layer {} joined to {}{}", count_of(given, "line", "lines"), given == 1 ? "was" : "were", count_of(found.closed.size(), "ring", "rings"), gaps));
    }
    if (!found.open.empty()) note(count_of(found.open.size(), "open line of the boundary layer closes no ring: taken as a wall", "open lines of the boundary layer close no ring: taken as walls"));
    for (Polyline& open : found.open) plan_.lines.push_back(std::move(open));
  }

  void note_repairs() {
    if (closed_ > 0) note(fmt::format("repaired: {} up to {:.2g} mm apart {} closed", count_of(closed_, "polyline whose ends are", "polylines whose ends are"), 1e3 * widest_gap_, closed_ == 1 ? "was" : "were"));
    if (duplicates_ > 0) note("repaired: duplicate corners removed from " + count_of(duplicates_, "closed outline", "closed outlines"));
    if (refused_ == 1) note(fmt::format("repaired: a closed outline that encloses nothing clearly was taken as walls ({})", first_refused_));
    if (refused_ > 1) note(fmt::format("repaired: {} closed outlines that enclose nothing clearly were taken as walls (first: {})", refused_, first_refused_));
  }

  std::optional<InputError> check_boundaries() {
    if (options_.boundary_layer.empty()) return std::nullopt;
    const auto& rings = plan_.boundaries;
    if (rings.empty()) {
      const std::string why = refused_ > 0 ? fmt::format(" that encloses something clearly: {}", first_refused_) : "";
      return InputError{name_, "boundary_layer", fmt::format("layer {} holds no closed ring{}", one_line(options_.boundary_layer), why),
                        "a layer with a closed polyline, or lines that meet (their ends within the closing distance)"};
    }
    for (std::size_t i = 0; i < rings.size(); ++i) {
      for (std::size_t k = i + 1; k < rings.size(); ++k) {
        const Box a = bounding_box(rings[i]), b = bounding_box(rings[k]);
        if (a.high.x > b.low.x && b.high.x > a.low.x && a.high.y > b.low.y && b.high.y > a.low.y) continue;
        return InputError{name_, "boundary_layer", fmt::format("two of the {} rings on layer {} lie beside each other, and the vehicle stays inside of all", rings.size(), one_line(options_.boundary_layer)),
                          "one ring, or rings within each other"};
      }
    }
    if (rings.size() > 1) {
      double least = std::abs(signed_area(rings[0])), most = least;
      for (const Ring& ring : rings) {
        least = std::min(least, std::abs(signed_area(ring)));
        most = std::max(most, std::abs(signed_area(ring)));
      }
      note(fmt::format("the boundary layer holds {} rings of {:.1f} to {:.1f} m² within each other; the vehicle stays inside each of them, so the smallest decides: what is a pillar or an island "
                       "belongs on a layer of obstacles", rings.size(), least, most));
    }
    return std::nullopt;
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  const Drawing& drawing_;
  const std::string& name_;
  const Options& options_;
  std::vector<Role> roles_;
  std::vector<Piece> pieces_;
  Counts taken_, left_, off_, frozen_;
  FloorPlan plan_;
  std::size_t outline_ = none, room_ = none;  // of the pieces: taken as walls; solid, though it may be a room's outline
  std::string room_note_;
  bool last_class_ = false;
  std::size_t points_ = 0, raw_points_ = 0;
  std::size_t empty_ = 0, by_fit_points_ = 0, closed_ = 0, refused_ = 0, duplicates_ = 0;
  double widest_gap_ = 0.0, deviation_ = 0.0;
  std::string first_refused_;
};

}  // namespace

std::optional<double> metres_of(std::string_view name) {
  for (const Unit& unit : units) {
    if (unit.name == name) return unit.metres;
  }
  return std::nullopt;
}

Parsed<FloorPlan> read_floor_plan(std::string_view text, const std::string& name, const Options& options) {
  auto drawing = scan(text, name);
  if (!drawing) return tl::unexpected{drawing.error()};
  auto roles = roles_of(*drawing, name, options);
  if (!roles) return tl::unexpected{roles.error()};
  auto unit = unit_of(*drawing, name, options);
  if (!unit) return tl::unexpected{unit.error()};
  Plan plan{*drawing, name, options, std::move(*roles)};
  if (auto error = plan.read(text, *unit)) return tl::unexpected{*error};
  return plan.finish(*unit);
}

}  // namespace waywright::dxf
