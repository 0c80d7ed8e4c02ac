// CPU of the two denoisers, beside what a matrix product reaches on this machine in the same run.
// nmf_bench [--json]: user seconds of one thread, the least of several runs.
#include <ctime>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <functional>
#include <limits>
#include <vector>

#include "denoise/paper_nmf.hpp"
#include "kernels/kl_kernels.hpp"
#include "rigsound/analysis/chain.hpp"
#include "simulate/drillbench_clip.hpp"

using namespace rigsound::analysis;

namespace {

constexpr int kProduct = 2048;
constexpr double kProductFlop = 2.0 * kProduct * kProduct * kProduct;
constexpr int kId = 100, kRuns = 3;

double user_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double least_seconds(int runs, const std::function<void()>& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int run = 0; run < runs; ++run) {
    const double start = user_seconds();
    work();
    least = std::min(least, user_seconds() - start);
  }
  return least;
}

std::vector<float> mixture() {
  const std::vector<double> clean = drillbench_clip(kId, 2).clean, background = drillbench_background(kId, 2);
  std::vector<float> mix;
  for (size_t n = 0; n < clean.size(); ++n) mix.push_back(static_cast<float>(clean[n] + background[n]));
  return mix;
}

double peak_flops() {
  const Eigen::MatrixXf A = Eigen::MatrixXf::Random(kProduct, kProduct), B = A.transpose();
  Eigen::MatrixXf C(kProduct, kProduct);
  return kProductFlop /
         least_seconds(kRuns, [&] { kl_kernels().multiply(A.data(), B.data(), C.data(), kProduct); });
}

/// Four products of M x N x K an iteration.
double nmf_flop(const Eigen::MatrixXf& V, const PaperNmfOptions& options) {
  return 8.0 * static_cast<double>(V.size()) * options.K * (options.Q_1 + options.Q_2);
}

}  // namespace

int main(int argc, char** argv) {
  const bool json = argc > 1 && std::strcmp(argv[1], "--json") == 0;
  const std::vector<float> x = mixture();
  const Eigen::MatrixXf V = stft(x, kPaperStft).abs().matrix();
  const PaperNmfOptions options;
  const double peak = peak_flops(), ideal = nmf_flop(V, options) / peak;
  const double nmf = least_seconds(kRuns, [&] { paper_nmf(V, options); });
  const double chain = least_seconds(3 * kRuns, [&] { run_chain(x, {}); });
  if (json) {
    std::printf("{\"sgemm_gflops\": %.1f, \"paper_nmf_s\": %.3f, \"at_peak_s\": %.3f, \"chain_s\": %.3f}\n",
                1e-9 * peak, nmf, ideal, chain);
    return 0;
  }
  std::printf("matrix product %d^3: %.1f GFLOP/s (%s)\n", kProduct, 1e-9 * peak, kl_kernels().name);
  std::printf("paper NMF %ldx%ldx%d, %d iterations: %.2f s, %.2f s at that rate (%.0f %%)\n",
              static_cast<long>(V.rows()), static_cast<long>(V.cols()), options.K, options.Q_1 + options.Q_2,
              nmf, ideal, 100 * ideal / nmf);
  std::printf("click-nmf chain, 2 s clip at 0 dB: %.3f s\n", chain);
}
