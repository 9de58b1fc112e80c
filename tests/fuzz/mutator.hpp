// Seeded mutations of bytes and of JSON trees.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "waywright/core/random.hpp"

namespace waywright::fuzz {

class Mutator {
 public:
  using Json = nlohmann::ordered_json;

  explicit Mutator(std::uint64_t seed) : random_{Random::stream(seed, 0)} {}

  std::size_t below(std::size_t n) {
    return static_cast<std::size_t>(random_.integer(0, static_cast<std::int64_t>(n) - 1));
  }

  /// A few bytes changed, taken away, doubled or moved.
  std::string bytes(std::string text) {
    static const std::string alphabet = "{}[],:\"\\0123456789.eE+-truefalsn \n\t\x01\x7f\x80\xc3\xff";
    for (std::size_t edits = 1 + below(4); edits > 0 && !text.empty(); --edits) {
      const std::size_t at = below(text.size());
      const std::size_t count = 1 + below(below(4) == 0 ? 200 : 4);
      switch (below(5)) {
        case 0:
          text[at] = alphabet[below(alphabet.size())];
          break;
        case 1:
          text.erase(at, count);
          break;
        case 2:
          text.insert(at, text.substr(below(text.size()), count));
          break;
        case 3:
          text[at] = static_cast<char>(below(256));
          break;
        default:
          text.insert(at, 1, alphabet[below(alphabet.size())]);
          break;
      }
    }
    return text;
  }

  /// A few values of the tree replaced, removed, renamed or doubled: still JSON, and deep in the readers.
  std::string tree(Json json) {
    for (std::size_t edits = 1 + below(3); edits > 0; --edits) edit(json);
    return json.dump(-1, ' ', false, Json::error_handler_t::ignore);
  }

 private:
  Json other() {
    static const Json pool = Json::parse(
        R"([null, true, false, 0, 1, -1, 2, 3, 0.5, -0.0, 1e-9, 1e-300, 5e-324, 1e6, 1.0000001e6, 1e9, 1e300, 1.7e308,
        9223372036854775807, 18446744073709551615, -9223372036854775808, "", "x", "dock", "undock", "tricycle", "turn", "poses", "forbidden", "directed", "speed_limit", "a\u0000b", [], {}, [0],
        [0, 0], [0, 0, 0], [[0, 0], [1, 0], [1, 1]], [[0, 0], [1, 1], [1, 0], [0, 1]], [[[0, 0], [1, 0]], [[1, 1], [2, 1]]], {"disc": 0}, {"x": {}},
        {"pose": [0, 0, 0]}, [[[[[[[[1]]]]]]]]])");
    return pool[below(pool.size())];
  }

  void edit(Json& json) {
    Json* at = &json;
    for (std::size_t steps = 1 + below(7); steps > 0 && at->is_structured() && !at->empty(); --steps)
      at = child(*at);
    if (at->is_structured() && !at->empty() && below(2) == 0) {
      Json* inner = child(*at);
      const Json copy = *inner;
      if (at->is_array()) {
        if (below(2) == 0)
          at->erase(below(at->size()));
        else
          at->push_back(copy);
      } else {
        auto& members = at->get_ref<Json::object_t&>();
        const std::string key = (members.begin() + static_cast<std::ptrdiff_t>(below(members.size())))->first;
        if (below(3) == 0)
          at->erase(key);
        else
          (*at)[below(2) == 0 ? bytes(key) : "transform"] = below(2) == 0 ? copy : other();
      }
    } else if (at->is_number() && below(2) == 0) {
      *at =
          at->get<double>() * (below(2) == 0 ? -1.0 : random_.uniform(0.0, 3.0)) + random_.uniform(-0.1, 0.1);
    } else {
      *at = other();
    }
  }

  Json* child(Json& json) {
    if (json.is_array()) return &json[below(json.size())];
    auto& members = json.get_ref<Json::object_t&>();
    return &(members.begin() + static_cast<std::ptrdiff_t>(below(members.size())))->second;
  }

  Random random_;
};

}  // namespace waywright::fuzz
