#include "waywright/planner/field/star_trees.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>

#include "waywright/geometry/convex_partition.hpp"
#include "waywright/planner/field/star.hpp"

namespace waywright {
namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
constexpr double widest_collar = 1.0, least_collar = 1e-4;
constexpr double collar_share = 0.75;      // of the way to what is next
constexpr double on_hull = 1e-12;        // of the size of all
constexpr double least_kernel = 1e-3;      // of a star's area: a smaller one is next to none
constexpr double fat_kernel = 0.1;         // the same, of pieces that are put together: long arms are better drawn in than stretched
// Of the free angle at an end of the cut, from the leaf on: the first few do nearly always.
constexpr double shares[] = {0.5, 0.25, 0.75, 0.12, 0.9, 0.04, 0.97, 0.01, 0.99};
constexpr std::size_t usual_shares = 4;

struct Candidate {
  LeafPurge purge;
  double shear = 0.0;
};

struct PieceCut {
  Vec2 a{}, b{};          ///< an edge of the piece's ring
  std::size_t to = none;  ///< the piece beyond; none: what is outside the hull
};
struct Piece {
  Ring ring;
  std::vector<PieceCut> cuts;
  bool is_gone = false, is_root = false;
  std::optional<Candidate> how;  ///< to draw it in, once it is a leaf: what else is drawn in makes only more room for it
};
/// One obstacle, or all that is outside. `rim` has what is blocked on its left.
struct Tree {
  Ring rim;
  std::vector<Piece> pieces;
};

/// The places where the rim comes to `at`; more than one where it touches itself.
std::optional<std::size_t> only_place(const Ring& rim, Vec2 at) {
  const auto found = std::find(rim.begin(), rim.end(), at);
  if (found == rim.end() || std::find(found + 1, rim.end(), at) != rim.end()) return std::nullopt;
  return static_cast<std::size_t>(found - rim.begin());
}

bool add_pieces(Tree& tree, const Ring& ring, bool is_pocket, const std::function<bool()>& stops) {
  const auto partition = convex_partition(ring, stops);
  if (!partition) return false;
  const std::size_t first = tree.pieces.size();
  for (const auto& corners : partition->parts) {
    Piece piece;
    for (const std::size_t i : corners) piece.ring.push_back(ring[i]);
    // A pocket begins with its lid.
    for (std::size_t k = 0; is_pocket && k < corners.size(); ++k) {
      if (corners[k] == 0 && corners[(k + 1) % corners.size()] == 1) piece.cuts.push_back({ring[0], ring[1], none});
    }
    tree.pieces.push_back(std::move(piece));
  }
  for (const ConvexPartition::Cut& cut : partition->cuts) {
    tree.pieces[first + cut.left].cuts.push_back({ring[cut.a], ring[cut.b], first + cut.right});
    tree.pieces[first + cut.right].cuts.push_back({ring[cut.b], ring[cut.a], first + cut.left});
  }
  return true;
}

bool is_star(const Ring& ring, double least = least_kernel) {
  const Ring kernel = places_that_see_all(ring);
  return kernel.size() >= 3 && signed_area(kernel) > least * signed_area(ring);
}

/// Both rings as one, without the edge that they have in common: from a to b in the first.
Ring merged(const Ring& first, const Ring& second, Vec2 a, Vec2 b) {
  const auto from = [](Ring ring, Vec2 at) {
    std::rotate(ring.begin(), std::find(ring.begin(), ring.end(), at), ring.end());
    return ring;
  };
  Ring ring = from(first, b);          // b … a
  const Ring other = from(second, a);  // a … b
  ring.insert(ring.end(), other.begin() + 1, other.end() - 1);
  return ring;
}

/// A star of pieces around one of them, as many as there can be: in the order of their numbers.
std::vector<bool> star_about(const std::vector<Piece>& pieces, std::size_t root) {
  std::vector<bool> in(pieces.size(), false);
  in[root] = true;
  Ring ring = pieces[root].ring;
  for (bool is_grown = true; is_grown;) {
    is_grown = false;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (!in[i]) continue;
      for (const PieceCut& cut : pieces[i].cuts) {
        if (cut.to == none || in[cut.to]) continue;
        Ring wider = merged(ring, pieces[cut.to].ring, cut.a, cut.b);
        if (!is_star(wider, fat_kernel)) continue;
        ring = std::move(wider);
        in[cut.to] = is_grown = true;
      }
    }
  }
  return in;
}

