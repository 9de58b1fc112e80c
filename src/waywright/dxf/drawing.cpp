#include "waywright/dxf/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "waywright/dxf/entity.hpp"

namespace waywright::dxf {
namespace {

constexpr double most_entities = 3e6;  // in all instances: their points, and GDAL's copies of blocks, fit into memory
constexpr std::size_t most_layers = 100'000;
constexpr int deepest = 32;  // blocks in blocks
constexpr double largest_scale = 1e12;  // of a block in all the blocks that it is in

/// The names as UTF-8: older files hold single bytes, and write other letters as \U+XXXX.
std::string utf8_of(std::string_view bytes) {
  std::string out;
  const auto add = [&](unsigned code) {
    if (code < 0x80) out += static_cast<char>(code);
    else if (code < 0x800) (out += static_cast<char>(0xC0 | (code >> 6))) += static_cast<char>(0x80 | (code & 0x3F));
    else ((out += static_cast<char>(0xE0 | (code >> 12))) += static_cast<char>(0x80 | ((code >> 6) & 0x3F))) += static_cast<char>(0x80 | (code & 0x3F));
  };
  bool valid = true;
  for (std::size_t i = 0; i < bytes.size() && valid;) {
    const auto lead = static_cast<unsigned char>(bytes[i]);
    const std::size_t more = lead < 0x80 ? 0 : lead >= 0xC2 && lead < 0xE0 ? 1 : lead >= 0xE0 && lead < 0xF0 ? 2 : lead >= 0xF0 && lead < 0xF5 ? 3 : 4;
    valid = more < 4 && i + more < bytes.size();
    for (std::size_t k = 1; valid && k <= more; ++k) valid = (static_cast<unsigned char>(bytes[i + k]) & 0xC0) == 0x80;
    i += more + 1;
  }
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (bytes.substr(i, 3) == "\\U+" && i + 7 <= bytes.size() && bytes.substr(i + 3, 4).find_first_not_of("0123456789ABCDEFabcdef") == bytes.npos) {
      const auto code = static_cast<unsigned>(std::stoul(std::string{bytes.substr(i + 3, 4)}, nullptr, 16));
      if (code >= 0x20 && (code < 0xD800 || code > 0xDFFF)) {
        add(code);
        i += 6;
        continue;
      }
    }
    if (valid) out += bytes[i];
    else add(static_cast<unsigned char>(bytes[i]));
  }
  return one_line(out);
}

std::size_t index_of(std::map<std::string, std::size_t>& index, const std::string& name, std::size_t next) {
  return index.try_emplace(name, next).first->second;
}

class Scan {
 public:
  explicit Scan(const std::string& name) : name_{name} {
    drawing_.blocks.emplace_back();
    drawing_.blocks.front().known = true;
    layer("0", "0");
  }

  std::optional<InputError> take(Section section, const Item& item) {
    if (section == Section::header && item.type == "$INSUNITS") drawing_.unit = whole_number(item, 70, 0);
    if (section == Section::tables && item.type == "LAYER") return take_layer(item);
    if (section == Section::blocks && any_entity_) return InputError{name_, fmt::format("line {}", item.line), "blocks stand after the entities that insert them", "the section BLOCKS before ENTITIES"};
    any_entity_ = any_entity_ || section == Section::entities;
    if (section == Section::blocks && item.type == "BLOCK") return begin_block(item);
    if (section == Section::blocks && item.type == "ENDBLK") block_ = no_block;
    if (section == Section::entities) block_ = 0;
    if ((section == Section::blocks && item.type != "ENDBLK" && block_ != no_block) || section == Section::entities) return take_entity(item);
    return std::nullopt;
  }

  Parsed<Drawing> finish() {
    drawing_.blocks[0].times = drawing_.blocks[0].scale = 1.0;
    if (auto error = order()) return tl::unexpected{*error};
    // Each after those that insert it.
    for (const std::size_t i : order_) {
      const Block& from = drawing_.blocks[i];
      if (from.times == 0.0) continue;
      drawing_.expanded += from.times * from.entities;
      for (const auto& [kind, count] : from.left_out) drawing_.left_out[kind] += from.times * count;
      double inserted = 0.0;
      for (const Block::Insert& insert : from.inserts) {
        Block& to = drawing_.blocks[insert.block];
        inserted += from.times * insert.times;
        if (to.external) drawing_.external_blocks += from.times * insert.times;
        else if (!to.known) drawing_.missing_blocks += from.times * insert.times;
        to.times += from.times * insert.times;
        to.scale = std::max(to.scale, from.scale * insert.scale);
        if (!(to.scale <= largest_scale)) {
          return tl::unexpected{InputError{name_, "", fmt::format("block {} is enlarged more than {:g} times where it is inserted", name_of(insert.block), largest_scale), "blocks inserted at a smaller scale"}};
        }
      }
      instances_ += inserted;
      if (!(drawing_.expanded + instances_ <= most_entities)) {
        return tl::unexpected{InputError{name_, "", fmt::format("it has more than {:.0f} entities once its blocks are inserted", most_entities),
                                         "a drawing of the floor alone, or of a part of it"}};
      }
    }
    return std::move(drawing_);
  }

 private:
  static constexpr std::size_t no_block = static_cast<std::size_t>(-1);

  std::size_t layer(const std::string& key, std::string_view name) {
    const std::size_t i = index_of(drawing_.layer_index, key, drawing_.layers.size());
    if (i == drawing_.layers.size()) drawing_.layers.push_back({utf8_of(name)});
    return i;
  }

