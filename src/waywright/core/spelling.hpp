// What a word that is not known was meant to be: for messages that refuse one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace waywright {

/// The known word that was meant, where one is near: one edit (a letter more, less, another, or two swapped) for short words, up to three for long ones, never most of the
/// letters. Of several as near the first; empty where none is. No hint is looked for to words of more than 64 bytes.
std::string nearest_word(std::string_view word, const std::vector<std::string>& known);

/// `, did you mean "WORD"?`, to be put behind what is wrong; empty where no word is near.
std::string meant_instead(std::string_view word, const std::vector<std::string>& known);

/// The words parted by commas, as messages list what is allowed.
std::string list_of_words(const std::vector<std::string>& words);

}  // namespace waywright
