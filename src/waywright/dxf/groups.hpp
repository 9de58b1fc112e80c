// The text of a DXF file as what it consists of: pairs of a group code and a value, grouped into entities.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/core/result.hpp"

namespace waywright::dxf {

/// Points into the text.
struct Group {
  int code = 0;
  std::string_view value;  ///< without blanks around it
  std::size_t line = 0;    ///< of the value, from 1
};

/// One entry of a table, a header variable, a block's head or an entity. A POLYLINE has its vertices in it, each begun by a group 0.
struct Item {
  std::string_view type;  ///< "LINE", "LAYER", "$INSUNITS"; "BLOCK" and "ENDBLK" as they come
  std::size_t line = 0;
  std::vector<Group> groups;

  std::string_view text(int code) const;             ///< of the first such group; empty where there is none
  std::optional<std::string_view> find(int code) const;
};

enum class Section { header, tables, blocks, entities };

/// Calls `visit` for each item in order; it stops at the first error that `visit` returns. Refuses what is no text of groups, binary DXF,
/// and a file that ends before its EOF. Attributes of a block's insertion are left out.
/// @return the first error
std::optional<InputError> walk(std::string_view text, const std::string& name,
                               const std::function<std::optional<InputError>(Section, const Item&)>& visit);

/// A finite number; empty where it is none.
std::optional<double> number_from(std::string_view text);

}  // namespace waywright::dxf
