#include "waywright/study/check_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "waywright/core/version.hpp"
#include "waywright/report/report.hpp"
#include "waywright/report/svg_writer.hpp"
#include "waywright/report/words.hpp"

namespace waywright {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

bool is_solved(const Checked& c) { return c.figures.status == Status::solved; }

/// As it is shown, so that what looks the same is ordered by what follows.
double shown(double metres) { return std::round(metres * 1e4); }

std::string clearance_of(const PlaceFigures& f) {
  if (!f.has_path) return "–";
  if (f.tightest) return fmt::format("{:.4f}", f.tightest->clearance);
  return f.collision_free ? "> 10" : "0";
}

std::string spot_words(const TightSpot& spot) { return fmt::format("{} ({:.2f}, {:.2f})", spot.against, spot.point.x, spot.point.y); }

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

/// Code points, about the columns that a terminal shows.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}
std::string padded(std::string text, std::size_t width) {
  if (const std::size_t w = width_of(text); w < width) text.append(width - w, ' ');
  return text;
}

/// Of a link's path: everything but letters, digits, '-', '_', '.' by its bytes.
std::string link_to(const std::string& folder) {
  std::string out;
  for (const char c : folder) {
    const auto u = static_cast<unsigned char>(c);
    const bool plain = u < 0x80 && (std::isalnum(u) != 0 || c == '-' || c == '_' || c == '.');
    out += plain ? std::string(1, c) : fmt::format("%{:02X}", u);
  }
  return out;
}

constexpr std::string_view check_styles = R"(
body{max-width:1400px}.check td{vertical-align:middle}.check .picture img{display:block;max-width:100%;height:auto;border:1px solid var(--line)}.check .above td{border-bottom:none;padding-bottom:2px}.check .beside img{max-width:none}
.check th,.check td{padding-right:14px}.check th{vertical-align:bottom}.check .against{min-width:9em}.wrap{overflow-x:auto}.check .figure{text-align:right}.check td.figure{white-space:nowrap}a{color:inherit}.check .place{font-weight:600}.check .reason{max-width:46em}
)";

/// Does not fit beside the figures: it stands below them.
bool is_wide(const PlaceFigures& f) { return f.picture_width > 330.0; }

std::string picture_of(const std::string& link, const PlaceFigures& f) {
  return fmt::format("<a href=\"{0}/report.html\"><img loading=\"lazy\" src=\"{0}/small.svg\" width=\"{1:.0f}\" height=\"{2:.0f}\" alt=\"{3}\"></a>", link, f.picture_width, f.picture_height,
                     escaped("plan of " + f.name));
}

std::string place_cell(const std::string& link, const Checked& c) {
  const PlaceFigures& f = c.figures;
  return fmt::format(
      "<td{3}><a class=\"place\" href=\"{0}/report.html\">{1}</a><span class=\"soft\"><a href=\"{0}/plan.svg\">picture</a> · <a href=\"{0}/plan.json\">plan.json</a>{2}</span></td>",
      link, escaped(f.name), c.taken_over ? " · taken over" : "", is_wide(f) ? " colspan=\"2\"" : "");
}

/// The picture, the place and `cells`; a wide picture in a row of its own below, across all columns.
std::string row_of(const std::string& link, const Checked& c, const std::string& cells, int columns) {
  const std::string picture = picture_of(link, c.figures), place = place_cell(link, c);
  if (!is_wide(c.figures)) return fmt::format("<tr><td class=\"picture beside\">{}</td>{}{}</tr>\n", picture, place, cells);
  return fmt::format("<tr class=\"above\">{}{}</tr>\n<tr><td class=\"picture\" colspan=\"{}\">{}</td></tr>\n", place, cells, columns, picture);
}

std::string failed_table(const std::vector<Checked>& checked, const std::vector<Place>& places) {
  std::string out;
  for (const Checked& c : checked) {
    if (is_solved(c)) continue;
    const std::string link = link_to(places[c.place].folder);
    out += row_of(link, c, fmt::format("<td class=\"bad\">{}</td><td class=\"reason\">{}</td>", to_string(c.figures.status), escaped(as_sentence(c.figures.reason, c.figures.planner))), 4);
  }
  if (out.empty()) return out;
  return "<h2>Not solved</h2>\n<div class=\"wrap\"><table class=\"check\"><thead><tr><th></th><th>Place</th><th>Status</th><th>Reason</th></tr></thead><tbody>\n" + out + "</tbody></table></div>\n";
}

