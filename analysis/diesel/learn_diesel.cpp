#include <algorithm>
#include <cmath>
#include <utility>

#include "diesel/angle_domain.hpp"
#include "diesel/body_filter.hpp"
#include "diesel/body_fit.hpp"
#include "diesel/free_lines.hpp"
#include "diesel/low_analysis.hpp"
#include "diesel/order_analysis.hpp"
#include "diesel/phase_advance.hpp"
#include "diesel/section.hpp"
#include "diesel/slot_analysis.hpp"
#include "rigsound/analysis/diesel.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/default_diesel.hpp"
#include "rigsound/dsp/butterworth.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kHighestLearned_hz = 11000;
constexpr double kSlot_s = 0.0022;
constexpr double kBelowCrossover = 0.7;   // high-pass of the analysis; the voice has its own at f_x
constexpr int kWindowCycles = 8;          // of a run-up, for the body
constexpr double kSure = 3;               // times the noise, for a level that shapes the body
constexpr double kHidden = 0.04;          // of its power is kept of an order that may be noise
constexpr double kFormulaRms = 0.05;      // level the built-in hydraulics go with
constexpr std::size_t kAtOnce = 1 << 18;  // samples: positions of all would take as much memory as the sound

int power_of_two_from(double least, int low, int high) {
  int n = low;
  while (n < high && n < least) n *= 2;
  return n;
}

/// A section on its way through the analysis.
struct Work {
  const Section* section = nullptr;
  double origin = 0;
  CycleBlock block;  // its samples are there while the orders are looked for
  Orders orders;
  std::vector<double> residual, high;  // per sample of the section
  DieselPoint point;

  void leave_block() { block.y = std::vector<double>(), block.open = std::vector<char>(); }
};

/// Two poles for every 375 Hz that were recorded, a multiple of the voice's eight lanes; 96 are what a block
/// has time for.
int body_order(const std::vector<Section>& sections) {
  double nyquist = 0;
  for (const Section& s : sections) nyquist = std::max(nyquist, s.nyquist_hz);
  return std::clamp(8 * static_cast<int>(std::lround(nyquist / 1500)), 32, 96);
}

int last_order(const Section& s, int N_theta) {
  const double highest = std::min(kHighestLearned_hz, 0.95 * s.nyquist_hz);
  return std::min(static_cast<int>(highest / s.f0()), N_theta / 2 - 1);
}

void set_shape(const std::vector<Section>& sections, const DieselSettings& settings, DieselModel& model) {
  double slowest = 1e9, log_sum = 0, nyquist = 0;
  int fewest = 1 << 20;
  for (const Section& s : sections) {
    slowest = std::min(slowest, s.f0());
    log_sum += std::log(s.f0());
    nyquist = std::max(nyquist, s.nyquist_hz);
    fewest = std::min(fewest, static_cast<int>(s.theta.back() - s.theta.front()));
  }
  const double nominal = std::exp(log_sum / static_cast<double>(sections.size()));
  model.name = settings.name;
  model.sample_rate = kAnalysisRate;
  // Grains bring the modulation of the cycle down to where they begin. Slots need the wavelets longer:
  // neither their channels nor 1/A are narrow enough for the valleys between the lowest resonances of a body.
  // What lies under the crossover is resolved to half an order, but no longer modulated within the cycle.
  model.crossover_hz = settings.crossover_hz > 0 ? settings.crossover_hz : settings.grains > 0 ? 200 : 450;
  model.angle_samples = power_of_two_from(2 * nyquist / slowest, 1024, kMaxCrankAngle);
  model.low_channels = power_of_two_from(2.6 * model.crossover_hz / slowest, 64, 1024);
  const int L = 1 << std::lround(std::log2(1 / (nominal * kSlot_s)));
  model.slots =
      std::clamp(L, std::max(16, model.angle_samples / 128), std::min(256, model.angle_samples / 16));
  model.low_scales = std::clamp(static_cast<int>(std::floor(std::log2(fewest / 10.0))), 0, 3);
}

/// Turns every take to the crank angle of the first: its section nearest in speed decides.
std::vector<double> crank_origins(const std::vector<Work>& work) {
  const int takes = work.back().section->take + 1;
  std::vector<double> origin(static_cast<std::size_t>(takes), 0.0);
  for (int take = 1; take < takes; ++take) {
    double nearest = 1e9;
    for (const Work& a : work)
      for (const Work& b : work) {
        if (a.section->take >= take || b.section->take != take) continue;
        const double distance = std::fabs(std::log(a.section->f0() / b.section->f0()));
        if (distance >= nearest) continue;
        nearest = distance;
        origin[take] = origin[a.section->take] + crank_shift(a.orders, b.orders);
      }
  }
  for (double& o : origin) o -= std::floor(o);
  return origin;
}