  std::size_t block(std::string_view name) {
    const std::size_t i = index_of(drawing_.block_index, capitals(name), drawing_.blocks.size());
    if (i == drawing_.blocks.size()) drawing_.blocks.emplace_back();
    return i;
  }

  std::optional<InputError> take_layer(const Item& item) {
    const std::string_view name = item.text(2);
    if (name.empty()) return std::nullopt;
    Layer& known = drawing_.layers[layer(capitals(name), name)];
    known.frozen = (whole_number(item, 70, 0) & 1) != 0;
    known.off = whole_number(item, 62, 7) < 0;
    return too_many_layers();
  }

  std::optional<InputError> too_many_layers() const {
    if (drawing_.layers.size() <= most_layers) return std::nullopt;
    return InputError{name_, "", fmt::format("it has more than {} layers", most_layers), "fewer layers"};
  }

  std::optional<InputError> begin_block(const Item& item) {
    block_ = block(item.text(2));
    if (drawing_.blocks[block_].known) {
      return InputError{name_, fmt::format("line {}", item.line), fmt::format("block {} is defined twice", one_line(std::string{item.text(2)})), "each block once"};
    }
    drawing_.blocks[block_].known = true;
    constexpr int references = 4 | 8;
    drawing_.blocks[block_].external = (whole_number(item, 70, 0) & references) != 0;
    return check_numbers(item, name_);
  }

  std::optional<InputError> take_entity(const Item& item) {
    Block& into = drawing_.blocks[block_];
    const std::string key = layer_of(item);
    const std::size_t on = layer(key, item.text(8).empty() ? "0" : item.text(8));
    if (auto error = too_many_layers()) return error;
    if (whole_number(item, 67, 0) == 1) return ++drawing_.in_paper_space, std::nullopt;
    if (whole_number(item, 60, 0) == 1) return ++drawing_.invisible, std::nullopt;
    if (item.type == "INSERT") {
      if (auto error = check_numbers(item, name_)) return error;
      if (drawing_.layers[on].frozen) return ++drawing_.on_frozen_inserts, std::nullopt;
      const double columns = std::max(1, whole_number(item, 70, 1)), rows = std::max(1, whole_number(item, 71, 1));
      const double scale = std::max(std::abs(number(item, 41, 1.0)), std::abs(number(item, 42, 1.0)));
      const std::size_t what = block(item.text(2));  // may move the blocks
      drawing_.blocks[block_].inserts.push_back({what, columns * rows, scale});
      if (block_ == 0) grow(item);
      return std::nullopt;
    }
    if (!is_outline(item)) return ++into.left_out[{std::string{item.type.substr(0, 40)}, on}], std::nullopt;
    if (auto error = check_numbers(item, name_)) return error;
    if (block_ == 0) grow(item);
    ++into.entities;
    return std::nullopt;
  }

  /// By the points that an entity names: group 10 with its y, of lines 11, too.
  void grow(const Item& item) {
    const bool is_line = item.type == "LINE";
    double x = 0.0;
    bool has_x = false;
    for (const Group& group : item.groups) {
      const bool is_x = group.code == 10 || (is_line && group.code == 11);
      const bool is_y = group.code == 20 || (is_line && group.code == 21);
      if (!is_x && !is_y) continue;
      const auto value = number_from(group.value);
      if (is_x) x = value.value_or(0.0);
      if (is_y && has_x && value) grow(Vec2{x, *value});
      has_x = is_x && value.has_value();
    }
  }

  void grow(Vec2 p) {
    if (!any_) drawing_.box = {p, p};
    any_ = true;
    drawing_.box.low = {std::min(drawing_.box.low.x, p.x), std::min(drawing_.box.low.y, p.y)};
    drawing_.box.high = {std::max(drawing_.box.high.x, p.x), std::max(drawing_.box.high.y, p.y)};
  }

  /// Blocks before those that they insert, from model space on; refuses those that insert themselves.
  std::optional<InputError> order() {
    std::vector<int> state(drawing_.blocks.size(), 0);
    const std::function<std::optional<InputError>(std::size_t, int)> visit = [&](std::size_t i, int depth) -> std::optional<InputError> {
      if (state[i] == 2) return std::nullopt;
      if (state[i] == 1) return InputError{name_, "", fmt::format("block {} inserts itself", name_of(i)), "blocks that do not"};
      if (depth > deepest) return InputError{name_, "", fmt::format("blocks are nested more than {} deep", deepest), "fewer levels"};
      state[i] = 1;
      for (const Block::Insert& insert : drawing_.blocks[i].inserts) {
        if (auto error = visit(insert.block, depth + 1)) return error;
      }
      state[i] = 2;
      order_.push_back(i);
      return std::nullopt;
    };
    auto error = visit(0, 0);
    std::reverse(order_.begin(), order_.end());
    return error;
  }

  std::string name_of(std::size_t block) const {
    for (const auto& [name, i] : drawing_.block_index) {
      if (i == block) return one_line(name);
    }
    return "of model space";
  }

  const std::string& name_;
  Drawing drawing_;
  std::size_t block_ = no_block;
  std::vector<std::size_t> order_;
  double instances_ = 0.0;
  bool any_ = false, any_entity_ = false;
};

}  // namespace

Parsed<Drawing> scan(std::string_view text, const std::string& name) {
  Scan scan{name};
  if (auto error = walk(text, name, [&](Section section, const Item& item) { return scan.take(section, item); })) return tl::unexpected{*error};
  return scan.finish();
}

}  // namespace waywright::dxf
