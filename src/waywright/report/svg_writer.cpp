#include "waywright/report/svg_writer.hpp"

#include <fmt/format.h>

#include <cmath>

namespace waywright {

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' ? '?' : c;
    }
  }
  return out;
}

std::string fixed(double value, int digits) {
  if (!std::isfinite(value)) return "0";
  std::string text = fmt::format("{:.{}f}", value, digits);
  if (text.find('.') != std::string::npos) {
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

void SvgWriter::open_group(std::string_view style_class, std::string_view extra) {
  out_ += fmt::format("<g class=\"{}\"{}{}>\n", style_class, extra.empty() ? "" : " ", extra);
}
void SvgWriter::close_group() { out_ += "</g>\n"; }

std::string SvgWriter::points(const std::vector<Vec2>& ring) const {
  std::string text;
  for (const Vec2 p : ring) {
    const Vec2 q = view_(p);
    text += (text.empty() ? "" : " ") + fixed(q.x) + "," + fixed(q.y);
  }
  return text;
}

void SvgWriter::polygon(const std::vector<Vec2>& ring, std::string_view style_class) {
  if (ring.size() == 1) return;
  out_ += fmt::format("<polygon class=\"{}\" points=\"{}\"/>\n", style_class, points(ring));
}

void SvgWriter::stroked_polyline(const std::vector<Vec2>& line, std::string_view attributes, double width) {
  out_ += fmt::format("<polyline fill=\"none\" {} stroke-width=\"{:g}\" points=\"{}\"/>\n", attributes, width, points(line));
}

void SvgWriter::polyline(const std::vector<Vec2>& line, std::string_view style_class) {
  out_ += fmt::format("<polyline class=\"{}\" points=\"{}\"/>\n", style_class, points(line));
}

void SvgWriter::line(Vec2 a, Vec2 b, std::string_view style_class) {
  const Vec2 p = view_(a);
  const Vec2 q = view_(b);
  out_ += fmt::format("<line class=\"{}\" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>\n", style_class,
                      fixed(p.x), fixed(p.y), fixed(q.x), fixed(q.y));
}

void SvgWriter::dot(Vec2 p, double pixels, std::string_view style_class) {
  const Vec2 q = view_(p);
  out_ += fmt::format("<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", style_class, fixed(q.x),
                      fixed(q.y), fixed(pixels));
}

void SvgWriter::square(Vec2 middle, double pixels, std::string_view style_class) {
  const Vec2 q = view_(middle) - Vec2{0.5 * pixels, 0.5 * pixels};
  out_ += fmt::format("<rect class=\"{0}\" x=\"{1}\" y=\"{2}\" width=\"{3}\" height=\"{3}\"/>\n", style_class,
                      fixed(q.x), fixed(q.y), fixed(pixels));
}

void SvgWriter::union_of(const std::vector<std::vector<Vec2>>& rings, std::string_view style_class) {
  if (rings.empty()) return;
  out_ += fmt::format("<path class=\"{}\" d=\"", style_class);
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 q = view_(ring[i]);
      out_ += fmt::format("{}{} {}", i == 0 ? "M" : "L", fixed(q.x, 1), fixed(q.y, 1));
    }
    out_ += "Z";
  }
  out_ += "\"/>\n";
}

void SvgWriter::label(Vec2 p, Vec2 offset, std::string_view text, std::string_view style_class) {
  const Vec2 q = view_(p) + offset;
  out_ += fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n", style_class, fixed(q.x), fixed(q.y),
                      escaped(text));
}

