#include "waywright/dxf/floor_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "waywright/core/spelling.hpp"
#include "waywright/dxf/chains.hpp"
#include "waywright/dxf/drawing.hpp"
#include "waywright/dxf/expand.hpp"
#include "waywright/dxf/layers.hpp"
#include "waywright/dxf/outline.hpp"

namespace waywright::dxf {
namespace {

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
  if (!options.unit.empty()) return tl::unexpected{InputError{name, "unit", fmt::format("\"{}\" is not known{}", one_line(options.unit), meant_instead(options.unit, {"mm", "cm", "m", "in", "ft"})), unit_names}};
  const Vec2 size = drawing.box.high - drawing.box.low;
  const std::string why = drawing.unit == 0 ? "the drawing names no unit ($INSUNITS)" : fmt::format("the drawing's unit ($INSUNITS {}) is not one of floor plans", drawing.unit);
  return tl::unexpected{InputError{name, "", fmt::format("{}; it is about {:.0f} x {:.0f} units: give unit (--unit)", why, size.x, size.y), unit_names}};
}

/// "1 line", "2 lines".
std::string count_of(double n, const char* one, const char* more) { return fmt::format("{:.0f} {}", n, n == 1.0 ? one : more); }
std::string count_of(std::size_t n, const char* one, const char* more) { return count_of(static_cast<double>(n), one, more); }

std::string millimetres(double v) { return v < 0.01 ? fmt::format("{:.2g} mm", 1e3 * v) : fmt::format("{:.0f} mm", 1e3 * v); }

std::string metres(double v) { return v < 1000.0 ? fmt::format("{:.3g} m", v) : fmt::format("{:.3g} km", v / 1000.0); }

/// A unit out of the header is believed where it gives the size of a hall: drawings often name one and are drawn in another.
std::optional<InputError> check_size(const std::vector<Box>& boxes, const Unit& unit, const std::string& name) {
  Box box{};
  bool any = false;
  for (const Box& b : boxes) {
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
    // A spline's piece has its hull within half of the tolerance of its chord, so that both are within the whole of each other.
    auto clean = cleaned(text, name_, drawing_, 0.5 * options_.tolerance / unit.metres);
    if (!clean) return clean.error();
    if (!clean->text.empty()) {
      std::optional<InputError> error;
      auto expanded = expand(clean->text, name_, [&](Piece&& piece) {
        error = take(std::move(piece), unit, clean->curves);
        return !error;
      });
      if (!expanded) return expanded.error();
      if (error) return error;
    }
    if (options_.unit.empty() && !pieces_.empty()) {
      std::vector<Box> boxes;
      for (const Taken& taken : pieces_) boxes.push_back(bounding_box(taken.piece.points));
      return check_size(boxes, unit, name_);
    }
    return std::nullopt;
  }

  Parsed<FloorPlan> finish(const Unit& unit) {
    if (pieces_.empty()) {
      return tl::unexpected{InputError{name_, "", "there is nothing to take in it" + (left_.empty() ? std::string{} : "; left out: " + counted(left_, drawing_)),
                                       "lines, polylines, arcs, circles, ellipses or splines in model space, on layers that are taken"}};
    }
    note_taken(unit);
    find_outline();
    std::vector<Chain> boundary_lines;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      Taken& taken = pieces_[i];
      const bool boundary = roles_[taken.piece.layer] == Role::boundary;
      const bool closed = is_closed(taken);
      if (boundary && !closed) boundary_lines.push_back(taken.curve.empty() ? chain_of(taken.piece.points) : std::move(taken.curve));
      else if (closed && i == outline_) add_walls(std::move(taken.piece.points));
      else if (closed) add_ring(std::move(taken), boundary, i == room_);
      else add_line(std::move(taken.piece.points));
    }
    join_boundary(std::move(boundary_lines));
    note_repairs();
    if (auto error = check_boundaries()) return tl::unexpected{*error};
    return std::move(plan_);
  }

 private:
  /// What came of GDAL, and of a curve what it is, too.
  struct Taken {
    Piece piece;  ///< its points: in m, of a curve chords with their corners on it
    Chain curve;  ///< empty: straight
  };

