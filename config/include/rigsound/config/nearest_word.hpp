// The known word a misspelt one was meant to be.
#pragma once

#include <algorithm>
#include <numeric>
#include <string_view>
#include <vector>

namespace rigsound::config {

/// Letters to insert, delete, replace or swap with their neighbour to get from one word to the other
/// (optimal string alignment distance).
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last, last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last = last, last = row;
  }
  return last.back();
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
