#include "contrast/runs.hpp"

#include <algorithm>

#include "contrast/impact_rate.hpp"
#include "contrast/loudness.hpp"
#include "rigsound/analysis/parallel.hpp"
#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {
namespace {

constexpr std::uint64_t kEarLayer = 900;  // of random numbers; the engine's are lower

Eigen::MatrixXd excerpts_of(const std::vector<float>& sound, const dsp::RandomField& ear) {
  constexpr auto kSecond = static_cast<std::ptrdiff_t>(kAnalysisRate);
  const auto count = static_cast<std::ptrdiff_t>(sound.size()) / kSecond;
  Eigen::MatrixXd excerpts;
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const std::vector<float> second(sound.begin() + i * kSecond, sound.begin() + (i + 1) * kSecond);
    const Eigen::VectorXd values = noticed(listen(second), ear, static_cast<std::uint64_t>(i));
    if (i == 0) excerpts.resize(values.size(), count);
    excerpts.col(i) = values;
  }
  return excerpts;
}

}  // namespace

Listener::Listener(const ContrastOptions& options, const RenderSound& render,
                   const std::function<void(int, int)>& progress, int expected_settings)
    : options_(options), render_(render), progress_(progress), total_(expected_settings * options.runs) {}

Run Listener::run(const DrillSetting& setting, std::uint64_t number) const {
  const auto [sound, drill] = render_(setting, options_.seconds, options_.seed + number);
  const dsp::RandomField ear(options_.seed, kEarLayer, number);
  Run run{listen(sound), loudness_sone(loudness_bands(sound, options_.full_scale_db_spl)),
          excerpts_of(sound, ear)};
  if (!drill.empty()) run.heard.rate_hz = impact_rate_hz(drill);
  return run;
}

std::vector<Runs> Listener::listen_to(const std::vector<DrillSetting>& settings) {
  const auto of_each = static_cast<std::size_t>(options_.runs);
  std::vector<Runs> all(settings.size(), Runs(of_each));
  for_each_index(static_cast<int>(settings.size() * of_each), options_.jobs, [&](int job) {
    const auto i = static_cast<std::size_t>(job);
    all[i / of_each][i % of_each] = run(settings[i / of_each], runs_ + i);
    const std::lock_guard lock(reporting_);
    ++done_;
    progress_(done_, std::max(done_, total_));
  });
  runs_ += settings.size() * of_each;
  return all;
}

}  // namespace rigsound::analysis