  std::optional<InputError> take(Piece&& piece, const Unit& unit, const std::vector<std::vector<double>>& curves) {
    const Role role = roles_[piece.layer];
    if (role != Role::obstacle && role != Role::boundary) {
      ++(role == Role::off ? off_ : role == Role::frozen ? frozen_ : left_)[{piece.kind, piece.layer}];
      return std::nullopt;
    }
    for (Vec2& p : piece.points) {
      p = unit.metres * p;
      if (!is_finite(p)) return InputError{name_, "", fmt::format("a {} on layer {} reaches a point that is not finite once its block is inserted", piece.kind, drawing_.layers[piece.layer].name), "numbers of a floor plan's size"};
    }
    Chain curve;
    const bool is_a_place = std::all_of(piece.points.begin(), piece.points.end(), [&](Vec2 p) { return p == piece.points.front(); });
    if (piece.curve && !is_a_place) {
      const std::size_t index = *piece.curve;
      if (index >= curves.size() || curves[index].size() != piece.points.size()) {
        return InputError{name_, "", fmt::format("GDAL changed the number of points of a {} on layer {}", piece.kind, drawing_.layers[piece.layer].name), "a drawing that CAD programs open"};
      }
      for (std::size_t i = 0; i < piece.points.size(); ++i) curve.push_back({piece.points[i], curves[index][i]});
      auto on_curve = chords_of(curve, false, Side::on, options_.tolerance, most_points);
      if (!on_curve) return too_many_points();
      piece.points = std::move(*on_curve);
    }
    piece.points.erase(std::unique(piece.points.begin(), piece.points.end()), piece.points.end());
    if (piece.points.size() < 2 && curve.empty()) return ++empty_, std::nullopt;
    points_ += piece.points.size() + curve.size();
    if (points_ > most_points) return too_many_points();
    by_fit_points_ += piece.by_fit_points ? 1 : 0;
    ++taken_[{piece.kind, piece.layer}];
    pieces_.push_back({std::move(piece), std::move(curve)});
    return std::nullopt;
  }

  InputError too_many_points() const {
    return InputError{name_, "", fmt::format("it needs more than {} points", most_points), "fewer entities, named by obstacle_layers, or a coarser tolerance"};
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
    if (std::any_of(pieces_.begin(), pieces_.end(), [](const Taken& t) { return !t.curve.empty(); })) {
      note(fmt::format("curves are taken as chords no farther than {} from them: solids contain their outline, a boundary lies within its own, lines may lie on either side", millimetres(options_.tolerance)));
    }
  }

