#include "chain/second_machine.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "clicks/known_train.hpp"
#include "clicks/onset_owners.hpp"
#include "clicks/whitening.hpp"
#include "denoise/cs_nmf.hpp"
#include "spectrum/stft.hpp"

namespace rigsound::analysis {
namespace {

// What the second chain has over chance, a click: clear in what the first leaves of the blind split, or
// suspected there and clear once each is found through its own whitener. Of 62 recordings of drills alone
// all over 0.5 kept their phase; of 13 pairs none was under 0.7 and, found anew, none under 1.
constexpr double kSecondSuspected = 0.6, kSecondClear = 0.9;
constexpr double kPhaseLocked = 0.5;  // see phase_locking()
constexpr int kPhaseOrders = 4;
constexpr int kJointRounds = 3;
constexpr StftShape kOnsetStft{128, kCandidateBlock, 128};
constexpr float kPowerFloor = 1e-8F;
constexpr float kLogScatter = 1.28F;  // pi / sqrt(6): standard deviation of the logarithm of an exponential
constexpr float kApart = 1.8F;        // such deviations between two machines that can be told apart
constexpr int kNear = 240;            // samples
constexpr int kSameOnset = 72, kHiddenWithin = 192;  // samples
constexpr long kMostHidden = 4;                      // periods
constexpr double kOwn = 0.1, kOwnThoughClaimed = 0.4;

/// Steps as they stand out of what is known to strike.
Candidates candidates_beside(const Eigen::ArrayXd& y, const HeardTrain& known) {
  const Eigen::ArrayXd rest = y / (known.variance + known.floor).sqrt();
  return find_candidates(rest / std::sqrt(rest.square().mean()));
}

/// The other train as it is heard in y, where `own` sounds too.
HeardTrain hear_beside(const Eigen::ArrayXd& y, const ClickTrain& other, const ClickTrain& own) {
  const HeardTrain both = hear_train(y, other, hear_train(y, own).variance);
  return hear_train(y, other, hear_train(y, own, both.variance).variance);
}

MeanPsd powers_of(const Factors& factors, int machine, const PowerSpectrogram& power) {
  return mean_psd(drilling_of_train(factors, machine), power);
}

Factors factors_of(const std::array<FoundMachine, 2>& machine, const WordFit& clip) {
  std::vector<TrainWords> words;
  for (const FoundMachine& m : machine) words.push_back({m.clicks, decays_around(m.clicks)});
  return cs_nmf(clip, words, {});
}

bool is_near(const ClickTrain& train, int onset, int samples) {
  const auto next = std::lower_bound(train.P.begin(), train.P.end(), onset - samples);
  return next != train.P.end() && *next <= onset + samples;
}

/// Where a gap of several periods leaves room for an impact and the other machine strikes just then, it is
/// hidden rather than missing: it gets its place in the gap and its neighbours' strength.
void add_hidden_clicks(const ClickTrain& other, ClickTrain& train) {
  ClickTrain whole = train;
  whole.P.clear(), whole.beta.clear();
  for (std::size_t i = 0; i < train.P.size(); ++i) {
    if (i > 0) {
      const double gap = train.P[i] - train.P[i - 1];
      const long periods = std::lround(gap / train.mean_gap_samples);
      for (long k = 1; k < periods && periods <= kMostHidden; ++k) {
        const int onset =
            train.P[i - 1] +
            static_cast<int>(std::lround(gap * static_cast<double>(k) / static_cast<double>(periods)));
        if (!is_near(other, onset, kHiddenWithin)) continue;
        whole.P.push_back(onset);
        whole.beta.push_back((train.beta[i - 1] + train.beta[i]) / 2);
      }
    }
    whole.P.push_back(train.P[i]);
    whole.beta.push_back(train.beta[i]);
  }
  train = std::move(whole);
}

/// Whose spectrum an onset has: a linear discriminant between the mean log spectra of the two machines' first
/// milliseconds, whose bins scatter alike (the logarithm of an exponential).
class Ownership {
 public:
  Ownership(const std::vector<float>& x, const TwoMachines& two)
      : log_power_((stft(x, kOnsetStft).abs2() + kPowerFloor).log()) {
    const Eigen::ArrayXf first = usual_spectrum(two.machine[0].clicks, two.machine[1].clicks),
                         second = usual_spectrum(two.machine[1].clicks, two.machine[0].clicks);
    weight_ = first - second;
    middle_ = (first + second) / 2;
  }

