#include "tool_fit/equaliser_fit.hpp"

#include <cmath>
#include <complex>

#include "numeric/nelder_mead.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/dsp/biquad.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kWorthwhile_db = 0.15, kMostGain_db = 24;

double gain_db(const ToolBand& band, double hz) {
  const dsp::BiquadCoefficients c = dsp::peaking(band.frequency_hz, band.gain_db, band.q, kAnalysisRate);
  const std::complex<double> z = std::polar(1.0, -2 * M_PI * hz / kAnalysisRate);
  return 20 * std::log10(std::abs((c.b0 + z * (c.b1 + z * c.b2)) / (1.0 + z * (c.a1 + z * c.a2))));
}

std::vector<ToolBand> bells_of(const std::vector<double>& u) {
  std::vector<ToolBand> bells;
  for (std::size_t i = 0; i < u.size(); i += 3)
    bells.push_back({std::exp(u[i]), u[i + 1], std::exp(u[i + 2])});
  return bells;
}

class BellFit {
 public:
  BellFit(const std::vector<double>& centre_hz, const std::vector<double>& wanted_db)
      : centre_hz_(centre_hz), wanted_db_(wanted_db) {}

  /// What the bells leave over, without its mean.
  std::vector<double> residual(const std::vector<double>& u) const {
    std::vector<double> left = wanted_db_;
    double mean = 0;
    for (std::size_t b = 0; b < left.size(); ++b) {
      for (const ToolBand& bell : bells_of(u)) left[b] -= gain_db(bell, centre_hz_[b]);
      mean += left[b] / static_cast<double>(left.size());
    }
    for (double& x : left) x -= mean;
    return left;
  }

  double error(const std::vector<double>& u) const {
    double sum = 0;
    for (const double x : residual(u)) sum += std::fabs(x);
    return sum / static_cast<double>(centre_hz_.size());
  }

  /// One more bell, at the band that is furthest off, then all of them adjusted together.
  std::vector<double> with_one_more(std::vector<double> u) const {
    const std::vector<double> left = residual(u);
    std::size_t worst = 0;
    for (std::size_t b = 0; b < left.size(); ++b)
      if (std::fabs(left[b]) > std::fabs(left[worst])) worst = b;
    for (const double x : {std::log(centre_hz_[worst]), left[worst], std::log(2.0)}) u.push_back(x);
    SimplexOptions options;
    for (std::size_t i = 0; i < u.size(); i += 3) {
      options.step.insert(options.step.end(), {0.1, 2, 0.3});
      options.tolerance.insert(options.tolerance.end(), {1e-3, 0.01, 1e-3});
      options.lower.insert(options.lower.end(), {std::log(centre_hz_.front()), -kMostGain_db, std::log(0.3)});
      options.upper.insert(options.upper.end(), {std::log(centre_hz_.back()), kMostGain_db, std::log(8.0)});
    }
    options.evaluations = 400 * static_cast<int>(u.size());
    return nelder_mead([this](const std::vector<double>& v) { return error(v); }, u, options);
  }

 private:
  const std::vector<double>& centre_hz_;
  const std::vector<double>& wanted_db_;
};

}  // namespace

std::vector<ToolBand> fit_bells(const std::vector<double>& centre_hz, const std::vector<double>& wanted_db) {
  const BellFit fit(centre_hz, wanted_db);
  std::vector<double> best;
  for (int i = 0; i < kMaxToolBands; ++i) {
    const std::vector<double> next = fit.with_one_more(best);
    if (fit.error(best) - fit.error(next) < kWorthwhile_db) break;
    best = next;
  }
  return bells_of(best);
}

}  // namespace rigsound::analysis