/// How deep the tree is below a star.
std::size_t depth_below(const std::vector<Piece>& pieces, std::vector<bool> in) {
  for (std::size_t depth = 0;; ++depth) {
    std::vector<bool> next = in;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      for (const PieceCut& cut : pieces[i].cuts) {
        if (in[i] && cut.to != none) next[cut.to] = true;
      }
    }
    if (next == in) return depth;
    in = std::move(next);
  }
}

/// Of all stars of pieces the one that leaves the shallowest tree, and of those the fewest leaves.
void choose_root(std::vector<Piece>& pieces, const std::function<bool()>& stops) {
  std::vector<bool> best;
  std::pair<std::size_t, std::size_t> least{none, none};
  std::vector<bool> tried(pieces.size(), false);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (tried[i] || (!best.empty() && stops && stops())) continue;
    std::vector<bool> star = star_about(pieces, i);
    const auto outside = static_cast<std::size_t>(std::count(star.begin(), star.end(), false));
    const std::pair how{depth_below(pieces, star), outside};
    for (std::size_t k = 0; k < star.size(); ++k) tried[k] = tried[k] || star[k];
    if (how < least) {
      least = how;
      best = std::move(star);
    }
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) pieces[i].is_root = best[i];
}

/// The cut of a piece that nothing else hangs on any more; empty where it is none.
std::optional<PieceCut> cut_of_leaf(const Tree& tree, const Piece& piece) {
  if (piece.is_gone || piece.is_root) return std::nullopt;
  std::optional<PieceCut> only;
  for (const PieceCut& cut : piece.cuts) {
    if (cut.to != none && tree.pieces[cut.to].is_gone) continue;
    if (only) return std::nullopt;
    only = cut;
  }
  return only;
}

double cotangent(double angle) { return sin_cos(angle).cos / sin_cos(angle).sin; }

/// The best way to draw in a leaf, among all that is on the rims.
std::optional<Candidate> drawn_in(const std::vector<Tree>& trees, const Tree& tree, const Piece& piece, const PieceCut& cut) {
  Ring leaf = piece.ring;
  std::rotate(leaf.begin(), std::find(leaf.begin(), leaf.end(), cut.a), leaf.end());
  if (leaf.size() < 3 || !(leaf[1] == cut.b)) return std::nullopt;
  const auto at_a = only_place(tree.rim, cut.a), at_b = only_place(tree.rim, cut.b);
  if (!at_a || !at_b) return std::nullopt;
  const std::size_t n = tree.rim.size();
  const Vec2 after = tree.rim[(*at_a + 1) % n], before = tree.rim[(*at_b + n - 1) % n];
  const Vec2 along = cut.b - cut.a;
  const auto angle = [&](Vec2 way) { return arc_tangent(cross(along, way), dot(along, way)); };
  // The free angle at each end of the cut, as far as it is on the leaf's side: from the leaf's edge to the rim's next.
  const double leaf_a = angle(leaf.back() - cut.a), leaf_b = angle(leaf[2] - cut.b);
  const double end_a = cross(along, after - cut.a) > 0.0 ? angle(after - cut.a) : pi, end_b = cross(along, before - cut.b) > 0.0 ? angle(before - cut.b) : 0.0;
  if (!(leaf_a > 0.0 && leaf_a < end_a && end_b < leaf_b)) return std::nullopt;
  std::optional<Candidate> best;
  const auto look = [&](double share_a, double share_b) {
    auto purge = LeafPurge::of(leaf, cotangent(leaf_a + share_a * (end_a - leaf_a)), cotangent(leaf_b - share_b * (leaf_b - end_b)));
    if (!purge) return;
    double nearest = purge->reach();
    for (const Tree& other : trees) {
      for (std::size_t i = 0; i < other.rim.size() && nearest > 1.0 + least_collar; ++i) {
        if (&other == &tree && (i + n - *at_b) % n < (*at_a + n - *at_b) % n) continue;  // the leaf's own
        nearest = std::min(nearest, purge->nearest(other.rim[i], other.rim[(i + 1) % other.rim.size()]));
      }
    }
    const double collar = std::min(widest_collar, collar_share * (nearest - 1.0));
    if (collar < least_collar) return;
    purge->set_collar(collar);
    const double shear = purge->shear();
    if (!best || best->shear > shear) best = Candidate{std::move(*purge), shear};
  };
  for (const bool is_usual : {true, false}) {
    for (std::size_t a = 0; a < std::size(shares); ++a) {
      for (std::size_t b = 0; b < std::size(shares); ++b) {
        if ((a < usual_shares && b < usual_shares) == is_usual) look(shares[a], shares[b]);
      }
    }
    if (best) break;
  }
  return best;
}

