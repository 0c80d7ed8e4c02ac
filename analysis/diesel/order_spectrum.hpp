// Power spectrum of an angle-domain signal on a grid of fractions of an order.
#pragma once

#include <vector>

namespace rigsound::analysis {

/// Welch with Hann windows of `cycles` cycles (N * cycles a power of two), half overlapped; bin b lies at
/// order b / cycles. One-sided, sums to the mean square. Thread: OFF.
std::vector<double> order_spectrum(const std::vector<double>& y, int N, int cycles);

}  // namespace rigsound::analysis
