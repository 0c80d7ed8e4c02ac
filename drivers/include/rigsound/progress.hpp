// How far a long piece of work has come.
#pragma once

#include <cstddef>
#include <functional>

namespace rigsound {

/// Told now and then which share of the work is done, 0...1, never falling; from one thread at a time. May be
/// empty.
using Progress = std::function<void(double share)>;

/// The share of one part of a work: its 0...1 are `from`...`to` of the whole.
inline Progress part_of(const Progress& whole, double from, double to) {
  if (!whole) return {};
  return [whole, from, to](double share) { whole(from + (to - from) * share); };
}

/// So many of so many equal pieces.
inline void show(const Progress& progress, std::size_t done, std::size_t of) {
  if (progress) progress(static_cast<double>(done) / static_cast<double>(of));
}

}  // namespace rigsound
