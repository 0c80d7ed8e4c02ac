// What a listener hears while the feed creeps up: every step is there, and none stands out as an edge.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "bench/formula_sounds.hpp"
#include "engine/heard.hpp"
#include "engine/tool/sound_levels.hpp"
#include "rigsound/engine.hpp"

using namespace rigsound;
using namespace rigsound::tests;

namespace {

constexpr double kWindow_s = 0.05;
constexpr double kFrom_bar = 30, kTo_bar = 250;

/// One boom of formula banks alone, no limiter at work.
std::vector<double> drilled(const std::function<double(double)>& feed_bar, double seconds,
                            std::uint64_t seed) {
  EngineOptions options;
  options.seed = seed;
  options.channels = 1;
  options.mix.ceiling_dbfs = 0;
  options.mix.drill_db = -30;
  options.mix.diesel_db = -60;
  SoundSet sounds = tools::formula_sounds();
  sounds.diesels.clear();
  sounds.banks[2].mean_amplitude = 1.2;  // overfeed, 7.6 dB over normal: far beyond what seeds differ by
  Engine engine(options, std::move(sounds));
  std::vector<float> block(options.block);
  std::vector<double> sound;
  MachineState state;
  for (double t = 0; t < seconds + 1; t += options.block / kRate) {
    state.boom[0].feed_pressure_bar = static_cast<float>(feed_bar(std::max(0.0, t - 1)));
    engine.process(state, block.data());
    if (t >= 1) sound.insert(sound.end(), block.begin(), block.end());
  }
  return sound;
}

std::vector<double> steady(double feed_bar, double seconds, std::uint64_t seed) {
  return drilled([=](double) { return feed_bar; }, seconds, seed);
}

std::vector<std::vector<double>> windows(const std::vector<double>& sound) {
  const auto length = static_cast<std::ptrdiff_t>(kWindow_s * kRate);
  std::vector<std::vector<double>> levels;
  for (auto at = sound.begin(); sound.end() - at >= length; at += length) {
    std::vector<double> window(at, at + length);
    window[0] += 1e-9;  // no band is quite empty
    levels.push_back(tests::third_octaves_db(window, kRate));
  }
  return levels;
}

double power(const std::vector<double>& levels_db) {
  double sum = 0;
  for (const double db : levels_db) sum += std::pow(10, db / 10);
  return sum;
}

double distance_db(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

/// From each window to the next: change of level, change of third-octave levels, dB.
struct Changes {
  explicit Changes(const std::vector<double>& sound) {
    const std::vector<std::vector<double>> levels = windows(sound);
    for (std::size_t i = 1; i < levels.size(); ++i) {
      level.push_back(std::fabs(10 * std::log10(power(levels[i]) / power(levels[i - 1]))));
      bands.push_back(distance_db(levels[i], levels[i - 1]));
    }
  }
  std::vector<double> level, bands;
};

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

/// The least count that a binomial variable of n and p exceeds with a chance of at most `alpha`.
int critical_count(int n, double p, double alpha) {
  double term = std::pow(1 - p, n), below = term;
  int k = 0;
  while (1 - below > alpha) {
    term *= (n - k) / (k + 1.0) * p / (1 - p);
    below += term;
    ++k;
  }
  return k;
}

/// Mean power a band over the whole sound, dB.
std::vector<double> long_levels(const std::vector<double>& sound) {
  std::vector<double> sum;
  for (const std::vector<double>& window : windows(sound)) {
    sum.resize(window.size());
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += std::pow(10, window[i] / 10);
  }
  for (double& power : sum) power = 10 * std::log10(power);
  return sum;
}

}  // namespace

namespace {

constexpr int kPlaces = 6;

double risen_bar(double share) { return kFrom_bar + (kTo_bar - kFrom_bar) * share; }

struct Edges {
  int level = 0, bands = 0, windows = 0;
};

/// Windows of a minute from kFrom_bar to kTo_bar that change more than steady drilling near their feed does
/// in all but one of a thousand.
Edges edges(const Changes& minute, const std::vector<Changes>& calm) {
  Edges found;
  found.windows = static_cast<int>(minute.level.size());
  for (int i = 0; i < found.windows; ++i) {
    const Changes& near = calm[i * kPlaces / found.windows];
    found.level += minute.level[i] > quantile(near.level, 0.999);
    found.bands += minute.bands[i] > quantile(near.bands, 0.999);
  }
  return found;
}

}  // namespace

TEST_CASE("a slow rise of the feed has no more edges than steady drilling") {
  CHECK(critical_count(1000, 0.001, 0.01) == 4);  // Poisson: P(more than 4) = .0037, P(more than 3) = .019
  std::vector<Changes> calm;
  for (int i = 0; i < kPlaces; ++i) calm.emplace_back(steady(risen_bar((i + 0.5) / kPlaces), 100, 100 + i));
  const Edges rise = edges(Changes(drilled([](double t) { return risen_bar(t / 60); }, 60, 7)), calm);
  const int chance = critical_count(rise.windows, 0.001, 0.01);
  CHECK(rise.level <= chance);
  CHECK(rise.bands <= chance);
  const auto broken = [](double t) { return t - std::floor(t) < 0.2 ? 0 : risen_bar(t / 60); };
  CHECK(edges(Changes(drilled(broken, 60, 7)), calm).level > chance);  // this would be heard
}

TEST_CASE("every step of the feed takes the sound further from normal, and no step is a jump") {
  const std::vector<double> normal = long_levels(steady(90, 20, 1)), again = long_levels(steady(90, 20, 2));
  const double floor = distance_db(normal, again);
  const double whole = distance_db(long_levels(steady(150, 20, 1)), normal);
  std::vector<double> last = normal;
  double last_distance = 0;
  for (double feed = 100; feed <= 150; feed += 10) {
    const std::vector<double> now = long_levels(steady(feed, 20, 1));
    CHECK(distance_db(now, last) > 2 * floor);
    CHECK(distance_db(now, normal) > last_distance);
    last = now, last_distance = distance_db(now, normal);
  }
  for (double feed = 95; feed <= 150; feed += 5) {
    const double step = distance_db(long_levels(steady(feed, 20, 1)), long_levels(steady(feed - 5, 20, 1)));
    CHECK_MESSAGE(step < whole / 4, feed, " bar: ", step, " dB of ", whole);
  }
}
