#pragma once

#include "tests/fuzz/target.hpp"
#include "waywright/core/result.hpp"

namespace waywright::fuzz {

/// One sentence: not empty, no line breaks, no control characters.
inline void require_sentence(const InputError& error) {
  require(error.problem.size() > 5, "an error says what is wrong");
  for (const char c : error.message()) {
    require(static_cast<unsigned char>(c) >= 0x20 && c != 0x7F, "an error is one line of text: " + error.message());
  }
}

}  // namespace waywright::fuzz
