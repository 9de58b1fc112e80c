// How much room a text takes in a picture.
#pragma once

#include <string_view>

namespace waywright {

/// px, of UTF-8 text: as set in DejaVu Sans, the widest of the fonts that pictures name; other letters than ASCII's as wide as most of them come out at most.
double text_width(std::string_view text, double font_size, bool is_bold);

/// Of the classes that pictures write with ("note", "name end" …): font size in px; is it bold, and does the class itself put the text's middle at its place?
struct TextStyle {
  double size = 12.0;
  bool is_bold = false;
  bool is_centred = false;
};
TextStyle text_style(std::string_view style_class);

}  // namespace waywright
