// What is written in a picture: collected while it is drawn, then placed so that no text stands on another or beyond the picture's edge.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "waywright/report/label_room.hpp"
#include "waywright/report/svg_writer.hpp"

namespace waywright {

struct Label {
  std::string text;
  std::string style_class;  ///< one that text_style knows
  std::string below = {};   ///< a second, smaller line; may be empty
};

/// What is looked for first comes first: it has the better place.
enum class LabelRank { end, tightest, spot, number, thing, turn, other, zone, tick };

class Labels {
 public:
  /// All texts stay within the frame (px, y down).
  Labels(const View& view, const Box& frame) : view_{view}, frame_{frame} {}

  /// What texts keep off: lines and outlines as well as they can, boxes (texts that stand already) always.
  LabelRoom& room() { return room_; }
  void keep_off(const std::vector<Vec2>& line, bool is_closed);  ///< world

  static constexpr double anywhere = std::numeric_limits<double>::infinity();
  struct Wish {
    Label label;
    LabelRank rank = LabelRank::other;
    std::vector<Vec2> middles = {};  ///< world: the text's middle may lie at one of these, the first that is free; tried before any place beside the point
    double most_hidden = anywhere;   ///< of lines, at such a middle
    Vec2 point{};                    ///< world: what it names, beside which it stands
    Vec2 away{0.0, 1.0};             ///< px, y down: on which side, if that is free
    double gap = 12.0;               ///< px from the point
    double farthest = anywhere;      ///< px farther than the gap that it may stand, with a line to the point; under 0: not beside it
    double heed = 1.0;               ///< what a line that it stands on weighs: under 1 nearness to the point matters more
  };
  void add(Wish wish) { wishes_.push_back(std::move(wish)); }

  /// Places and writes what was collected, by rank and in the order of its coming. Returns how many found no free place and are left out.
  std::size_t write(SvgWriter& svg);

 private:
  struct Place {
    double x = 0.0, y = 0.0;  ///< of the first base line
    enum class Anchor { begin, middle, end } anchor = Anchor::begin;
    Box box{};
    bool is_far = false;
  };
  struct Size {
    double wide = 0.0, above = 0.0, below = 0.0;  ///< px, of the first base line
  };
  Size size_of(const Label& label) const;
  bool is_free(const Box& box) const;
  bool in_middle(const Wish& wish, const Size& size, Place& place) const;
  bool beside(const Wish& wish, const Size& size, Place& place) const;

  View view_;
  Box frame_;
  LabelRoom room_;
  std::vector<Wish> wishes_;
};

}  // namespace waywright
