// The part of the sound that repeats: mean cycle, orders, and how sure they are (A4).
#pragma once

#include <complex>
#include <vector>

#include "diesel/section.hpp"

namespace rigsound::analysis {

struct Orders {
  std::vector<std::complex<double>> C;  ///< orders 1, 2, ...: sum_k Re(C_k exp(2 pi i k theta))
  std::vector<double> noise;            ///< variance of each C_k, what chance alone would leave of it
  double synchronous = 0;               ///< share of the block's energy in the mean cycle
};

/// Means over the open samples of cycles first ... first + count - 1. `last`: highest order. Thread: OFF.
std::vector<double> mean_cycle(const CycleBlock& block, int first, int count);
Orders orders_of(const CycleBlock& block, int first, int count, int last);

/// Turns `orders` by the crank angle (cycles) at which they resemble `reference` best; only phases count.
/// Thread: OFF.
double crank_shift(const Orders& reference, const Orders& orders);

}  // namespace rigsound::analysis
