#include "waywright/report/labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/report/text_size.hpp"

namespace waywright {
namespace {

constexpr double line_height = 14.4;  // px, of a second line: 1.2 of its 12
constexpr double seam = 1.5;          // px around a text that stay free
constexpr double narrow_page = 2.6;   // on one letters are so much larger: near the right edge they grow to the left

}  // namespace

void Labels::keep_off(const std::vector<Vec2>& line, bool is_closed) {
  std::vector<Vec2> pixels;
  for (const Vec2 p : line) pixels.push_back(view_(p));
  if (is_closed && !pixels.empty()) pixels.push_back(pixels.front());
  room_.take_line(pixels);
}

Labels::Size Labels::size_of(const Label& label) const {
  const TextStyle style = text_style(label.style_class), second = text_style(label.style_class + " note");
  Size size{text_width(label.text, style.size, style.is_bold), 0.78 * style.size, 0.24 * style.size};
  if (!label.below.empty()) {
    size.wide = std::max(size.wide, text_width(label.below, second.size, second.is_bold));
    size.below = line_height + 0.24 * second.size;
  }
  return size;
}

bool Labels::is_free(const Box& box) const {
  if (box.low.x < frame_.low.x || box.low.y < frame_.low.y || box.high.x > frame_.high.x || box.high.y > frame_.high.y) return false;
  return !room_.is_written_on(box);
}

bool Labels::in_middle(const Wish& wish, const Size& size, Place& place) const {
  const Vec2 half{0.5 * size.wide + seam, 0.5 * (size.above + size.below) + seam};
  for (const Vec2 point : wish.middles) {
    Vec2 at = view_(point);
    if (at.x < frame_.low.x || at.x > frame_.high.x || at.y < frame_.low.y || at.y > frame_.high.y) continue;
    at.x = std::clamp(at.x, frame_.low.x + half.x, std::max(frame_.low.x + half.x, frame_.high.x - half.x));
    at.y = std::clamp(at.y, frame_.low.y + half.y, std::max(frame_.low.y + half.y, frame_.high.y - half.y));
    const Box box{at - half, at + half};
    if (!is_free(box) || room_.hidden_by(box) > wish.most_hidden) continue;
    place = {at.x, at.y - half.y + seam + size.above, Place::Anchor::middle, box, false};
    return true;
  }
  return false;
}

bool Labels::beside(const Wish& wish, const Size& size, Place& place) const {
  constexpr double turned = 0.25, farther = 0.6 / 14.0;  // of a hidden point each, for an eighth of a turn and for a pixel: what is nearer to the side that was asked for is better
  if (wish.farthest < 0.0) return false;
  const Vec2 at = view_(wish.point);
  if (!std::isfinite(at.x + at.y)) return false;
  const double length = norm(wish.away), asked = length > 0.0 ? angle_of(wish.away) : 0.5 * pi;
  const double most = std::min(wish.farthest, norm(frame_.high - frame_.low));
  const double high = size.above + size.below;
  double least = std::numeric_limits<double>::infinity();
  for (double off = 0.0; off <= most && farther * off < least; off += off < 40.0 ? 14.0 : 0.4 * off) {
    const int turns = off < 40.0 ? 8 : 16;
    for (int i = 0; i < turns; ++i) {
      const int k = i % 2 == 1 ? (i + 1) / 2 : -i / 2;  // 0, 1, -1, 2 …
      const Vec2 d = unit(asked + k * two_pi / turns);
      const double cost = turned * std::abs(k) * 8.0 / turns + farther * off;
      if (cost >= least) continue;
      // The box touches a disc about the point.
      const double reach = wish.gap + off;
      const Vec2 low{at.x + reach * d.x - (d.x < -0.3 ? size.wide : d.x < 0.3 ? 0.5 * size.wide : 0.0), at.y + reach * d.y - (d.y < -0.3 ? high : d.y < 0.3 ? 0.5 * high : 0.0)};
      Box box{low - Vec2{seam, seam}, low + Vec2{size.wide + seam, high + seam}};
      if (off == 0.0 && std::abs(d.y) > 0.3) {  // above or below, it may lie farther to one side where the edge is near
        const double shift = std::max(0.0, frame_.low.x - box.low.x) - std::max(0.0, box.high.x - frame_.high.x);
        box.low.x += shift;
        box.high.x += shift;
      }
      if (!is_free(box)) continue;
      const double hides = cost + wish.heed * room_.hidden_by(box);
      if (hides >= least) continue;
      least = hides;
      place = {box.low.x + seam, box.low.y + seam + size.above, Place::Anchor::begin, box, off > 0.0};
    }
  }
  if (!std::isfinite(least)) return false;
  if (place.x + narrow_page * size.wide > frame_.high.x) {
    place.x += size.wide;
    place.anchor = Place::Anchor::end;
  }
  return true;
}

std::size_t Labels::write(SvgWriter& svg) {
  std::stable_sort(wishes_.begin(), wishes_.end(), [](const Wish& a, const Wish& b) { return a.rank < b.rank; });
  std::string leaders, texts;
  std::size_t left_out = 0;
  for (const Wish& wish : wishes_) {
    if (wish.label.text.empty()) continue;
    const Size size = size_of(wish.label);
    Place place;
    if (!in_middle(wish, size, place) && !beside(wish, size, place)) {
      ++left_out;
      continue;
    }
    room_.take(place.box);
    if (place.is_far) {  // which place it names is not seen otherwise
      const Vec2 at = view_(wish.point), end{std::clamp(at.x, place.box.low.x, place.box.high.x), std::clamp(at.y, place.box.low.y, place.box.high.y)};
      leaders += fmt::format("<line class=\"leader\" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>\n", fixed(at.x), fixed(at.y), fixed(end.x), fixed(end.y));
      room_.take_line({at, end});
    }
    if (text_style(wish.label.style_class).is_centred) {
      place.x = 0.5 * (place.box.low.x + place.box.high.x);
      place.anchor = Place::Anchor::begin;
    }
    const std::string style = wish.label.style_class + (place.anchor == Place::Anchor::end ? " end" : place.anchor == Place::Anchor::middle ? " middle" : "");
    texts += fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n", style, fixed(place.x), fixed(place.y), escaped(wish.label.text));
    if (!wish.label.below.empty()) {
      texts += fmt::format("<text class=\"{} note{}\" x=\"{}\" y=\"{}\" dy=\"1.2em\">{}</text>\n", wish.label.style_class, style.substr(wish.label.style_class.size()), fixed(place.x), fixed(place.y),
                           escaped(wish.label.below));
    }
  }
  svg.raw(leaders + texts);
  wishes_.clear();
  return left_out;
}

}  // namespace waywright