/// The outside of a hull around the boundary, with the pockets between both. The hull's corners are the boundary's, those on its edges too.
std::optional<Tree> outside_of(const Ring& boundary, const std::function<bool()>& stops) {
  Tree tree;
  tree.rim.assign(boundary.rbegin(), boundary.rend());
  const Ring hull = convex_hull(boundary);
  const Box box = bounding_box(hull);
  const double hair = on_hull * distance(box.low, box.high);
  const auto is_on_hull = [&](Vec2 p) {
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const Vec2 along = hull[(i + 1) % hull.size()] - hull[i];
      if (cross(along, p - hull[i]) <= hair * norm(along)) return true;
    }
    return false;
  };
  const std::size_t n = boundary.size();
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < n; ++i) {
    if (is_on_hull(boundary[i])) corners.push_back(i);
  }
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::size_t at = corners[k], to = corners[(k + 1) % corners.size()];
    if ((at + 1) % n == to) continue;
    Ring pocket{boundary[at]};
    for (std::size_t i = to; i != at; i = (i + n - 1) % n) pocket.push_back(boundary[i]);
    if (!add_pieces(tree, pocket, true, stops)) return std::nullopt;
  }
  return tree;
}

}  // namespace

tl::expected<StarTrees, std::string> star_trees(const Ring& outside, const std::vector<Ring>& obstacles, const std::function<bool()>& stops) {
  using tl::unexpected;
  const std::string uncut = "could not be cut into convex pieces: it touches itself, or rounding is in the way";
  std::vector<Tree> trees;
  StarTrees made;
  for (const Ring& ring : obstacles) {
    Tree tree{ring, {}};
    if (!is_star(ring)) {
      if (!add_pieces(tree, ring, false, stops)) return unexpected{fmt::format("the obstacle at ({:.3f}, {:.3f}) {}", ring.front().x, ring.front().y, uncut)};
      choose_root(tree.pieces, stops);
    }
    made.pieces += std::max<std::size_t>(1, tree.pieces.size());
    trees.push_back(std::move(tree));
  }
  if (is_star(outside)) {
    trees.push_back({Ring{outside.rbegin(), outside.rend()}, {}});
  } else {
    auto tree = outside_of(outside, stops);
    if (!tree) return unexpected{"the boundary " + uncut};
    made.pieces += tree->pieces.size();
    trees.push_back(std::move(*tree));
  }
  for (;;) {
    struct Found {
      Tree* tree = nullptr;
      Piece* piece = nullptr;
      PieceCut cut;
    };
    std::optional<Found> best;
    std::optional<Vec2> stuck;
    for (Tree& tree : trees) {
      for (Piece& piece : tree.pieces) {
        const auto cut = cut_of_leaf(tree, piece);
        if (!cut) continue;
        if (stops && stops()) return unexpected<std::string>{"not all leaves were drawn in"};
        if (!piece.how) piece.how = drawn_in(trees, tree, piece, *cut);
        if (!piece.how) stuck = 0.5 * (cut->a + cut->b);
        else if (!best || piece.how->shear < best->piece->how->shear) best = Found{&tree, &piece, *cut};
      }
    }
    if (!best) {
      if (stuck) return unexpected{fmt::format("the piece beyond the cut at ({:.3f}, {:.3f}) cannot be drawn in: what is next to it is too near", stuck->x, stuck->y)};
      break;
    }
    Ring& rim = best->tree->rim;
    std::rotate(rim.begin(), std::find(rim.begin(), rim.end(), best->cut.b), rim.end());
    rim.erase(rim.begin() + 1, std::find(rim.begin(), rim.end(), best->cut.a));
    best->piece->is_gone = true;
    made.purges.push_back(std::move(best->piece->how->purge));
  }
  made.outside.assign(trees.back().rim.rbegin(), trees.back().rim.rend());
  trees.pop_back();
  for (Tree& tree : trees) made.stars.push_back(std::move(tree.rim));
  return made;
}

}  // namespace waywright
