#include "diesel/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diesel/angle_domain.hpp"
#include "diesel/crank_tracker.hpp"
#include "diesel/cycle_length.hpp"
#include "diesel/heard_speed.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kFewestCycles = 20, kFewCycles = 100;
constexpr double kTolerance = 0.03, kWorstCorrelation = 0.7;
constexpr double kProposed = 0.5;        // confidence to go on with: half and double show in the crank
constexpr double kSureOfSpeed = 0.9;     // and to contradict a person with
constexpr double kCut = 1.12;            // speed ratio at which a run-up becomes another point
constexpr double kImpactTail_s = 0.018;  // an impact sounds this long
constexpr double kClippedShare = 0.01;
constexpr int kCyclesAtOnce = 64;  // positions of all would take as much memory as the sound

/// 1 where no impact sounds: 18 ms after one until the next.
std::vector<char> open_samples(const DieselTake& take) {
  if (take.impacts_s.empty()) return {};
  std::vector<char> open(take.mono.size(), 1);
  for (const double impact : take.impacts_s) {
    const auto from = static_cast<std::ptrdiff_t>(impact * kAnalysisRate);
    const auto to = static_cast<std::ptrdiff_t>((impact + kImpactTail_s) * kAnalysisRate);
    for (std::ptrdiff_t n = std::max<std::ptrdiff_t>(0, from);
         n < std::min<std::ptrdiff_t>(to, static_cast<std::ptrdiff_t>(open.size())); ++n)
      open[n] = 0;
  }
  return open;
}

void warn_of_clipping(const DieselTake& take, std::vector<std::string>& warnings) {
  if (take.clipped > kClippedShare)
    warnings.push_back(fmt::format("{}: {:.1f} % of the samples are clipped, expected below 1 %", take.source,
                                   100 * take.clipped));
}

/// Half or twice the speed is a common mistake, and the tracker locks to it as well.
void require_whole_cycles(const Section& section, double rpm, std::vector<std::string>& warnings) {
  constexpr double kAlternates = 4, kAlike = 0.9, kSurelyDiffer = 40, kNearlyAlike = 1.5, kDiffer = 10;
  const Alternation a = alternation_of(section);
  const auto better = [&](double speed, const char* why) {
    return fmt::format("is {:.0f}, but {}, expected {:.0f} r/min", rpm, why, speed);
  };
  if (a.cycles > kAlternates)
    throw InputError(section.source, 0, "rpm",
                     better(rpm_of_cycles(section.f0()) / 2, "every other cycle of 720 degrees differs"));
  const std::string twice =
      better(2 * rpm_of_cycles(section.f0()), "a cycle of 720 degrees holds the same sound twice");
  if (a.halves < kAlike && a.quarters > kSurelyDiffer) throw InputError(section.source, 0, "rpm", twice);
  if (a.halves < kNearlyAlike && a.quarters > kDiffer)
    warnings.push_back(fmt::format("{}: rpm: {}", section.source, twice));
}

bool near(double speed, double other) { return std::fabs(speed / other - 1) <= kTolerance; }

/// The speed that nobody gave.
double proposed_rpm(const DieselTake& take, const HeardSpeed& heard, std::vector<std::string>& warnings) {
  if (heard.confidence < kProposed)
    throw InputError(take.source, 0, "rpm",
                     fmt::format("cannot be told from the sound (likeliest {:.0f} r/min with a confidence of "
                                 "{:.2f}, or {:.0f}), expected --rpm",
                                 heard.rpm, heard.confidence, heard.next_rpm));
  warnings.push_back(
      fmt::format("{}: rpm: {:.0f} r/min is heard, with a confidence of {:.2f}; --rpm says "
                  "otherwise if it is wrong",
                  take.source, heard.rpm, heard.confidence));
  return heard.rpm;
}

/// A diesel of like cylinders sounds like one of twice, four or six times its speed; every other ratio is a
/// mistake.
bool contradicts(const HeardSpeed& heard, double rpm) {
  constexpr double kLikeCylinders[] = {0.5, 1, 2, 4, 6};
  return heard.over_given >= kSureOfSpeed &&
         std::none_of(std::begin(kLikeCylinders), std::end(kLikeCylinders),
                      [&](double ratio) { return near(heard.rpm, ratio * rpm); });
}

CrankTrack track_of(const DieselTake& take, const std::vector<double>& x,
                    std::vector<std::string>& warnings) {
  if (!take.rpm_log.empty()) return track_logged(x, take.rpm_log);
  const HeardSpeed heard = heard_speed(x, take.rpm);
  const double given = take.rpm > 0 ? take.rpm : proposed_rpm(take, heard, warnings);
  if (contradicts(heard, given))
    throw InputError(take.source, 0, "rpm",
                     fmt::format("is {:.0f}, but the recording repeats at {:.0f} r/min (confidence {:.2f}), "
                                 "expected within 3 %",
                                 given, heard.rpm, heard.over_given));
  const double found = repeating_rpm(x, given);
  if (found == 0)
    throw InputError(take.source, fmt::format("does not repeat with any speed near {:.0f} r/min", given));
  if (!near(found, given))
    throw InputError(take.source, 0, "rpm",
                     fmt::format("is {:.0f}, but the recording repeats at {:.0f} r/min, expected within 3 %",
                                 given, found));
  return track_steady(x, found);
}

