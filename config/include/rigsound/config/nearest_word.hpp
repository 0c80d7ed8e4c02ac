// The known word a misspelt one was meant to be.
#pragma once

#include <algorithm>
#include <numeric>
#include <string_view>
#include <vector>

namespace rigsound::config {

/// Letters to insert, delete or replace to get from one word to the other (Levenshtein distance).
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

/// The nearest of `words` if no more than a third of the letters differ; else empty. `words` outlives it.
template <class Words>
std::string_view nearest_word(std::string_view given, const Words& words) {
  std::string_view best;
  std::size_t best_distance = std::max<std::size_t>(2, given.size() / 3) + 1;
  for (const auto& word : words) {
    const std::size_t distance = edit_distance(given, word);
    if (distance < best_distance) best = word, best_distance = distance;
  }
  return best;
}

}  // namespace rigsound::config
