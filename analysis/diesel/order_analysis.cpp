#include "diesel/order_analysis.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/dsp/fft.hpp"

namespace rigsound::analysis {

std::vector<double> mean_cycle(const CycleBlock& block, int first, int count) {
  const auto N = static_cast<std::size_t>(block.N);
  std::vector<double> sum(N, 0.0), weight(N, 1e-9);
  for (int r = first; r < first + count; ++r)
    for (std::size_t i = 0; i < N; ++i) {
      const std::size_t at = static_cast<std::size_t>(r) * N + i;
      if (!block.open.empty() && !block.open[at]) continue;
      sum[i] += block.y[at], weight[i] += 1;
    }
  for (std::size_t i = 0; i < N; ++i) sum[i] /= weight[i];
  return sum;
}

Orders orders_of(const CycleBlock& block, int first, int count, int last) {
  const auto N = static_cast<std::size_t>(block.N);
  const std::vector<double> mean = mean_cycle(block, first, count);
  const dsp::Fft<double> fft(block.N);
  Orders orders;
  orders.C.resize(static_cast<std::size_t>(last)), orders.noise.assign(orders.C.size(), 0.0);
  std::vector<double> re = mean, im(N, 0.0);
  fft.forward(re.data(), im.data());
  const double scale = 2.0 / block.N;
  for (std::size_t k = 1; k <= orders.C.size(); ++k) orders.C[k - 1] = {scale * re[k], scale * im[k]};

  double total = 0, repeated = 0;
  for (int r = first; r < first + count; ++r) {
    for (std::size_t i = 0; i < N; ++i) {
      const std::size_t at = static_cast<std::size_t>(r) * N + i;
      const bool open = block.open.empty() || block.open[at];
      re[i] = open ? block.y[at] - mean[i] : 0.0, im[i] = 0;
      if (open) total += block.y[at] * block.y[at], repeated += mean[i] * mean[i];
    }
    fft.forward(re.data(), im.data());
    for (std::size_t k = 1; k <= orders.C.size(); ++k)
      orders.noise[k - 1] +=
          scale * scale * (re[k] * re[k] + im[k] * im[k]) / (count * std::max(1.0, count - 1.0));
  }
  orders.synchronous = total > 0 ? repeated / total : 0;
  return orders;
}

double crank_shift(const Orders& reference, const Orders& orders) {
  const int size = 8192;
  std::vector<double> re(size, 0.0), im(size, 0.0);
  const std::size_t count = std::min({reference.C.size(), orders.C.size(), std::size_t{400}});
  for (std::size_t k = 1; k <= count; ++k) {
    const std::complex<double> a = reference.C[k - 1], b = orders.C[k - 1];
    const double sure = std::min(std::norm(a) / (reference.noise[k - 1] + 1e-30),
                                 std::norm(b) / (orders.noise[k - 1] + 1e-30));
    if (sure < 4) continue;
    // The body turns the phases with speed; weak orders hold as much information about the crank as loud
    // ones.
    const std::complex<double> product = std::conj(a) * b;
    const std::complex<double> weighted = product / std::pow(std::abs(product), 0.5);
    re[k] = weighted.real(), im[k] = weighted.imag();
  }
  dsp::Fft<double>(size).inverse(re.data(), im.data());
  return static_cast<double>(std::max_element(re.begin(), re.end()) - re.begin()) / size;
}

}  // namespace rigsound::analysis
