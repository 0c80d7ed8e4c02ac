// CPU of the paper's factorisation and of `analyze` on parts of 2 s, beside what a matrix product reaches on
// this machine in the same run: seconds times that rate are what they cost, in GFLOP, whatever the machine.
// nmf_bench [--json]: CPU seconds of one thread, the least of several runs.
#include <ctime>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <functional>
#include <limits>
#include <vector>

#include "analyzer/part_analysis.hpp"
#include "denoise/paper_nmf.hpp"
#include "kept_memory.hpp"
#include "kernels/kl_kernels.hpp"
#include "rigsound/machine/input_error.hpp"
#include "simulate/drillbench_clip.hpp"

using namespace rigsound::analysis;

namespace {

constexpr int kProduct = 2048;
constexpr double kProductFlop = 2.0 * kProduct * kProduct * kProduct;
constexpr int kId = 100, kRuns = 3;

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double least_seconds(int runs, const std::function<void()>& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int run = 0; run < runs; ++run) {
    const double start = cpu_seconds();
    work();
    least = std::min(least, cpu_seconds() - start);
  }
  return least;
}

/// A part of 2 s: so much drilling and so much background, of RMS 1 each.
struct Mixture {
  const char* name;
  double drilling, background;

  std::vector<float> sound() const {
    const std::vector<double> clean = drillbench_clip(kId, 2).clean, noise = drillbench_background(kId, 2);
    std::vector<float> mix;
    for (std::size_t n = 0; n < clean.size(); ++n)
      mix.push_back(static_cast<float>(drilling * clean[n] + background * noise[n]));
    return mix;
  }
};

constexpr Mixture kMixtures[] = {
    {"clean", 1, 0}, {"+6 dB", 2, 1}, {"0 dB", 1, 1}, {"-6 dB", 1, 2}, {"background alone", 0, 1}};
constexpr Mixture kUsual = {"0 dB", 1, 1};

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

/// From samples to bank, or to the refusal.
double analyze_seconds(const std::vector<float>& sound) {
  Part part;
  part.labelled = false;
  const Samples recorded(sound);
  return least_seconds(3 * kRuns, [&] {
    SampleFile file;
    try {
      analyse_part(part, recorded, file, {});
    } catch (const rigsound::InputError&) {  // nothing drills
    }
  });
}

}  // namespace

int main(int argc, char** argv) {
  rigsound::tools::keep_freed_memory();  // as the verbs do
  const bool json = argc > 1 && std::strcmp(argv[1], "--json") == 0;
  const Eigen::MatrixXf V = stft(kUsual.sound(), kPaperStft).abs().matrix();
  const PaperNmfOptions options;
  const double peak = peak_flops(), ideal = nmf_flop(V, options) / peak;
  const double nmf = least_seconds(kRuns, [&] { paper_nmf(V, options); });
  if (json) {
    std::printf("{\"sgemm_gflops\": %.1f, \"paper_nmf_s\": %.3f, \"at_peak_s\": %.3f}\n", 1e-9 * peak, nmf,
                ideal);
    return 0;
  }
  std::printf("matrix product %d^3: %.1f GFLOP/s (%s)\n", kProduct, 1e-9 * peak, kl_kernels().name);
  std::printf("paper NMF %ldx%ldx%d, %d iterations: %.2f s, %.2f s at that rate (%.0f %%)\n",
              static_cast<long>(V.rows()), static_cast<long>(V.cols()), options.K, options.Q_1 + options.Q_2,
              nmf, ideal, 100 * ideal / nmf);
  for (const Mixture& mixture : kMixtures) {
    const double seconds = analyze_seconds(mixture.sound());
    std::printf("analyze, 2 s, %s: %.3f s, %.1f GFLOP\n", mixture.name, seconds, 1e-9 * peak * seconds);
  }
}