void require_tracked(const DieselTake& take, const CrankTrack& track, std::vector<std::string>& warnings) {
  const double cycles = track.theta.size() < 2 ? 0 : track.theta.back() - track.theta.front();
  if (cycles < kFewestCycles)
    throw InputError(take.source, fmt::format("holds {:.0f} cycles of 720 degrees, expected at least {}",
                                              cycles, kFewestCycles));
  if (track.correlation < kWorstCorrelation)
    throw InputError(take.source,
                     fmt::format("is not periodic: a cycle and its template correlate by {:.2f}, expected at "
                                 "least {:.1f}",
                                 track.correlation, kWorstCorrelation));
  if (cycles < kFewCycles)
    warnings.push_back(
        fmt::format("{}: only {:.0f} cycles, {} make a good model", take.source, cycles, kFewCycles));
}

double speed(const std::vector<double>& theta, std::size_t from, std::size_t to) {
  return (theta[to - 1] - theta[from]) * kAnalysisRate / static_cast<double>(to - 1 - from);
}

/// Ends of the pieces in which the speed stays within kCut.
std::vector<std::size_t> cuts(const DieselTake& take, const std::vector<double>& theta) {
  constexpr std::size_t kSpeedEvery = 4800;
  std::vector<std::size_t> ends;
  double low = 1e9, high = 0;
  for (std::size_t n = 0; n + kSpeedEvery < theta.size(); n += kSpeedEvery) {
    const double f = speed(theta, n, n + kSpeedEvery + 1);
    low = std::min(low, f), high = std::max(high, f);
    if (high / low < kCut) continue;
    if (take.rpm_log.empty())
      throw InputError(
          take.source, 0, "rpm",
          fmt::format("moves from {:.0f} to {:.0f} r/min, expected a steady speed or its rpm track",
                      rpm_of_cycles(low), rpm_of_cycles(high)));
    ends.push_back(n);
    low = high = f;
  }
  ends.push_back(theta.size());
  return ends;
}

}  // namespace

double Section::f0() const { return speed(theta, 0, theta.size()); }

std::vector<Section> sections_of(const std::vector<DieselTake>& takes, std::vector<std::string>& warnings,
                                 const Progress& progress) {
  std::vector<Section> sections;
  for (std::size_t i = 0; i < takes.size(); ++i) {
    const DieselTake& take = takes[i];
    warn_of_clipping(take, warnings);
    const std::vector<double> x(take.mono.begin(), take.mono.end());
    const CrankTrack track = track_of(take, x, warnings);
    show(progress, i + 1, takes.size());
    require_tracked(take, track, warnings);
    const std::vector<char> open = open_samples(take);
    const std::vector<std::size_t> ends = cuts(take, track.theta);
    std::size_t from = 0;
    for (const std::size_t end : ends) {
      const std::size_t begin = from;
      from = end;
      if (track.theta[end - 1] - track.theta[begin] < kFewestCycles) continue;
      Section s;
      s.source = take.source, s.take = static_cast<int>(i);
      const auto at = static_cast<std::ptrdiff_t>(track.first + begin);
      const auto length = static_cast<std::ptrdiff_t>(end - begin);
      s.x.assign(x.begin() + at, x.begin() + at + length);
      s.theta.assign(track.theta.begin() + static_cast<std::ptrdiff_t>(begin),
                     track.theta.begin() + static_cast<std::ptrdiff_t>(end));
      if (!open.empty()) s.open.assign(open.begin() + at, open.begin() + at + length);
      s.nyquist_hz = std::min(take.source_rate, static_cast<int>(kAnalysisRate)) / 2.0;
      s.load = take.load, s.correlation = track.correlation, s.run_up = ends.size() > 1;
      if (take.rpm_log.empty()) require_whole_cycles(s, take.rpm > 0 ? take.rpm : track.rpm(), warnings);
      sections.push_back(std::move(s));
    }
  }
  if (sections.empty())
    throw InputError(takes.front().source, "moves too fast: no 20 cycles lie within 12 % of one speed");
  return sections;
}

CycleBlock cycles_of(const Section& section, const std::vector<double>& x, double origin, int N) {
  CycleBlock block;
  block.N = N;
  block.origin = std::ceil(section.theta.front() - origin) + origin;
  block.cycles = static_cast<int>(std::floor(section.theta.back() - block.origin));
  Sinc sinc;
  sinc.bandwidth *= std::min(1.0, N * section.f0() / kAnalysisRate);
  block.y.reserve(static_cast<std::size_t>(block.cycles) * static_cast<std::size_t>(N));
  for (int r = 0; r < block.cycles; r += kCyclesAtOnce) {
    const int cycles = std::min(kCyclesAtOnce, block.cycles - r);
    const std::vector<double> at =
        samples_at_angles(section.theta, block.origin + r, N, static_cast<std::size_t>(cycles * N));
    const std::vector<double> y = interpolated(x, at, sinc);
    block.y.insert(block.y.end(), y.begin(), y.end());
    if (!section.open.empty())
      for (const double n : at) block.open.push_back(section.open[static_cast<std::size_t>(n)]);
  }
  return block;
}

}  // namespace rigsound::analysis