/// The residual of the mean cycle, over time: `sound` is that of the section.
void subtract_orders(Work& work, std::vector<double> sound) {
  const std::vector<double>& theta = work.section->theta;
  const std::vector<double> cycle = mean_cycle(work.block, 0, work.block.cycles);
  std::vector<double> wrapped(cycle.end() - 32, cycle.end()), at;
  wrapped.insert(wrapped.end(), cycle.begin(), cycle.end());
  wrapped.insert(wrapped.end(), cycle.begin(), cycle.begin() + 32);
  for (std::size_t first = 0; first < sound.size(); first += kAtOnce) {
    const std::size_t end = std::min(sound.size(), first + kAtOnce);
    at.clear();
    for (std::size_t n = first; n < end; ++n) {
      const double angle = theta[n] - work.origin;
      at.push_back(32 + (angle - std::floor(angle)) * work.block.N);
    }
    const std::vector<double> repeated = interpolated(wrapped, at, {32, 10, 1});
    for (std::size_t n = first; n < end; ++n) sound[n] -= repeated[n - first];
  }
  work.residual = std::move(sound);
}

/// Lines off the orders become tones of the model: in slots they would be noise.
std::vector<DieselOscillator> subtract_lines(int N_theta, std::vector<Work>& work) {
  std::vector<SectionResidual> residuals;
  for (const Work& w : work) residuals.push_back({w.section, &w.residual});
  std::vector<DieselOscillator> tones;
  for (const FreeLine& line : free_lines(residuals, N_theta)) {
    for (std::size_t i = 0; i < work.size(); ++i)
      work[i].residual = without_line(*work[i].section, std::move(work[i].residual), line.frequency[i],
                                      line.tone.order_locked ? Lock::kCrank : Lock::kTime);
    tones.push_back(line.tone);
  }
  return tones;
}

/// The part of the residual over the crossover.
void split_high(double f_x, Work& work) {
  const Section& s = *work.section;
  if (s.open.empty()) {
    work.high = zero_phase_high_pass(work.residual, kBelowCrossover * f_x, kAnalysisRate);
    return;
  }
  // Only forward: an impact must not ring into the silence before it.
  dsp::Butterworth6 filter(dsp::Pass::kHigh, kBelowCrossover * f_x, kAnalysisRate);
  work.high.reserve(work.residual.size());
  for (const double v : work.residual) work.high.push_back(filter.process(v));
}

/// Orders without the share that noise explains (Wiener's gain). None is removed: an order missing in one
/// point would be missing half the way to the next point.
std::vector<std::complex<float>> sure_orders(const Orders& orders) {
  std::vector<std::complex<float>> C;
  for (std::size_t k = 0; k < orders.C.size(); ++k) {
    const double power = std::norm(orders.C[k]);
    const double gain = std::sqrt(std::max(kHidden, 1 - orders.noise[k] / (power + 1e-300)));
    C.emplace_back(static_cast<std::complex<float>>(gain * orders.C[k]));
  }
  return C;
}

OrderLevels levels_of(const Orders& orders, double f0, double load) {
  OrderLevels levels;
  levels.f0 = f0, levels.group = static_cast<int>(std::lround(load * 100));
  for (std::size_t k = 0; k < orders.C.size(); ++k) {
    const double power = std::norm(orders.C[k]);
    levels.db.push_back(power > kSure * orders.noise[k] ? 10 * std::log10(power - orders.noise[k]) : NAN);
  }
  return levels;
}

void add_moments(const Work& work, int last, std::vector<OrderLevels>& moments) {
  const Section& s = *work.section;
  if (!s.run_up) {
    moments.push_back(levels_of(work.orders, s.f0(), s.load));
    return;
  }
  for (int first = 0; first + kWindowCycles <= work.block.cycles; first += kWindowCycles / 2) {
    const auto at = std::lower_bound(s.theta.begin(), s.theta.end(), work.block.origin + first);
    const auto end =
        std::lower_bound(s.theta.begin(), s.theta.end(), work.block.origin + first + kWindowCycles);
    const double f0 = kWindowCycles * kAnalysisRate / static_cast<double>(end - at);
    moments.push_back(levels_of(orders_of(work.block, first, kWindowCycles, last), f0, s.load));
  }
}

