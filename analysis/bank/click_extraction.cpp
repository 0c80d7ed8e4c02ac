#include "bank/click_extraction.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <utility>

#include "bank/click_masks.hpp"
#include "clicks/whitening.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kOrder = 1024;
constexpr std::size_t kRinging = 512;  // samples of 1/A kept behind a click

/// 1/A, from rest; `x` grows by kRinging samples.
std::vector<float> coloured(const std::vector<float>& x, const Eigen::ArrayXd& A) {
  std::vector<float> y(x.size() + kRinging);
  std::vector<double> past(y.size());
  for (std::size_t n = 0; n < y.size(); ++n) {
    double sum = n < x.size() ? x[n] : 0.0f;
    const long order = std::min<long>(static_cast<long>(n), A.size() - 1);
    for (long k = 1; k <= order; ++k) sum -= A(k) * past[n - static_cast<std::size_t>(k)];
    past[n] = sum;
    y[n] = static_cast<float>(sum);
  }
  return y;
}

}  // namespace

void for_each_click(const Segments& segments, const std::vector<ClickCandidate>& candidates,
                    std::vector<std::size_t> wanted,
                    const std::function<void(std::size_t candidate, std::vector<float> click)>& listener) {
  std::sort(wanted.begin(), wanted.end());
  for (auto it = wanted.begin(); it != wanted.end();) {
    const std::size_t s = candidates[*it].segment;
    const ChainResult& segment = segments[s].result;
    const std::vector<float> drilling = segment.drilling.all();
    const ClickMasks masks(segment.clicks, static_cast<long>(drilling.size()));
    for (; it != wanted.end() && candidates[*it].segment == s; ++it)
      listener(*it, masks.extract(drilling, candidates[*it].click));
  }
}

std::vector<std::vector<float>> extract_masked(const Segments& segments,
                                               const std::vector<ClickCandidate>& candidates,
                                               const std::vector<std::size_t>& chosen) {
  std::vector<std::vector<float>> clicks(chosen.size());
  for_each_click(segments, candidates, chosen, [&](std::size_t candidate, std::vector<float> click) {
    const auto place = std::find(chosen.begin(), chosen.end(), candidate) - chosen.begin();
    clicks[static_cast<std::size_t>(place)] = std::move(click);
  });
  return clicks;
}

std::vector<std::vector<float>> extract_whitened(const Segments& segments,
                                                 const std::vector<ClickCandidate>& candidates,
                                                 const std::vector<std::size_t>& chosen) {
  std::vector<std::vector<float>> clicks(chosen.size());
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const std::vector<float> x = segments[s].result.drilling.all();
    const Eigen::ArrayXd A = lpc_whitener(x, kOrder);
    const Eigen::ArrayXf white = whiten(x, A).cast<float>();
    const std::vector<float> y(white.data(), white.data() + white.size());
    const ClickMasks masks(segments[s].result.clicks, static_cast<long>(x.size()));
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      const ClickCandidate& c = candidates[chosen[k]];
      if (c.segment == s) clicks[k] = coloured(masks.extract(y, c.click), A);
    }
  }
  return clicks;
}

}  // namespace rigsound::analysis