  /// 1 where it sounds as the clicks of machine k do, 0 as those of the other one; 1 when they sound alike.
  double share(int k, long block) const {
    const float square = weight_.square().sum();
    if (std::sqrt(square) < kApart * kLogScatter) return 1;
    const double towards_first = (weight_ * (at(block) - middle_)).sum() / square;
    return 0.5 + (k == 0 ? towards_first : -towards_first);
  }

 private:
  Eigen::ArrayXf at(long block) const {
    return log_power_.col(std::min(block + kOnsetStft.window / 2 / kOnsetStft.hop, log_power_.cols() - 1));
  }
  /// Of the clicks no other one is near to.
  Eigen::ArrayXf usual_spectrum(const ClickTrain& train, const ClickTrain& other) const {
    Eigen::ArrayXf sum = Eigen::ArrayXf::Zero(log_power_.rows());
    int counted = 0;
    for (const int P : train.P) {
      if (is_near(other, P, kNear)) continue;
      sum += at(P / kCandidateBlock);
      ++counted;
    }
    return sum / static_cast<float>(std::max(counted, 1));
  }

  Grid log_power_;
  Eigen::ArrayXf weight_, middle_;
};

/// Both anew, each through the whitener that brings it out.
bool find_anew(const std::vector<float>& x, const WordFit& clip, TwoMachines& two) {
  const std::array<FoundMachine, 2> before = two.machine;
  for (int k = 0; k < 2; ++k) {
    const MeanPsd psd = powers_of(two.factors, k, clip.power());
    two.machine[k].found.y = whiten(x, noise_aware_whitener(psd.S, psd.N));
  }
  const Ownership ownership(x, two);
  for (int k = 0; k < 2; ++k) {
    FoundMachine& own = two.machine[k];
    const HeardTrain other = hear_beside(own.found.y, two.machine[1 - k].clicks, before[k].clicks);
    own.found.candidates = candidates_beside(own.found.y, other);
    std::vector<int>& blocks = own.found.candidates.block;
    const auto foreign = [&](int block) {
      const bool claimed = is_near(two.machine[1 - k].clicks, block * kCandidateBlock, kSameOnset);
      return ownership.share(k, block) < (claimed ? kOwnThoughClaimed : kOwn);
    };
    blocks.erase(std::remove_if(blocks.begin(), blocks.end(), foreign), blocks.end());
    own.found.selection =
        select_at_period(own.found.candidates, before[k].clicks.mean_gap_samples / kCandidateBlock);
    own.clicks = fit_found(own.found, FitEffort::kFull, other.variance);
    if (own.clicks.P.size() < kFewestFitted) return false;
    add_hidden_clicks(two.machine[1 - k].clicks, own.clicks);
  }
  return true;
}

/// The onsets of both as those of one, ascending.
std::vector<int> onsets_of_both(const TwoMachines& two) {
  const std::vector<int>&first = two.machine[0].clicks.P, &second = two.machine[1].clicks.P;
  std::vector<int> onsets(first.size() + second.size());
  std::merge(first.begin(), first.end(), second.begin(), second.end(), onsets.begin());
  return onsets;
}

/// Each machine was found alone: where both strike at nearly the same time an onset of one may have been
/// taken for the other's. Divided anew by both rhythms; as they are where that leaves one of them too few.
void divide_by_rhythm(TwoMachines& two) {
  const std::vector<int> onsets = onsets_of_both(two);
  const std::vector<int> owner =
      owners(onsets, {gap_figures(two.machine[0].clicks.P), gap_figures(two.machine[1].clicks.P)});
  std::array<ClickTrain, 2> divided{two.machine[0].clicks, two.machine[1].clicks};
  for (ClickTrain& train : divided) train.P.clear(), train.beta.clear();
  for (std::size_t i = 0; i < onsets.size(); ++i)
    if (owner[i] != kNobody) divided[owner[i]].P.push_back(onsets[i]), divided[owner[i]].beta.push_back(1);
  for (int k = 0; k < 2; ++k)
    if (divided[k].P.size() < kFewestFitted) return;
  for (int k = 0; k < 2; ++k) {
    FoundMachine& m = two.machine[k];
    m.clicks = refitted(m.found.y, divided[k], hear_beside(m.found.y, divided[1 - k], divided[k]).variance);
  }
}

}  // namespace

double phase_locking(const ClickTrain& train, const ClickTrain& other) {
  std::array<std::complex<double>, kPhaseOrders> sum{};
  int counted = 0;
  for (const int P : other.P) {
    const auto next = std::upper_bound(train.P.begin(), train.P.end(), P);
    if (next == train.P.begin() || next == train.P.end()) continue;
    const double phase = static_cast<double>(P - *(next - 1)) / (*next - *(next - 1));
    for (int h = 0; h < kPhaseOrders; ++h) sum[h] += std::polar(1.0, 2 * M_PI * (h + 1) * phase);
    ++counted;
  }
  double longest = 0;
  for (const std::complex<double>& s : sum) longest = std::max(longest, std::abs(s));
  return counted > 0 ? longest / counted : 1;
}

std::optional<TwoMachines> find_second_machine(const std::vector<float>& x, const Eigen::ArrayXd& y,
                                               const WordFit& clip, const ClickTrain& first) {
  TwoMachines two;
  two.machine[0].clicks = first;
  ClickSearch& beside = two.machine[1].found;
  beside.y = y;
  const HeardTrain known = hear_train(beside.y, first);
  beside.candidates = candidates_beside(beside.y, known);
  beside.selection = select_clicks(beside.candidates, kDrillingRates);
  const double at_first = beside.clearness();
  if (at_first < kSecondSuspected) return std::nullopt;
  two.machine[1].clicks = fit_found(beside, FitEffort::kRough, known.variance);
  if (two.machine[1].clicks.P.size() < kFewestFitted) return std::nullopt;
  const double locking =
      std::min(phase_locking(first, two.machine[1].clicks), phase_locking(two.machine[1].clicks, first));
  if (locking > kPhaseLocked) return std::nullopt;
  for (int round = 0; round < kJointRounds; ++round) {
    two.factors = factors_of(two.machine, clip);
    if (!find_anew(x, clip, two)) return std::nullopt;
    divide_by_rhythm(two);
  }
  const double anew = std::min(two.machine[0].found.clearness(), two.machine[1].found.clearness());
  if (std::max(at_first, anew) < kSecondClear) return std::nullopt;
  two.factors = factors_of(two.machine, clip);
  return two;
}

PowerSpectrogram without_other_machine(const PowerSpectrogram& power, const Factors& own) {
  const PsdPair all = modelled_psd(own, power), kept = modelled_psd(without_other_words(own), power);
  PowerSpectrogram rest = power;
  rest.P.leftCols(power.frames) *= (kept.S + kept.N) / (all.S + all.N).max(1e-30f);
  return rest;
}

Factors without_other_words(const Factors& own) {
  Factors kept;
  kept.signal_words = own.signal_words;
  const long background = own.W.cols() - 2L * own.signal_words;
  kept.W = Grid(own.W.rows(), own.signal_words + background);
  kept.W << own.W.leftCols(own.signal_words), own.W.rightCols(background);
  kept.H = Grid(own.signal_words + background, own.H.cols());
  kept.H << own.H.topRows(own.signal_words), own.H.bottomRows(background);
  return kept;
}

}  // namespace rigsound::analysis
