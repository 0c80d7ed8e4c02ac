#include "chain/clip_analysis.hpp"
#include "clicks/paper_second_stage.hpp"
#include "clicks/whitening.hpp"
#include "denoise/paper_nmf.hpp"
#include "spectrum/stft.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kLpcOrder = 1024;  // section 3.1

Eigen::ArrayXd mean_power(const std::vector<float>& x) {
  return stft(x, kChainStft).abs2().cast<double>().rowwise().mean();
}

std::vector<float> without(const std::vector<float>& x, const std::vector<float>& part) {
  std::vector<float> rest(x);
  for (size_t n = 0; n < rest.size(); ++n) rest[n] -= part[n];
  return rest;
}

}  // namespace

ClipMachine split_by_paper(const std::vector<float>& x, const std::vector<Segment>& windows,
                           const ChainOptions& options, const Dump& dump) {
  PaperNmfOptions nmf;
  nmf.seed = options.seed;
  ClipMachine split;
  split.drilling =
      options.denoise ? inverse_stft(paper_drilling(stft(x, kPaperStft), nmf), x.size(), kPaperStft) : x;
  const Eigen::ArrayXd y = whiten(split.drilling, lpc_whitener(split.drilling, kLpcOrder));
  dump.signal("denoised", Eigen::Map<const Eigen::ArrayXf>(split.drilling.data(), y.size()).cast<double>());
  dump.signal("whitened", y);
  split.clicks = paper_clicks(y);
  dump.train("paper", split.clicks);
  split.signal_psd = mean_power(split.drilling);
  split.noise_psd = mean_power(without(x, split.drilling));
  // Whether there is a drill at all the paper does not test: both methods use the same verdict.
  split.verdict = split_by_click_nmf(x, windows, options, Dump({})).front().verdict;
  return split;
}

}  // namespace rigsound::analysis