  /// Closed as it is, or nearly.
  bool is_closed(Taken& taken) {
    Piece& piece = taken.piece;
    if (std::max(piece.points.size(), taken.curve.size()) < 3) return false;
    const double gap = distance(piece.points.front(), piece.points.back());
    if (gap == 0.0) {
      if (piece.points.size() > 1) piece.points.pop_back();
      if (!taken.curve.empty()) taken.curve.pop_back();
      return std::max(piece.points.size(), taken.curve.size()) > 2;
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
      const Piece& piece = pieces_[i].piece;
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
    const auto inside = [&](Vec2 p) { return contains(pieces_[outline_].piece.points, p); };
    // Of very many pieces in an outline of very many corners, some stand for all.
    const std::size_t stride = 1 + pieces_.size() * pieces_[outline_].piece.points.size() / most_comparisons;
    for (std::size_t i = 0; i < pieces_.size(); i += stride) {
      if (i == outline_) continue;
      ++others;
      within += inside(0.5 * (boxes[i].low + boxes[i].high)) && inside(pieces_[i].piece.points.front()) ? 1 : 0;
    }
    const std::string& layer = drawing_.layers[pieces_[outline_].piece.layer].name;
    const bool is_about_most = static_cast<double>(within) >= outline_share * static_cast<double>(others);
    if (within < least_within_outline || !is_about_most) {
      if (is_about_most && options_.boundary_layer.empty() && largest >= least_room) {
        const std::string rest = others == 0 ? "and there is nothing else" : within == others ? "with everything else inside" : fmt::format("with {} of the {} others inside", within, others);
        room_ = outline_;
        room_note_ = fmt::format("the largest closed {} ({:.1f} m², on {}) is taken as solid, {}: if it is the outline of a room, name its layer as boundary_layer", pieces_[outline_].piece.kind, largest, layer, rest);
      }
      outline_ = none;
      return;
    }
    // Where others are closed on its layer, too, they would be boundaries beside each other, which is refused.
    const auto closed_there = std::count_if(pieces_.begin(), pieces_.end(), [&](const Taken& other) {
      return other.piece.layer == pieces_[outline_].piece.layer && distance(other.piece.points.front(), other.piece.points.back()) <= options_.closing;
    });
    note(fmt::format("the largest closed {} ({:.1f} m², on {}) is about most of the rest: taken as walls, not as solid ({})", pieces_[outline_].piece.kind, largest, layer,
                     closed_there > 1 ? "on a layer of its own, boundary_layer would make it the boundary" : "boundary_layer makes it the boundary"));
  }

  void add_walls(Polyline ring) {
    if (ring.empty()) return;
    ring.push_back(ring.front());
    add_line(std::move(ring));
  }

  void add_line(Polyline line) {
    if (line.size() > 1) plan_.lines.push_back(std::move(line));
  }

  void add_ring(Taken taken, bool boundary, bool may_be_room) {
    Polyline points = std::move(taken.piece.points);
    if (taken.piece.kind == "SOLID" || taken.piece.kind == "TRACE") mend_bow_tie(points);
    RingRepair repair = taken.curve.empty() ? repair_ring(points) : ring_beside(taken.curve, boundary);
    if (repair.refused) {
      if (refused_ == 0) first_refused_ = fmt::format("a {} on {}, {}", taken.piece.kind, drawing_.layers[taken.piece.layer].name, *repair.refused);
      ++refused_;
      return add_walls(std::move(points));
    }
    duplicates_ += std::any_of(repair.mended.begin(), repair.mended.end(), [](const std::string& m) { return m.find("duplicate") != m.npos; }) ? 1 : 0;
    (boundary ? plan_.boundaries : plan_.obstacles).push_back(std::move(repair.ring));
    if (may_be_room) note(room_note_);
  }

  /// A ring that contains what a closed curve encloses; of a boundary, one that lies within it. Where the chords of both sides of something narrow
  /// cross, or lie beyond each other altogether, finer ones do not. Where even these do, as in a notch without width, a solid becomes its hull; a curve that crosses itself is refused.
  RingRepair ring_beside(const Chain& curve, bool boundary) {
    const bool counter_clockwise = signed_area(curve) > 0.0;
    const Side outer = counter_clockwise ? Side::right : Side::left, inner = outer == Side::right ? Side::left : Side::right;
    RingRepair repair;
    double tolerance = options_.tolerance;
    for (int finer = 0; finer < 3; ++finer, tolerance *= 0.125) {
      auto ring = chords_of(curve, true, boundary ? inner : outer, tolerance, most_points);
      if (!ring) {
        if (finer == 0) repair.refused = fmt::format("it needs more than {} corners", most_points);
        break;
      }
      const bool turns_alike = (signed_area(*ring) > 0.0) == counter_clockwise;
      repair = repair_ring(std::move(*ring));
      if (!repair.refused && !turns_alike) repair.refused = "it is too narrow for the tolerance";
      if (!repair.refused) return repair;
    }
    if (boundary) return repair;
    const auto on_curve = chords_of(curve, true, Side::on, tolerance, most_points), around = chords_of(curve, true, outer, options_.tolerance, most_points);
    if (!on_curve || !around || repair_ring(*on_curve).refused) return repair;
    RingRepair hull = repair_ring(convex_hull(*around));
    if (hull.refused) return repair;
    ++hulls_;
    return hull;
  }

  /// Corners of a solid are stored in the order of a Z; whichever way they come, the hull of its four is meant.
  static void mend_bow_tie(Polyline& corners) {
    if (corners.size() == 4) corners = convex_hull(corners);
  }

  void join_boundary(std::vector<Chain> lines) {
    if (lines.empty()) return;
    const std::size_t given = lines.size();
    Joined found = joined(std::move(lines), options_.closing);
    const auto on_curve = [&](const Chain& chain, bool closed) { return chords_of(chain, closed, Side::on, options_.tolerance, most_points).value_or(Polyline{}); };
    for (const Chain& chain : found.closed) {
      RingRepair repair = ring_beside(chain, true);
      if (repair.refused) {
        if (refused_ == 0) first_refused_ = "lines of the boundary layer, " + *repair.refused;
        ++refused_;
        add_walls(on_curve(chain, true));
      } else {
        plan_.boundaries.push_back(std::move(repair.ring));
      }
    }
    if (!found.closed.empty()) {
      const std::string gaps = found.widest_gap > 1e-6 ? fmt::format(" (gaps up to {})", millimetres(found.widest_gap)) : "";
      note(fmt::format("{} of the boundary layer {} joined to {}{}", count_of(given, "line", "lines"), given == 1 ? "was" : "were", count_of(found.closed.size(), "ring", "rings"), gaps));
    }
    if (!found.open.empty()) note(count_of(found.open.size(), "open line of the boundary layer closes no ring: taken as a wall", "open lines of the boundary layer close no ring: taken as walls"));
    for (const Chain& open : found.open) add_line(on_curve(open, false));
  }

  void note_repairs() {
    if (closed_ > 0) note(fmt::format("repaired: {} up to {} apart {} closed", count_of(closed_, "polyline whose ends are", "polylines whose ends are"), millimetres(widest_gap_), closed_ == 1 ? "was" : "were"));
    if (duplicates_ > 0) note("repaired: duplicate corners removed from " + count_of(duplicates_, "closed outline", "closed outlines"));
    if (hulls_ > 0) note(count_of(hulls_, "solid with a notch too narrow to be drawn was taken as its convex hull", "solids with notches too narrow to be drawn were taken as their convex hulls"));
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
  std::vector<Taken> pieces_;
  Counts taken_, left_, off_, frozen_;
  FloorPlan plan_;
  std::size_t outline_ = none, room_ = none;  // of the pieces: taken as walls; solid, though it may be a room's outline
  std::string room_note_;
  std::size_t points_ = 0;
  std::size_t empty_ = 0, by_fit_points_ = 0, closed_ = 0, refused_ = 0, duplicates_ = 0, hulls_ = 0;
  double widest_gap_ = 0.0;
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
