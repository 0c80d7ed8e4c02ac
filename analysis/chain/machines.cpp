#include "chain/machines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

#include "clicks/envelope.hpp"
#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {
namespace {

constexpr std::size_t kMostMachines = 2;
using Order = std::array<std::size_t, kMostMachines>;

/// How far the rates of `here`, taken in `order`, are from those of `reference`.
double rate_distance(const std::vector<ChainResult>& here, const Order& order,
                     const std::vector<ChainResult>& reference) {
  double sum = 0;
  for (std::size_t k = 0; k < kMostMachines; ++k) {
    const double gap = here[order[k]].clicks.mean_gap_samples;
    if (gap > 0) sum += std::fabs(std::log(gap / reference[k].clicks.mean_gap_samples));
  }
  return sum;
}

/// Nothing of a machine in a segment: what is heard there is background.
ChainResult absent(const ChainResult& heard) {
  ChainResult none;
  none.reason = "the machine is not heard";
  none.verdict = heard.verdict;
  for (VerdictWindow& window : none.verdict) window.probability = 0;
  none.noise_psd = heard.noise_psd;
  std::transform(heard.signal_psd.begin(), heard.signal_psd.end(), none.noise_psd.begin(),
                 none.noise_psd.begin(), std::plus<>());
  none.signal_psd.assign(heard.signal_psd.size(), 0.0);
  none.output_psd = none.signal_psd;
  return none;
}

double modelled_energy(const MachineResults& machine) {
  double sum = 0;
  for (const ChainResult& r : machine) sum += std::accumulate(r.signal_psd.begin(), r.signal_psd.end(), 0.0);
  return sum;
}

}  // namespace

std::vector<MachineResults> by_machine(std::vector<std::vector<ChainResult>> segments) {
  const auto several = std::find_if(segments.begin(), segments.end(),
                                    [](const auto& here) { return here.size() == kMostMachines; });
  const std::vector<ChainResult> reference = several == segments.end() ? segments.front() : *several;
  std::vector<MachineResults> machines(reference.size());
  for (std::vector<ChainResult>& here : segments) {
    if (here.size() < machines.size()) here.push_back(absent(here.front()));
    if (machines.size() == kMostMachines &&
        rate_distance(here, {1, 0}, reference) < rate_distance(here, {0, 1}, reference))
      std::swap(here[0], here[1]);
    for (std::size_t k = 0; k < machines.size(); ++k) machines[k].push_back(std::move(here[k]));
  }
  std::stable_sort(machines.begin(), machines.end(), [](const MachineResults& a, const MachineResults& b) {
    return modelled_energy(a) > modelled_energy(b);
  });
  return machines;
}

Machine machine_figures(const SegmentedResult& machine, std::size_t length) {
  const ClickTrain& clicks = machine.joined.clicks;
  double energy = 0;
  for (const DrillingSegment& s : machine.drilling)
    for (std::size_t i = s.first; i < s.last; ++i)
      energy += s.result.clicks.beta[i] * s.result.clicks.beta[i] * envelope_energy(s.result.clicks.envelope);
  return {kAnalysisRate / clicks.mean_gap_samples, clicks.P.size(),
          10 * std::log10(energy / static_cast<double>(length))};
}

ChainResult together(const std::vector<SegmentedResult>& machines) {
  ChainResult all = machines.front().joined;
  std::vector<std::array<double, 3>> clicks;  // onset, amplitude, machine
  for (std::size_t m = 0; m < machines.size(); ++m) {
    const ChainResult& joined = machines[m].joined;
    all.drilling_found = all.drilling_found || joined.drilling_found;
    for (std::size_t i = 0; i < joined.clicks.P.size(); ++i)
      clicks.push_back(
          {static_cast<double>(joined.clicks.P[i]), joined.clicks.beta[i], static_cast<double>(m + 1)});
    for (std::size_t w = 0; w < all.verdict.size(); ++w)
      all.verdict[w].probability = std::max(all.verdict[w].probability, joined.verdict[w].probability);
  }
  std::sort(clicks.begin(), clicks.end());
  all.clicks.P.clear(), all.clicks.beta.clear();
  for (const auto& [onset, amplitude, machine] : clicks) {
    all.clicks.P.push_back(static_cast<int>(onset));
    all.clicks.beta.push_back(amplitude);
    all.struck_by.push_back(static_cast<int>(machine));
  }
  return all;
}

std::string machines_text(const std::vector<Machine>& machines) {
  if (machines.size() < 2) return {};
  std::string text;
  for (std::size_t k = 0; k < machines.size(); ++k)
    text += fmt::format("{}machine {}: {:.1f} Hz, {} clicks", k == 0 ? "" : "; ", k + 1, machines[k].rate_hz,
                        machines[k].clicks);
  return text;
}

}  // namespace rigsound::analysis