std::string spot_cell(const std::optional<TightSpot>& spot, const std::optional<double>& in_pocket = {}) {
  const std::string pocket = in_pocket ? fmt::format("<span class=\"soft\">forks in the pocket {:.1f}</span>", 1000.0 * *in_pocket) : "";
  if (!spot) return "<td class=\"figure\">–</td><td></td>";
  return fmt::format("<td class=\"figure\">{:.1f}{}</td><td class=\"against\">{}<span class=\"soft\">at ({:.2f}, {:.2f})</span></td>", 1000.0 * spot->clearance, pocket, escaped(spot->against), spot->point.x,
                     spot->point.y);
}

std::string solved_table(const std::vector<Checked>& checked, const std::vector<Place>& places) {
  std::string out;
  for (const Checked& c : checked) {
    if (!is_solved(c)) continue;
    const PlaceFigures& f = c.figures;
    const std::string link = link_to(places[c.place].folder);
    const std::string proven = f.tightest ? spot_cell(f.tightest, f.pocket_clearance) : "<td class=\"figure\">over 10 m</td><td></td>";
    const std::string limit = f.curvature_limit ? fmt::format("<span class=\"soft\">of {:.3f}</span>", *f.curvature_limit) : "";
    out += row_of(link, c,
                  fmt::format("{}{}<td class=\"figure\">{:.2f}</td><td class=\"figure\">{:.3f}{}</td><td class=\"figure\">{}</td><td class=\"figure\">{:.1f}</td>", proven, spot_cell(f.on_the_way), f.length,
                              f.max_curvature, limit, f.direction_changes, f.travel_time),
                  10);
  }
  if (out.empty()) return out;
  return "<h2>Solved and proven, tightest first</h2>\n<div class=\"wrap\"><table class=\"check\"><thead><tr><th></th><th>Place</th><th class=\"figure\">Proven clearance, mm</th><th>against</th>"
         "<th class=\"figure\">Off the straight at the shelf, mm</th><th>against</th><th class=\"figure\">Length, m</th><th class=\"figure\">Curvature, 1/m</th>"
         "<th class=\"figure\">Changes of direction</th><th class=\"figure\">Time, s</th></tr></thead><tbody>\n" +
         out + "</tbody></table></div>\n";
}

}  // namespace

std::vector<Checked> by_tightness(std::vector<Checked> checked) {
  const auto rank = [](const Checked& c) {
    if (!is_solved(c)) return std::tuple{0, 0.0, 0.0};
    const PlaceFigures& f = c.figures;
    return std::tuple{1, f.tightest ? shown(f.tightest->clearance) : endless, f.on_the_way ? shown(f.on_the_way->clearance) : endless};
  };
  std::stable_sort(checked.begin(), checked.end(), [&](const Checked& a, const Checked& b) { return rank(a) < rank(b); });
  return checked;
}

CheckCounts counts_of(const std::vector<Checked>& checked, std::size_t places) {
  CheckCounts counts;
  counts.places = places;
  for (const Checked& c : checked) {
    ++(is_solved(c) ? counts.solved : counts.not_solved);
    ++(c.taken_over ? counts.taken_over : counts.planned);
  }
  counts.not_reached = places - checked.size();
  return counts;
}

std::string check_headline(const CheckCounts& counts) {
  std::string text = fmt::format("{} {}: {} solved and proven, {} not; {} taken over, {} planned", counts.places, counts.places == 1 ? "place" : "places", counts.solved,
                                 counts.not_solved, counts.taken_over, counts.planned);
  if (counts.not_reached > 0) text += fmt::format("; interrupted, {} not reached", counts.not_reached);
  return text;
}

