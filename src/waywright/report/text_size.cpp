#include "waywright/report/text_size.hpp"

#include <array>
#include <cstdint>

namespace waywright {
namespace {

// Advance widths of ' ' to '~' in thousandths of the font size.
constexpr std::array<std::uint16_t, 95> plain{318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361, 318, 337, 636, 636, 636, 636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531,
                                              1000, 684, 686, 698, 770, 632, 575, 775, 752, 295, 295, 656, 557, 863, 748, 787, 603, 787, 695, 635, 611, 732, 684, 989, 685, 611, 685, 390, 337, 390, 838, 500,
                                              500, 613, 635, 550, 635, 615, 352, 635, 634, 278, 278, 579, 278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592, 525, 636, 337, 636, 838};
constexpr std::array<std::uint16_t, 95> bold{348, 456, 521, 838, 696, 1002, 872, 306, 457, 457, 523, 838, 380, 415, 380, 365, 696, 696, 696, 696, 696, 696, 696, 696, 696, 696, 400, 400, 838, 838, 838, 580,
                                             1000, 774, 762, 734, 830, 683, 683, 821, 837, 372, 372, 775, 637, 995, 837, 850, 733, 850, 770, 720, 682, 812, 774, 1103, 771, 724, 725, 457, 365, 457, 838, 500,
                                             500, 675, 716, 593, 716, 678, 435, 716, 712, 343, 343, 665, 343, 1042, 712, 687, 716, 716, 493, 595, 478, 712, 652, 924, 645, 652, 582, 712, 365, 712, 838};
constexpr double latin = 0.85, other = 1.0;  // of the font size: accented and Greek letters; all beyond

bool has_word(std::string_view classes, std::string_view word) {
  for (std::size_t at = classes.find(word); at != std::string_view::npos; at = classes.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || classes[at - 1] == ' ') && (end == classes.size() || classes[end] == ' ')) return true;
  }
  return false;
}

}  // namespace

double text_width(std::string_view text, double font_size, bool is_bold) {
  double ems = 0.0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f) ems += 1e-3 * (is_bold ? bold : plain)[byte - 0x20];
    else if (byte >= 0xe0) ems += other;  // begins a letter of three bytes or four
    else if (byte >= 0xc0) ems += latin;
    else if (byte < 0x20 || byte == 0x7f) ems += 1e-3 * plain['?' - ' '];
  }
  return ems * font_size;
}

TextStyle text_style(std::string_view style_class) {
  if (has_word(style_class, "tighttext")) return has_word(style_class, "note") ? TextStyle{12.0, true} : TextStyle{15.0, true};
  if (has_word(style_class, "name")) return {has_word(style_class, "note") ? 12.0 : 15.0, true};
  if (has_word(style_class, "meetingtext")) return {12.0, true};
  if (has_word(style_class, "number")) return {11.0, true, true};
  if (has_word(style_class, "badgetext")) return {12.0, true, true};
  if (has_word(style_class, "title")) return {13.0, true};
  if (has_word(style_class, "key")) return {14.0, false};
  return {12.0, false};
}

}  // namespace waywright
