#include "waywright/planner/field/field_drawings.hpp"

#include <algorithm>
#include <cmath>

#include "waywright/planner/field/field_picture_of.hpp"
#include "waywright/planner/plane/plane_space.hpp"

namespace waywright {
namespace {

using Critical = FieldPicture::Critical;
using Kind = Critical::Kind;

constexpr double at_goal = 1.5, at_trap = 3.0;  // cells: what is nearer is the same place
constexpr int images_across = 48, newton_steps = 60;
constexpr std::int64_t potential_work = 10'000'000, least_values = 256;  // edges in reach that are looked at for values
constexpr std::int64_t star_work = 6'000'000;   // corners of rims that are looked at for values

SharedDrawing drawing(FieldDrawing::Draw draw) { return std::make_shared<const FieldDrawing>(std::move(draw)); }

/// Those in the region that are not the goal; the trap takes the place of the minimum that it is.
void mark(FieldPicture& picture, std::vector<Critical> points, const Box& region, Vec2 goal, std::optional<Vec2> trap) {
  if (trap) {
    std::erase_if(points, [&](const Critical& c) { return c.kind == Kind::minimum && distance(c.at, *trap) < at_trap * picture.cell; });
    points.push_back({Kind::trap, *trap});
  }
  std::erase_if(points, [&](const Critical& c) { return !region.contains(c.at) || (c.kind != Kind::trap && distance(c.at, goal) < at_goal * picture.cell); });
  picture.critical = std::move(points);
}

/// On average of some places of the region.
std::int64_t edges_in_reach(const PlaneSpace& space, double reach, const Box& region) {
  constexpr int side = 5;
  const World& world = space.problem().world();
  if (world.index().empty()) return 0;
  std::int64_t edges = 0;
  for (int i = 0; i < side * side; ++i) {
    const Vec2 share{(i % side + 0.5) / side, (i / side + 0.5) / side}, size = region.high - region.low;
    world.index().visit(region.low + Vec2{share.x * size.x, share.y * size.y}, reach + space.disc() + space.problem().required_clearance(), [&](const Segment&) { ++edges; });
  }
  return edges / (side * side);
}

Kind kind_of(const SymmetricMatrix& m) { return m.determinant() < 0.0 ? Kind::saddle : m.xx > 0.0 ? Kind::minimum : Kind::maximum; }

}  // namespace

SharedDrawing potential_drawing(const PotentialOptions& options, Vec2 goal, std::optional<Vec2> trap) {
  return drawing([=](const Problem& problem, const Box& region) {
    const PlaneSpace space{problem};
    const PotentialField field{space, options, goal};
    // Value and slope are asked for at the same place one after another, and looking for edges is what costs.
    struct Asked {
      Vec2 at{};
      std::optional<PotentialField::Value> value;
    };
    std::vector<Asked> latest;
    std::size_t oldest = 0;
    const auto at = [&](Vec2 q) {
      for (const Asked& asked : latest) {
        if (asked.at == q) return asked.value;
      }
      Asked asked{q, field.at(q)};
      if (latest.size() < 4) return latest.emplace_back(asked).value;
      return (latest[oldest++ % 4] = asked).value;
    };
    FieldSeen seen;
    seen.name = "potential";
    seen.most_values = std::clamp(potential_work / (edges_in_reach(space, options.reach, region) + 1), least_values, seen.most_values);
    seen.value = [&](Vec2 q) -> std::optional<double> {
      const auto value = at(q);
      return value ? std::optional{value->potential} : std::nullopt;
    };
    const auto slope = [&](Vec2 q) -> std::optional<Vec2> {
      const auto value = at(q);
      return value ? std::optional{value->gradient} : std::nullopt;
    };
    seen.next = [&](Vec2 q, double step) { return place_down(seen, slope, q, step); };
    FieldPicture picture = field_picture(seen, region);
    mark(picture, where_slope_vanishes(picture, slope), region, goal, trap);
    return picture;
  });
}

SharedDrawing navigation_drawing(const SphereWorld& world, Vec2 goal, double kappa, std::optional<Vec2> trap) {
  return drawing([=](const Problem&, const Box& region) {
    const NavigationFunction function{world, goal, kappa};
    FieldSeen seen;
    seen.name = "navigation function";
    seen.value = [&](Vec2 q) { return function.is_free(q) && q != goal ? std::optional{function.logarithm(q)} : std::nullopt; };
    seen.next = [&](Vec2 q, double step) { return place_down(seen, [&](Vec2 p) { return function.is_free(p) ? std::optional{function.slope(p)} : std::nullopt; }, q, step); };
    FieldPicture picture = field_picture(seen, region);
    std::vector<Critical> points;
    for (const CriticalPoint& c : critical_points(function)) points.push_back({kind_of(function.curvature(c.at)), c.at});
    mark(picture, std::move(points), region, goal, trap);
    return picture;
  });
}

std::vector<Critical> critical_places(const StarNavigation& navigation, const StarWorld& world) {
  const StarMap& map = navigation.map();
  struct Image {
    Vec2 from{}, at{};
  };
  std::vector<Image> images;
  const double reach = world.outside.greatest_rim();
  for (int j = 0; j < images_across; ++j) {
    for (int i = 0; i < images_across; ++i) {
      const Vec2 q = world.outside.centre() + reach * Vec2{2.0 * (i + 0.5) / images_across - 1.0, 2.0 * (j + 0.5) / images_across - 1.0};
      if (map.is_free(q)) images.push_back({q, map.at(q).at});
    }
  }
  std::vector<Critical> found;
  for (const CriticalPoint& c : critical_points(navigation.function())) {
    // Newton's method for h(q) = c, from places whose images are nearest.
    std::sort(images.begin(), images.end(), [&](const Image& a, const Image& b) { return distance(a.at, c.at) < distance(b.at, c.at); });
    for (std::size_t start = 0; start < std::min<std::size_t>(8, images.size()); ++start) {
      Vec2 q = images[start].from;
      StarMap::Image image = map.at(q);
      double off = distance(image.at, c.at);
      for (int k = 0; k < newton_steps && off > 1e-10 * reach; ++k) {
        const Vec2 miss = c.at - image.at;
        const double det = image.determinant();
        if (det == 0.0 || !std::isfinite(det)) break;
        Vec2 step{(image.yy * miss.x - image.xy * miss.y) / det, (image.xx * miss.y - image.yx * miss.x) / det};
        bool is_nearer = false;
        for (int halves = 0; halves < 30 && !is_nearer; ++halves, step = 0.5 * step) {
          const Vec2 next = q + step;
          if (!map.is_free(next)) continue;
          const StarMap::Image there = map.at(next);
          const double left = distance(there.at, c.at);
          if (!(left < off)) continue;
          is_nearer = true;
          q = next;
          image = there;
          off = left;
        }
        if (!is_nearer) break;
      }
      if (off > 1e-8 * reach) continue;
      found.push_back({kind_of(navigation.function().curvature(c.at)), q});
      break;
    }
  }
  return found;
}

SharedDrawing star_drawing(const StarWorld& world, Vec2 goal, double lambda, double kappa, std::optional<Vec2> trap) {
  return drawing([=](const Problem& problem, const Box& region) {
    const StarNavigation navigation{world, goal, lambda, kappa};
    FieldSeen seen;
    seen.name = "navigation function, seen through the map from stars to discs";
    seen.value = [&](Vec2 q) { return navigation.map().is_free(q) && q != goal ? std::optional{navigation.function().logarithm(navigation.map().at(q).at)} : std::nullopt; };
    seen.next = [&](Vec2 q, double step) { return place_down(seen, [&](Vec2 p) { return navigation.map().is_free(p) ? std::optional{navigation.slope(p)} : std::nullopt; }, q, step); };
    std::size_t corners = 1;
    for (const auto* rings : {&problem.world().map().boundaries, &problem.world().map().obstacles}) {
      for (const Ring& ring : *rings) corners += ring.size();
    }
    seen.most_values = std::clamp<std::int64_t>(star_work / static_cast<std::int64_t>(corners), 2'500, seen.most_values);
    FieldPicture picture = field_picture(seen, region);
    mark(picture, critical_places(navigation, world), region, goal, trap);
    return picture;
  });
}

SharedDrawing tree_drawing(std::shared_ptr<const TreeMap> map, Vec2 goal, double kappa, std::optional<Vec2> trap) {
  return drawing([=](const Problem&, const Box& region) {
    const TreeNavigation navigation{*map, goal, kappa};
    FieldSeen seen;
    seen.name = "navigation function, seen through the map from trees of stars to discs";
    seen.value = [&](Vec2 q) { return map->is_free(q) && q != goal ? std::optional{navigation.function().logarithm(map->at(q).at)} : std::nullopt; };
    seen.next = [&](Vec2 q, double step) -> std::optional<Vec2> {
      const auto here = seen.value(q);
      if (!here) return std::nullopt;
      const Vec2 next = navigation.next(q, step);
      const auto there = seen.value(next);
      return there && *there < *here ? std::optional{next} : std::nullopt;
    };
    std::size_t corners = 1;
    for (const Ring& rim : map->rims()) corners += rim.size();
    seen.most_values = std::clamp<std::int64_t>(star_work / static_cast<std::int64_t>(corners), 2'500, seen.most_values);
    FieldPicture picture = field_picture(seen, region);
    std::vector<Critical> points;
    for (const CriticalPoint& c : critical_points(navigation.function())) points.push_back({kind_of(navigation.function().curvature(c.at)), map->back(c.at)});
    mark(picture, std::move(points), region, goal, trap);
    return picture;
  });
}

SharedDrawing wavefront_drawing(const GridFrame& frame, Wavefront front, Neighbours neighbours) {
  const auto shared = std::make_shared<const Wavefront>(std::move(front));
  return drawing([=](const Problem& problem, const Box& region) {
    const PlaneSpace space{problem};
    const auto value_of = [&](Cell c) -> std::uint32_t {
      return frame.contains(c) ? shared->values[static_cast<std::size_t>(c.row) * static_cast<std::size_t>(frame.columns) + static_cast<std::size_t>(c.column)] : 0U;
    };
    FieldSeen seen;
    seen.name = "moves to the goal";
    seen.value = [&](Vec2 q) -> std::optional<double> {
      const std::uint32_t own = value_of(frame.cell_at(q));
      if (own == 0 || !space.is_free(q)) return std::nullopt;
      // Between the four middles around it where all of them were reached, else that of its cell.
      const Vec2 in = frame.in_cells(q) - Vec2{0.5, 0.5};
      const double column = std::floor(in.x), row = std::floor(in.y), u = in.x - column, v = in.y - row;
      double sum = 0.0;
      for (const int dy : {0, 1}) {
        for (const int dx : {0, 1}) {
          const std::uint32_t corner = value_of({static_cast<int>(column) + dx, static_cast<int>(row) + dy});
          if (corner == 0) return own;
          sum += (dx == 1 ? u : 1.0 - u) * (dy == 1 ? v : 1.0 - v) * corner;
        }
      }
      return sum;
    };
    seen.next = [&](Vec2 q, double) -> std::optional<Vec2> {
      const Cell c = frame.cell_at(q);
      const std::uint32_t here = value_of(c);
      if (here <= Wavefront::goal_value) return std::nullopt;
      std::optional<Vec2> best;
      for (std::size_t i = 0; i < moves.size(); i += neighbours == Neighbours::four ? 4 : 2) {
        const Cell to{c.column + moves[i].column, c.row + moves[i].row};
        if (value_of(to) + 1 != here || !space.is_free(frame.centre(c), frame.centre(to))) continue;
        if (!best || space.at_least(frame.centre(to)) > space.at_least(*best)) best = frame.centre(to);
      }
      return best;
    };
    return field_picture(seen, region);
  });
}

SharedDrawing harmonic_drawing(std::shared_ptr<const HarmonicField> field) {
  return drawing([field = std::move(field)](const Problem& problem, const Box& region) {
    const PlaneSpace space{problem};
    const GridFrame& frame = field->frame();
    FieldSeen seen;
    seen.name = "harmonic potential";
    seen.value = [&](Vec2 q) -> std::optional<double> {
      if (!field->reaches(frame.cell_at(q)) || !space.is_free(q)) return std::nullopt;
      const double w = field->at(q).w;
      return w > 0.0 ? std::optional{-std::log(w)} : std::nullopt;
    };
    seen.next = [&](Vec2 q, double step) -> std::optional<Vec2> {
      if (auto next = place_down(seen, [&](Vec2 p) { return std::optional{-field->at(p).gradient}; }, q, step)) return next;
      const Cell c = frame.cell_at(q);
      std::optional<Cell> best;
      for (const Cell to : {Cell{c.column + 1, c.row}, Cell{c.column - 1, c.row}, Cell{c.column, c.row + 1}, Cell{c.column, c.row - 1}}) {
        if (frame.contains(c) && field->may_drive(c, to) && field->at(to) > field->at(best.value_or(c)) && field->at(to) > field->at(q).w) best = to;
      }
      return best ? std::optional{frame.centre(*best)} : std::nullopt;
    };
    FieldPicture picture = field_picture(seen, region);
    // Over a cell to each side, so that it is continuous, of the logarithm, so that it vanishes nowhere else.
    const auto slope = [&](Vec2 q) -> std::optional<Vec2> {
      const double h = frame.cell;
      const auto right = seen.value(q + Vec2{h, 0}), left = seen.value(q - Vec2{h, 0}), up = seen.value(q + Vec2{0, h}), down = seen.value(q - Vec2{0, h});
      return right && left && up && down ? std::optional{Vec2{*right - *left, *up - *down}} : std::nullopt;
    };
    std::vector<Critical> points = where_slope_vanishes(picture, slope);
    std::erase_if(points, [&](const Critical& c) { return c.kind != Kind::saddle; });  // by the field's law there are no minima; what differences make of the goal is none
    picture.critical = std::move(points);
    return picture;
  });
}

}  // namespace waywright