std::string check_text(const std::vector<Checked>& checked, const std::vector<Place>&, const CheckCounts& counts, std::size_t most) {
  std::string out = check_headline(counts) + "\n";
  for (const Checked& c : checked) {
    if (!is_solved(c)) out += fmt::format("  {}: {}: {}\n", c.figures.name, to_string(c.figures.status), as_sentence(c.figures.reason, c.figures.planner));
  }
  std::vector<std::array<std::string, 7>> lines{{"place", "clear. m", "against", "way m", "against", "length m", "curv. 1/m"}};
  std::vector<std::string> times{"time s"};
  for (const Checked& c : checked) {
    if (!is_solved(c) || lines.size() > most) continue;
    const PlaceFigures& f = c.figures;
    lines.push_back({f.name, clearance_of(f), f.tightest ? spot_words(*f.tightest) : "–", f.on_the_way ? fmt::format("{:.4f}", f.on_the_way->clearance) : "–",
                     f.on_the_way ? spot_words(*f.on_the_way) : "–", fmt::format("{:.2f}", f.length), fmt::format("{:.3f}", f.max_curvature)});
    times.push_back(fmt::format("{:.1f}", f.travel_time));
  }
  if (lines.size() == 1) return out;
  std::array<std::size_t, 7> widths{};
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], width_of(line[i]));
  }
  for (std::size_t k = 0; k < lines.size(); ++k) {
    out += " ";
    for (std::size_t i = 0; i < widths.size(); ++i) out += " " + padded(lines[k][i], widths[i] + 1);
    out += times[k] + "\n";
  }
  if (counts.solved > lines.size() - 1) out += fmt::format("  … and {} more, with more room\n", counts.solved - (lines.size() - 1));
  return out;
}

std::string check_csv(const std::vector<Checked>& checked, const std::vector<Place>& places) {
  std::string out =
      "name,status,clearance,clearance_asked,against,x,y,pocket_clearance,way_clearance,way_against,way_x,way_y,length,max_curvature,direction_changes,travel_time,planner,plan_seconds,"
      "taken_over,folder,reason\n";
  const auto spot = [](const std::optional<TightSpot>& s) {
    return s ? fmt::format("{},{},{}", quoted(s->against), s->point.x, s->point.y) : std::string{",,"};
  };
  for (const Checked& c : checked) {
    const PlaceFigures& f = c.figures;
    const std::string proven = !f.has_path ? "" : f.tightest ? fmt::format("{}", f.tightest->clearance) : f.collision_free ? "10" : "0";
    out += fmt::format("{},{},{},{},{},{},{},{},", quoted(f.name), to_string(f.status), proven, f.asked, spot(f.tightest),
                       f.pocket_clearance ? fmt::format("{}", *f.pocket_clearance) : "", f.on_the_way ? fmt::format("{}", f.on_the_way->clearance) : "", spot(f.on_the_way));
    out += f.has_path ? fmt::format("{},{},{},{}", f.length, f.max_curvature, f.direction_changes, f.travel_time) : ",,,";
    out += fmt::format(",{},{:.6f},{},{},{}\n", quoted(f.planner), f.plan_seconds, c.taken_over ? 1 : 0, quoted(places[c.place].folder), quoted(f.reason));
  }
  return out;
}

std::string check_html(const std::vector<Checked>& checked, const std::vector<Place>& places, const CheckCounts& counts, const std::string& title) {
  const bool good = counts.solved == counts.places;
  std::string out = fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\"><title>{0}</title>\n"
      "<style>{1}{2}</style></head>\n<body>\n<h1>{0}</h1>\n<p class=\"verdict {3}\">{4}</p>\n",
      escaped(title), page_styles(), check_styles, good ? "good" : "bad", escaped(check_headline(counts)));
  out += failed_table(checked, places) + solved_table(checked, places);
  out += fmt::format(
      "<p class=\"soft\">A proven clearance is a lower bound over the whole motion, with the pose error, to everything on the map; at a shelf it is mostly the gap that was "
      "chosen, so beside it stands the tightest spot off the straight stretch at the shelf, at the nominal poses. waywright {}</p>\n</body>\n</html>\n",
      escaped(std::string{version}));
  return out;
}

}  // namespace waywright