LearnedPoint report_of(const Work& work) {
  const Section& s = *work.section;
  return {s.source,
          rpm_of_cycles(s.f0()),
          s.load,
          static_cast<double>(s.theta.size()) / kAnalysisRate,
          work.block.cycles,
          s.correlation,
          work.orders.synchronous};
}

void learn_noise(const DieselModel& model, int grains, Work& work) {
  const Section& s = *work.section;
  const std::vector<double> A(model.body_filter.begin(), model.body_filter.end());
  const auto white_cycles = [&](const std::vector<double>& high) {
    return cycles_of(s, whitened(high, A), work.origin, model.angle_samples);
  };
  if (grains > 0 && s.open.empty())
    learn_grains(white_cycles(phase_advanced(work.high, model.crossover_hz)), grains, work.point);
  {
    const CycleBlock white = white_cycles(std::exchange(work.high, {}));
    learn_slots(white, model.slots, work.point);
  }
  learn_low_layer(cycles_of(s, work.residual, work.origin, model.angle_samples), model.low_channels,
                  model.low_scales, work.point);
  gate_low_layer(s, work.residual, model.crossover_hz, model.low_channels, work.point);
}

double rms(const std::vector<Section>& sections) {
  double power = 0;
  std::size_t samples = 0;
  for (const Section& s : sections) {
    for (const double v : s.x) power += v * v;
    samples += s.x.size();
  }
  return std::sqrt(power / static_cast<double>(samples));
}

/// The recordings hold a diesel; the pump is the formula's, as loud beside it.
void add_hydraulics(double level, DieselModel& model) {
  model.hydraulic = default_diesel().hydraulic;
  const double gain = level / kFormulaRms;
  for (float& v : model.hydraulic.pump) v *= static_cast<float>(gain);
  model.hydraulic.flow *= gain;
}

}  // namespace

LearnedDiesel learn_diesel(const std::vector<DieselTake>& takes, const DieselSettings& settings,
                           const Progress& progress) {
  constexpr double kTracked =
      0.3;  // of the time, roughly, is the crank's; then come four rounds over the sections
  LearnedDiesel learned;
  DieselModel& model = learned.model;
  std::vector<Section> sections = sections_of(takes, learned.warnings, part_of(progress, 0, kTracked));
  set_shape(sections, settings, model);
  const double level = rms(sections);

  const int order = settings.order > 0 ? settings.order : body_order(sections);
  std::vector<Work> work(sections.size());
  double done = 0;
  const auto step = [&, rest = part_of(progress, kTracked, 1)] {
    if (rest) rest(++done / (4 * static_cast<double>(work.size())));
  };
  for (std::size_t i = 0; i < work.size(); ++i) {
    work[i].section = &sections[i];
    work[i].block = cycles_of(sections[i], sections[i].x, 0, model.angle_samples);
    work[i].orders =
        orders_of(work[i].block, 0, work[i].block.cycles, last_order(sections[i], model.angle_samples));
    work[i].leave_block();
    step();
  }
  const std::vector<double> origins = crank_origins(work);
  std::vector<OrderLevels> moments;
  std::vector<std::vector<double>> autocorrelations;
  for (std::size_t i = 0; i < work.size(); ++i) {
    Work& w = work[i];
    w.origin = origins[w.section->take];
    w.block = cycles_of(*w.section, w.section->x, w.origin, model.angle_samples);
    const int last = last_order(*w.section, model.angle_samples);
    w.orders = orders_of(w.block, 0, w.block.cycles, last);
    add_moments(w, last, moments);
    subtract_orders(w, std::exchange(sections[i].x, {}));
    w.leave_block();
    step();
  }
  model.oscillators = subtract_lines(model.angle_samples, work);
  for (Work& w : work) {
    split_high(model.crossover_hz, w);
    autocorrelations.push_back(body_autocorrelation(w.high, w.section->open, w.section->nyquist_hz, order));
    step();
  }
  model.body = fit_body(moments);
  const std::vector<double> A = common_body(autocorrelations);
  model.body_filter.assign(A.begin(), A.end());

  for (Work& w : work) {
    w.point.source = w.section->source;
    w.point.rpm = rpm_of_cycles(w.section->f0());
    w.point.load = w.section->load;
    w.point.orders = sure_orders(w.orders);
    learn_noise(model, settings.grains, w);
    learned.points.push_back(report_of(w));
    model.points.push_back(std::move(w.point));
    step();
  }
  add_hydraulics(level, model);
  return learned;
}

}  // namespace rigsound::analysis
