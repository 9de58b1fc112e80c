#include "waywright/dxf/layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "waywright/dxf/entity.hpp"

namespace waywright::dxf {
namespace {

constexpr std::size_t most_named = 12;  // layers in one sentence

std::string list_of(const Drawing& drawing) {
  std::string all;
  std::size_t count = 0;
  for (const Layer& layer : drawing.layers) {
    if (++count > 40) return all + ", …";
    all += (all.empty() ? "" : ", ") + layer.name;
  }
  return all;
}

}  // namespace

bool is_annotation(std::string_view name) {
  static constexpr std::array begins{"DIM", "TEXT", "ANNO", "NOTE", "HATCH", "TITLE", "LEGEND", "VIEWPORT", "VPORT", "DEFPOINTS", "LEADER", "LABEL", "SYMB",
                                     "BEMA", "SCHRAFF", "BESCHRIFT"};
  const std::string all = capitals(name);
  if (all.find("VIEW PORT") != all.npos) return true;
  for (std::size_t i = 0; i < all.size();) {
    const auto is_letter = [](char c) { return c >= 'A' && c <= 'Z'; };
    if (!is_letter(all[i])) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < all.size() && is_letter(all[end])) ++end;
    const std::string word = all.substr(i, end - i);
    if (std::any_of(begins.begin(), begins.end(), [&](const char* b) { return word.starts_with(b); }) || word.ends_with("TEXT")) return true;
    i = end;
  }
  return false;
}

bool is_annotation_kind(std::string_view kind) {
  static constexpr std::array kinds{"TEXT", "MTEXT", "RTEXT", "ARCALIGNEDTEXT", "ATTDEF", "DIMENSION", "ARC_DIMENSION", "LARGE_RADIAL_DIMENSION", "HATCH", "MPOLYGON", "LEADER", "MULTILEADER",
                                    "TOLERANCE", "POINT", "VIEWPORT", "IMAGE", "WIPEOUT", "PDFUNDERLAY", "DWFUNDERLAY", "DGNUNDERLAY", "ACAD_TABLE", "OLE2FRAME", "OLEFRAME", "RAY",
                                    "XLINE", "LIGHT", "SUN", "CAMERA", "GEOPOSITIONMARKER", "SECTIONOBJECT"};
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

Parsed<std::vector<Role>> roles_of(const Drawing& drawing, const std::string& name, const Options& options) {
  std::vector<Role> roles(drawing.layers.size(), options.obstacle_layers.empty() ? Role::obstacle : Role::other);
  if (options.obstacle_layers.empty()) {
    for (std::size_t i = 0; i < roles.size(); ++i) {
      if (is_annotation(drawing.layers[i].name)) roles[i] = Role::annotation;
    }
  }
  const auto give = [&](const std::string& wanted, const char* field, Role role) -> std::optional<InputError> {
    bool any = false;
    for (std::size_t i = 0; i < roles.size(); ++i) {
      if (capitals(drawing.layers[i].name) != capitals(wanted)) continue;
      if (role == Role::boundary && !options.obstacle_layers.empty() && roles[i] == Role::obstacle) {
        return InputError{name, field, fmt::format("layer {} is named for obstacles and for the boundary", one_line(wanted)), "each layer for one of them"};
      }
      roles[i] = role;
      any = true;
    }
    if (any) return std::nullopt;
    return InputError{name, field, fmt::format("the drawing has no layer \"{}\"", one_line(wanted)), list_of(drawing)};
  };
  for (const std::string& wanted : options.obstacle_layers) {
    if (auto error = give(wanted, "obstacle_layers", Role::obstacle)) return tl::unexpected{*error};
  }
  if (!options.boundary_layer.empty()) {
    if (auto error = give(options.boundary_layer, "boundary_layer", Role::boundary)) return tl::unexpected{*error};
  }
  for (std::size_t i = 0; i < roles.size(); ++i) {
    const Layer& layer = drawing.layers[i];
    if (roles[i] == Role::boundary && (layer.frozen || layer.off)) {
      return tl::unexpected{InputError{name, "boundary_layer", fmt::format("layer {} is {} in the drawing", layer.name, layer.frozen ? "frozen" : "off"), "a layer that is on"}};
    }
    if (drawing.layers[i].frozen) roles[i] = Role::frozen;
    else if (drawing.layers[i].off) roles[i] = Role::off;
  }
  return roles;
}

std::string counted(const Counts& counts, const Drawing& drawing) {
  struct Line {
    double total = 0.0;
    std::string kinds;
  };
  std::map<std::size_t, std::vector<std::pair<double, std::string>>> by_layer;
  for (const auto& [key, count] : counts) by_layer[key.second].emplace_back(count, key.first);
  std::vector<std::pair<std::size_t, Line>> lines;
  for (auto& [layer, kinds] : by_layer) {
    std::stable_sort(kinds.begin(), kinds.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    Line line;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      line.total += kinds[i].first;
      line.kinds += (i == 0 ? "" : i + 1 == kinds.size() ? " and " : ", ") + fmt::format("{:.0f} {}", kinds[i].first, one_line(kinds[i].second));
    }
    lines.emplace_back(layer, std::move(line));
  }
  std::stable_sort(lines.begin(), lines.end(), [](const auto& a, const auto& b) { return a.second.total > b.second.total; });
  std::string text;
  double rest = 0.0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i < most_named) text += fmt::format("{}{} on {}", i == 0 ? "" : "; ", lines[i].second.kinds, drawing.layers[lines[i].first].name);
    else rest += lines[i].second.total;
  }
  if (rest > 0.0) text += fmt::format("; {:.0f} more on {} other {}", rest, lines.size() - most_named, lines.size() - most_named == 1 ? "layer" : "layers");
  return text;
}

}  // namespace waywright::dxf