namespace {

struct Colour {
  const char* name;
  const char* light;
  const char* dark;
};
// Okabe and Ito's palette for what must be told apart; greys for the rest.
constexpr Colour colours[] = {
    {"ink", "#1b1f24", "#e8ecf0"},  {"soft", "#5b6570", "#a7b1bb"},    {"paper", "#fff", "#14181d"},
    {"grid", "#e3e7eb", "#2a3138"}, {"wall", "#39424c", "#b9c3cd"},    {"solid", "#9aa5b1", "#5b6671"},
    {"cell", "#59636e", "#8f9aa6"}, {"unknown", "#c9d0d7", "#343c45"}, {"fwd", "#0072b2", "#56b4e9"},
    {"back", "#d55e00", "#f0a04b"}, {"zone", "#009e73", "#2fc79b"},    {"shelf", "#cc79a7", "#d99bbd"},
    {"dear", "#e69f00", "#e0a83a"}, {"slow", "#8a7300", "#e8d44d"},
    {"field", "#54398f", "#c0aef0"}, {"bad", "#b00020", "#ff8a8a"},  {"alt", "#7a828a", "#8b949d"},
};

constexpr std::string_view rules = R"(
.ww .paper{fill:var(--paper)}.ww text{font-family:system-ui,-apple-system,"DejaVu Sans",sans-serif;fill:var(--ink)}
.ww .boundary{fill:none;stroke:var(--wall);stroke-width:2}.ww .area{fill:none;stroke:var(--wall);stroke-width:1.5;stroke-dasharray:7 4}
.ww .obstacle{fill:var(--solid);stroke:var(--wall);stroke-width:1}.ww .wall{fill:none;stroke:var(--wall);stroke-width:2}
.ww .point{fill:var(--wall)}.ww .cell{fill:var(--cell)}.ww .unknown{fill:var(--unknown)}
.ww .placed{fill:var(--fwd);fill-opacity:.2;stroke:var(--fwd);stroke-width:1.4}.ww .placedline{fill:none;stroke:var(--fwd);stroke-width:1.4}.ww .placedbound{fill:none;stroke:var(--zone);stroke-width:2;stroke-dasharray:9 4}
.ww .shelf{fill:var(--shelf);fill-opacity:.45;stroke:var(--shelf);stroke-width:1.5}.ww .face{stroke:var(--shelf);stroke-width:5}.ww .pocket{fill:var(--paper);stroke:var(--shelf);stroke-width:1;stroke-dasharray:3 2}
.ww .zone{fill:var(--zone);fill-opacity:.10;stroke:var(--zone);stroke-width:1;stroke-dasharray:3 3}
.ww .zoneforbidden{fill:url(#zonehatch);stroke:var(--bad);stroke-width:1.5}.ww .zonehatchline{fill:var(--bad);fill-opacity:.35}
.ww .zonedirected{fill:var(--soft);fill-opacity:.10;stroke:var(--soft);stroke-width:1}.ww .zonearrow{stroke:var(--soft);stroke-width:2}.ww .zonearrowhead{fill:var(--soft)}
.ww .zonepreferred{fill:var(--zone);fill-opacity:.14;stroke:var(--zone);stroke-width:1}.ww .zonepenalty{fill:var(--dear);fill-opacity:.20;stroke:var(--dear);stroke-width:1}
.ww .zonespeed{fill:var(--slow);fill-opacity:.10;stroke:var(--slow);stroke-width:1.5;stroke-dasharray:8 3}
.ww .sweep{fill:var(--fwd);fill-opacity:.14;stroke:none}.ww .ghost{fill:none;stroke:var(--soft);stroke-width:.6;stroke-opacity:.55}
.ww .vehicle{fill:var(--paper);fill-opacity:.5;stroke:var(--ink);stroke-width:1.6}.ww .heading{stroke:var(--ink);stroke-width:1.6;fill:none}
.ww .spinmark .vehicle{fill:none;stroke:var(--soft);stroke-width:.9}.ww .spinmark .heading{stroke:var(--soft);stroke-width:.9}
.ww .fwd{fill:none;stroke:var(--fwd);stroke-width:3}.ww .back{fill:none;stroke:var(--back);stroke-width:3}
.ww .turn{fill:none;stroke:var(--shelf);stroke-width:4}.ww .fwdmark{fill:var(--fwd)}.ww .backmark{fill:var(--back)}
.ww .alt{fill:none;stroke:var(--alt);stroke-width:1.6;stroke-dasharray:6 4}.ww .tight{stroke:var(--bad);stroke-width:2.5}
.ww .waypoint{fill:var(--paper,#fff);stroke:var(--ink,#222);stroke-width:1.8}.ww .waypointring{fill:none;stroke:var(--ink,#222);stroke-width:.8;stroke-dasharray:3 3}
.ww .searchline{fill:none;stroke:var(--zone);stroke-width:.7;stroke-opacity:.55}.ww .searchplace{fill:none;stroke:var(--dear);stroke-width:3.4;stroke-linecap:round}.ww .searchagent{fill:none;stroke:var(--dear);stroke-width:1.2}
.ww .fieldbar{fill:url(#fieldbar);stroke:var(--field);stroke-width:.6}.ww .contour{fill:none;stroke:var(--field);stroke-width:1;stroke-opacity:.7}.ww .stream{fill:none;stroke:var(--ink);stroke-width:.8;stroke-opacity:.55}.ww .streamhead{fill:var(--ink);fill-opacity:.6}
.ww .leader{stroke:var(--soft);stroke-width:.8}
.ww .markhalo{fill:none;stroke:var(--paper);stroke-width:5;stroke-linejoin:round;stroke-linecap:round}.ww .saddle{fill:none;stroke:var(--ink);stroke-width:2.2;stroke-linecap:round}.ww .minimum{fill:var(--dear);stroke:var(--ink);stroke-width:1.6;stroke-linejoin:round}
.ww .maximum{fill:var(--paper);stroke:var(--ink);stroke-width:1.6;stroke-linejoin:round}.ww .trapmark{fill:none;stroke:var(--bad);stroke-width:2.4;stroke-linecap:round}.ww .casing{fill:none;stroke:var(--paper);stroke-width:6.5;stroke-opacity:.85;stroke-linejoin:round}.ww .onfield .sweep{fill-opacity:.3}.ww .onfield .alt{stroke:var(--fwd);stroke-width:2.4}
.ww .tightdot{fill:var(--bad)}.ww .hit{fill:var(--bad);fill-opacity:.14;stroke:var(--bad);stroke-width:1.4}
.ww .spot{fill:var(--paper);stroke:var(--bad);stroke-width:2}.ww .spotline{stroke:var(--bad);stroke-width:1.2;stroke-dasharray:4 3}
.ww .load{fill:var(--back);fill-opacity:.13;stroke:var(--back);stroke-width:.9;stroke-dasharray:4 2}.ww .setdown{fill:var(--solid);fill-opacity:.75;stroke:var(--back);stroke-width:2}
.ww .driven{fill:none;stroke:var(--soft);stroke-width:3;stroke-opacity:.6}.ww .appeared{fill:var(--bad);fill-opacity:.30;stroke:var(--bad);stroke-width:1.6}.ww .appearedline{fill:none;stroke:var(--bad);stroke-width:2.4}.ww .appeareddot{fill:var(--bad)}
.ww .moving{fill:var(--dear);fill-opacity:.55;stroke:var(--dear);stroke-width:1.8}.ww .movinglater{fill:var(--dear);fill-opacity:.10;stroke:var(--dear);stroke-width:1.4;stroke-dasharray:4 3}.ww .movingway{fill:none;stroke:var(--dear);stroke-width:1.8;stroke-dasharray:2 4}
.ww .movingtick{stroke:var(--dear);stroke-width:2}.ww .waytick{stroke:var(--ink);stroke-width:1.6}.ww .meeting{fill:var(--field);fill-opacity:.14;stroke:var(--field);stroke-width:1.3}.ww .meetingline{stroke:var(--field);stroke-width:1.6}.ww .meetingdot{fill:var(--field)}
.ww .lane{fill:none;stroke:var(--soft);stroke-width:1.1;stroke-opacity:.75}.ww .lanehead{fill:var(--soft)}
.ww .wait{fill:var(--dear);stroke:var(--ink);stroke-width:1.8}
.ww .region{fill:var(--zone);fill-opacity:.14;stroke:var(--zone);stroke-width:1.6}
.ww .badge{fill:var(--paper);stroke-width:3px}.ww .badgetext{font-size:12px;font-weight:700;text-anchor:middle}
.ww .stop{fill:var(--paper);stroke:var(--ink);stroke-width:1.8}.ww .frame{fill:none;stroke:var(--grid);stroke-width:1}
.ww .number{font-size:11px;font-weight:600;text-anchor:middle}
.ww .tighttext{fill:var(--bad);font-size:15px;font-weight:700;paint-order:stroke;stroke:var(--paper);stroke-width:4px}
.ww .name{font-size:15px;font-weight:700;paint-order:stroke;stroke:var(--paper);stroke-width:4px}
.ww .meetingtext{font-size:12px;font-weight:600;paint-order:stroke;stroke:var(--paper);stroke-width:3px;fill:var(--field)}
.ww .bandside{fill:var(--zone);fill-opacity:.13}
.ww .tighttext.note{fill:var(--bad);font-size:12px}.ww .small{font-size:12px;fill:var(--soft)}.ww .key{font-size:14px}.ww .note{font-size:12px;paint-order:stroke;stroke:var(--paper);stroke-width:3px;fill:var(--soft)}
.ww .bar{stroke:var(--ink);stroke-width:2}.ww .axis{stroke:var(--soft);stroke-width:1}.ww .gridline{stroke:var(--grid);stroke-width:1}
.ww .curve{fill:none;stroke:var(--ink);stroke-width:1.8}.ww .limit{stroke:var(--bad);stroke-width:1.4;stroke-dasharray:6 4}
.ww .bandback{fill:var(--back);fill-opacity:.09}.ww .bandfwd{fill:var(--fwd);fill-opacity:.09}
.ww .change{stroke:var(--soft);stroke-width:1.2;stroke-dasharray:2 3}.ww .spin{stroke:var(--shelf);stroke-width:2}.ww .ceiling{fill:none;stroke:var(--bad);stroke-width:2}.ww .title{font-size:13px;font-weight:600}.ww .end{text-anchor:end}
.ww .middle{text-anchor:middle}
)";

/// The rules with plain colours: many viewers of SVG know no CSS variables.
std::string coloured(const char* Colour::*theme) {
  std::string text{rules};
  for (const Colour& colour : colours) {
    const std::string variable = fmt::format("var(--{})", colour.name);
    for (std::size_t at = 0; (at = text.find(variable, at)) != std::string::npos;)
      text.replace(at, variable.size(), colour.*theme);
  }
  return text;
}

}  // namespace

const std::string& picture_styles() {
  static const std::string styles =
      coloured(&Colour::light) + "@media (prefers-color-scheme:dark){" + coloured(&Colour::dark) + "}\n";
  return styles;
}

}  // namespace waywright
