#include "bank/feed_laws.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numeric/median_slope.hpp"
#include "rigsound/dsp/elementary.hpp"

namespace rigsound::analysis {
namespace {

int distinct_feeds(const std::vector<FedBank>& series) {
  std::vector<double> feeds;
  for (const FedBank& b : series) feeds.push_back(b.feed_bar);
  std::sort(feeds.begin(), feeds.end());
  int count = 0;
  double last = -std::numeric_limits<double>::infinity();
  for (const double feed : feeds)
    if (feed > last + kFeedsApart_bar) ++count, last = feed;
  return count;
}

template <class Figure>
double slope_of(const std::vector<FedBank>& series, Figure figure) {
  std::vector<LinePoint> points;
  for (const FedBank& b : series) points.push_back({b.feed_bar, figure(b)});
  return median_slope(points, kFeedsApart_bar);
}

}  // namespace

std::optional<FeedLaws> fit_feed_laws(const std::vector<FedBank>& series) {
  if (distinct_feeds(series) < kFewestFeeds) return std::nullopt;
  const auto of_bank = [&](auto figure) {
    return slope_of(series, [&](const FedBank& fed) { return figure(fed.bank); });
  };
  FeedLaws laws;
  laws.ln_gap = of_bank([](const ClickBank& b) { return std::log(b.mean_gap_samples / b.sample_rate); });
  laws.ln_level =
      of_bank([](const ClickBank& b) { return std::log(b.mean_amplitude) + b.gain_db * dsp::kLn10 / 20; });
  laws.ln_decay = of_bank([](const ClickBank& b) { return std::log(b.decay * b.sample_rate); });
  laws.gap_variation =
      of_bank([](const ClickBank& b) { return b.gap_deviation_samples / b.mean_gap_samples; });
  laws.amplitude_variation =
      of_bank([](const ClickBank& b) { return b.amplitude_deviation / b.mean_amplitude; });
  laws.tilt_db_per_octave = slope_of(series, [](const FedBank& fed) { return fed.tilt_db_per_octave; });
  return laws;
}

}  // namespace rigsound::analysis
