#include "waywright/core/spelling.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace waywright {
namespace {

constexpr std::size_t longest_hint = 64;  // bytes of a word that a hint is looked for

/// Edits (a letter more, less, another, or two swapped) from one word to another.
std::size_t edits_between(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), row(b.size() + 1), next(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    next[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      next[j] = std::min({row[j] + 1, next[j - 1] + 1, row[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) next[j] = std::min(next[j], before[j - 2] + 1);
    }
    std::swap(before, row);
    std::swap(row, next);
  }
  return row[b.size()];
}

}  // namespace

std::string nearest_word(std::string_view word, const std::vector<std::string>& known) {
  if (word.size() > longest_hint) return {};
  std::string nearest;
  std::size_t least = std::min({std::size_t{3}, word.size() / 2, 1 + word.size() / 5}) + 1;
  for (const std::string& k : known) {
    if (k.size() > longest_hint + least) continue;
    if (const std::size_t d = edits_between(word, k); d < least) {
      least = d;
      nearest = k;
    }
  }
  return nearest;
}

std::string meant_instead(std::string_view word, const std::vector<std::string>& known) {
  const std::string nearest = nearest_word(word, known);
  return nearest.empty() ? std::string{} : ", did you mean \"" + nearest + "\"?";
}

std::string list_of_words(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& w : words) list += (list.empty() ? "" : ", ") + w;
  return list;
}

}  // namespace waywright
