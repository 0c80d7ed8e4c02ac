#include "diesel/low_analysis.hpp"

#include <algorithm>
#include <cmath>

#include "diesel/angle_domain.hpp"
#include "diesel/hbwt.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/dsp/butterworth.hpp"
#include "rigsound/dsp/wavelet.hpp"

namespace rigsound::analysis {
namespace {

/// Mean square of each column of rows first ... last - 1.
std::vector<double> column_power(const std::vector<double>& rows, int columns, int first, int last) {
  std::vector<double> v(static_cast<std::size_t>(columns), 0.0);
  for (int r = first; r < last; ++r)
    for (int c = 0; c < columns; ++c) {
      const double x = rows[r * columns + c];
      v[c] += x * x / (last - first);
    }
  return v;
}

}  // namespace

void learn_low_layer(const CycleBlock& residual, int P_lo, int N, DieselPoint& point) {
  std::vector<double> low = decimated(residual.y, residual.N / P_lo);
  const HbwtCoefficients<double> c = hbwt(low, {P_lo, 1, N});
  const int whole = residual.cycles - 1;
  point.low_variance.clear();
  const auto keep = [&](const std::vector<double>& rows, int scale, double correction) {
    // The periodised transform wraps: what reaches past the end or before the start does not count.
    const int reach = static_cast<int>(std::ceil((dsp::kDb4Taps - 1) * (1 - std::pow(2.0, -scale))));
    const int last = std::max(2, (whole >> scale) - reach), first = last > 3 ? 1 : 0;
    for (const double v : column_power(rows, P_lo, first, last))
      point.low_variance.push_back(static_cast<float>(v * correction));
  };
  for (int n = 1; n <= N; ++n) keep(c.d[n - 1], n, 1.0);
  // All of the mean cycle lay in the scaling band.
  const double left = std::max(2.0, static_cast<double>(whole >> N));
  keep(c.a, N, left / (left - 1));
}

void gate_low_layer(const Section& section, const std::vector<double>& residual, double f_x, int P_lo,
                    DieselPoint& point) {
  if (section.open.empty()) return;
  for (double high = f_x * 1.3; high > 12; high /= 2) {
    dsp::Butterworth6 over(dsp::Pass::kHigh, high / 2, kAnalysisRate),
        under(dsp::Pass::kLow, high, kAnalysisRate);
    double all = 0, open = 0;
    std::size_t counted = 1;
    for (std::size_t n = 0; n < residual.size(); ++n) {
      const double y = over.process(under.process(residual[n]));
      all += y * y;
      if (section.open[n]) open += y * y, ++counted;
    }
    const double share =
        std::min(1.0, open / static_cast<double>(counted) / (all / static_cast<double>(residual.size())));
    for (std::size_t i = 0; i < point.low_variance.size(); ++i) {
      const double f = (static_cast<double>(i % static_cast<std::size_t>(P_lo)) + 0.5) / 2 * section.f0();
      if (f >= high / 2 && (f < high || high > f_x)) point.low_variance[i] *= static_cast<float>(share);
    }
  }
}

}  // namespace rigsound::analysis
