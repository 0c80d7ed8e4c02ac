// Power of a diesel at one speed over frequency: in narrow bands, and order by order.
#pragma once

#include <complex>
#include <vector>

#include "diesel/likeness.hpp"
#include "rigsound/analysis/curve.hpp"

namespace rigsound::analysis {

constexpr double kLowestShown_hz = 20, kHighestShown_hz = 10000, kHighestShownOrder_hz = 400;

/// Hz, and dB re full scale in bands of 1/8 order of the cycle, from kLowestShown_hz to kHighestShown_hz.
/// Thread: OFF.
Curve band_levels(const CyclicSound& s);

/// Hz, and dB re full scale of orders 1, 2, ... below kHighestShownOrder_hz, of C_k as in
/// DieselPoint::orders. `f0`: cycles a second. Thread: OFF.
Curve order_levels(const std::vector<std::complex<double>>& C, double f0);

}  // namespace rigsound::analysis
