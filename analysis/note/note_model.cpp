#include "rigsound/analysis/note_model.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "diesel/angle_domain.hpp"
#include "diesel/hbwt.hpp"
#include "note/elementary_waveforms.hpp"
#include "note/harmonic_error.hpp"
#include "note/noise_field.hpp"
#include "note/note_pitch.hpp"
#include "note/subband_noise.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/dsp/wavelet.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kScales = 4, kScalesKept = 3;
constexpr int kEnergyWindow = 20;  // coefficients (section 5)
constexpr int kFirstOrder = 10;    // of the AR filters, in the second subband (section 5)
// What the subbands of independent energies have beside them. An overblown pipe sounds at halves or thirds of
// its note too: a line far from the harmonics, two poles. Loudness wanders slower than the scaling band: one.
constexpr int kOverblownOrder = 2, kSlowOrder = 1;
constexpr double kHighestHarmonic_hz = 10000;
constexpr double kBandwidth = 0.92;
constexpr int kTrials = 6;
constexpr double kLeastGain = 1e-3;

/// Rows of one scale whose filters see nothing but frames first ... last - 1.
struct RowRange {
  int from = 0, to = 0;
  int count() const { return std::max(0, to - from); }
};

RowRange steady_rows(int scale, int first, int last) {
  const int hop = 1 << scale, reach = (dsp::kDb4Taps - 1) * (hop - 1);
  return {(first + hop - 1) / hop, (last - reach) / hop};
}

/// What the variances of the first three subbands are multiplied by, per channel.
struct VarianceGains {
  explicit VarianceGains(int P) : of(3, std::vector<double>(static_cast<std::size_t>(P), 1.0)) {}
  double at(int n, std::size_t q) const { return n <= 3 ? of[static_cast<std::size_t>(n - 1)][q] : 1; }

  std::vector<std::vector<double>> of;
};

class NoteSynthesis {
 public:
  NoteSynthesis(const NoteSettings& settings, const VarianceGains& gains, HbwtCoefficients<double> c,
                int first, int last)
      : settings_(settings),
        gains_(gains),
        c_(std::move(c)),
        first_(first),
        last_(last),
        chance_(settings.seed) {}

  /// Puts noise where the note is steady and counts what the noise was made of.
  void replace() {
    const auto P = static_cast<std::size_t>(c_.shape.P);
    if (drawn_together()) field_ = noise_field(c_.shape, c_.length, spectra(), chance_);
    for (std::size_t q = 0; q < P; ++q) replace_channel(q);
    if (settings_.one_over_f) parameters_ += 2 * P;
  }
  void silence_first_subband() {
    const RowRange rows = steady_rows(1, first_, last_);
    const auto P = static_cast<std::size_t>(c_.shape.P);
    for (int i = rows.from; i < rows.to; ++i)
      std::fill_n(c_.d[0].begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(i) * P), P, 0.0);
  }
  /// The first subband of the steady part alone.
  std::vector<double> first_subband() const {
    HbwtCoefficients<double> only = c_;
    for (auto& d : only.d) std::fill(d.begin(), d.end(), 0.0);
    std::fill(only.a.begin(), only.a.end(), 0.0);
    const RowRange rows = steady_rows(1, first_, last_);
    const int P = c_.shape.P;
    std::copy(c_.d[0].begin() + rows.from * P, c_.d[0].begin() + rows.to * P,
              only.d[0].begin() + rows.from * P);
    return inverse_hbwt(only);
  }
  std::vector<double> sound() const { return inverse_hbwt(c_); }
  std::size_t parameters() const { return parameters_; }

 private:
  Subband read(const std::vector<double>& rows, const RowRange& range, std::size_t q) const {
    Subband d;
    for (int i = range.from; i < range.to; ++i)
      d.push_back(rows[static_cast<std::size_t>(i * c_.shape.P) + q]);
    return d;
  }
  void write(std::vector<double>& rows, const RowRange& range, std::size_t q, const Subband& d, double mean) {
    for (int i = range.from; i < range.to; ++i)
      rows[static_cast<std::size_t>(i * c_.shape.P) + q] = mean + d[i - range.from];
  }

  /// Beside harmonics that stay as they were nothing strong is drawn that could spill over.
  bool drawn_together() const { return !settings_.one_over_f && !settings_.keep_harmonics; }
  int order_of(int n) const {
    if (n >= 2) return settings_.colour ? std::max(0, kFirstOrder - 2 * (n - 2)) : 0;
    return drawn_together() ? kOverblownOrder : 0;
  }
  Subband detail(int n, std::size_t q) const { return read(c_.d[n - 1], steady_rows(n, first_, last_), q); }
  /// The scaling coefficients without their mean.
  Subband slow_part(std::size_t q, double& mean) const {
    Subband slow = read(c_.a, steady_rows(c_.shape.N, first_, last_), q);
    mean = take_mean(slow);
    return slow;
  }

  /// Of what is replaced by noise.
  FieldSpectra spectra() const {
    const int N = c_.shape.N;
    FieldSpectra wanted(static_cast<std::size_t>(N + 1),
                        std::vector<SubbandSpectrum>(static_cast<std::size_t>(c_.shape.P)));
    for (std::size_t q = 0; q < static_cast<std::size_t>(c_.shape.P); ++q) {
      for (int n = settings_.waveforms > 0 ? 2 : 1; n <= N; ++n) {
        const Subband d = detail(n, q);
        wanted[n - 1][q] = subband_spectrum(d, power_of(d) * gains_.at(n, q), order_of(n));
      }
      double mean = 0;
      const Subband slow = slow_part(q, mean);
      wanted[N][q] = subband_spectrum(slow, power_of(slow), kSlowOrder);
    }
    return wanted;
  }

  void replace_channel(std::size_t q) {
    const int N = c_.shape.N;
    double mean = 0;
    const Subband slow = slow_part(q, mean);
    std::vector<Subband> details;
    std::vector<double> variance;
    for (int n = 1; n <= N; ++n) {
      details.push_back(detail(n, q));
      variance.push_back(power_of(details.back()));
    }
    const OneOverF law = settings_.one_over_f ? fit_one_over_f(variance) : OneOverF{};
    for (int n = settings_.waveforms > 0 ? 2 : 1; n <= N; ++n) {
      const auto i = static_cast<std::size_t>(n - 1);
      const RowRange rows = steady_rows(n, first_, last_);
      const NoiseShape shape{settings_.one_over_f ? law.variance(n) : variance[i] * gains_.at(n, q),
                             order_of(n), settings_.time_varying ? kEnergyWindow : 0};
      write(c_.d[i], rows, q,
            drawn_together() ? with_energy_of(details[i], read(field_.d[i], rows, q), shape.window)
                             : noise_like(details[i], shape, chance_),
            0);
      count(details[i].size(), shape);
    }
    if (settings_.keep_harmonics) {
      parameters_ += slow.size();
      return;
    }
    const RowRange scaling = steady_rows(N, first_, last_);
    write(c_.a, scaling, q,
          settings_.one_over_f ? noise_like(slow, {law.variance(N + 1), 0, 0}, chance_)
                               : as_strong_as(slow, read(field_.a, scaling, q)),
          mean);
    parameters_ += settings_.one_over_f ? 1 : 2 + kSlowOrder;
  }

  void count(std::size_t coefficients, const NoiseShape& shape) {
    parameters_ += (settings_.one_over_f ? 0 : 1) + static_cast<std::size_t>(shape.order);
    if (shape.window > 0) parameters_ += coefficients / static_cast<std::size_t>(shape.window);
  }

  NoteSettings settings_;
  const VarianceGains& gains_;
  HbwtCoefficients<double> c_, field_;
  int first_, last_;
  std::mt19937_64 chance_;
  std::size_t parameters_ = 0;
};

int channels_for(double f0) {
  int P = 16;
  while (P * f0 < kBandwidth * kAnalysisRate) P *= 2;
  return P;
}

std::vector<float> back_in_time(const std::vector<double>& y, const NotePitch& pitch, double origin, int P) {
  std::vector<double> at;
  for (const double theta : pitch.theta) at.push_back((theta - origin) * P);
  const std::vector<double> x = interpolated(y, at);
  return {x.begin(), x.end()};
}

/// The note over the phase of its fundamental: P samples a period from `origin` on.
struct AngleNote {
  double origin = 0;
  std::vector<double> y;
};

AngleNote over_phase(const std::vector<double>& x, const NotePitch& pitch, int P) {
  AngleNote note;
  note.origin = std::ceil(pitch.theta.front());
  const auto count = static_cast<std::size_t>((pitch.theta.back() - note.origin) * P);
  Sinc sinc;
  sinc.bandwidth *= std::min(1.0, P * pitch.f0 / kAnalysisRate);
  note.y = interpolated(x, samples_at_angles(pitch.theta, note.origin, P, count), sinc);
  return note;
}

/// What is modelled of a note: frames first ... last - 1, and the samples that all scales reproduce.
struct SteadyPart {
  int first = 0, last = 0;
  std::size_t from = 0, to = 0;
};

SteadyPart steady_part(const std::string& source, const NotePitch& pitch, double origin, int P, int N) {
  SteadyPart part;
  // Frame r covers the periods r - 1 and r.
  part.first = static_cast<int>(std::ceil(pitch.theta[pitch.from] - origin)) + 1;
  part.last = static_cast<int>(std::floor(pitch.theta[pitch.to - 1] - origin));
  const RowRange coarsest = steady_rows(N, part.first, part.last);
  if (coarsest.count() < 2)
    throw InputError(source, "is steady for too few periods, expected " + std::to_string(10 << N));
  part.from = static_cast<std::size_t>(coarsest.from << N) * static_cast<std::size_t>(P);
  part.to = static_cast<std::size_t>(coarsest.to << N) * static_cast<std::size_t>(P);
  return part;
}

/// The note with its steady part resynthesised; counts the parameters of that part.
std::vector<double> synthesised(const AngleNote& note, const SteadyPart& part, int P,
                                const NoteSettings& settings, const VarianceGains& gains,
                                std::size_t& parameters) {
  NoteSynthesis synthesis(settings, gains, hbwt(note.y, {P, 1, settings.N}), part.first, part.last);
  const std::vector<double> first_subband =
      settings.waveforms > 0 ? synthesis.first_subband() : std::vector<double>();
  synthesis.replace();
  if (settings.waveforms > 0) synthesis.silence_first_subband();
  std::vector<double> sound = synthesis.sound();
  parameters = synthesis.parameters();
  if (settings.waveforms > 0) {
    const ElementaryWaveforms waveforms(first_subband, part.from, part.to, P, settings.waveforms);
    waveforms.play(settings.seed, sound);
    parameters += waveforms.parameters();
  }
  return sound;
}

std::vector<double> steady_samples(const std::vector<double>& x, const SteadyPart& part) {
  return {x.begin() + static_cast<std::ptrdiff_t>(part.from),
          x.begin() + static_cast<std::ptrdiff_t>(part.to)};
}

/// The transform finds more power in a weak subband than the note has there: what db4 and the channels let
/// through from strong ones. The gains take trial syntheses to the note's energies.
VarianceGains calibrated_gains(const AngleNote& note, const SteadyPart& part, int P,
                               const NoteSettings& settings) {
  VarianceGains gains(P);
  if (settings.one_over_f) return gains;  // a law has no variance of its own for each subband
  const SubbandEnergies wanted = subband_energies(steady_samples(note.y, part), P);
  NoteSettings trial = settings;
  for (int i = 0; i < kTrials; ++i) {
    ++trial.seed;
    std::size_t parameters = 0;
    const SubbandEnergies made =
        subband_energies(steady_samples(synthesised(note, part, P, trial, gains, parameters), part), P);
    for (std::size_t n = 0; n < wanted.size(); ++n)
      for (std::size_t q = 0; q < wanted[n].size(); ++q)
        gains.of[n][q] = std::max(kLeastGain, gains.of[n][q] * wanted[n][q] / made[n][q]);
  }
  return gains;
}

/// Sizes of the model, and its spectrum error over the steady part.
void set_figures(const std::vector<double>& sound, const std::vector<double>& y, const SteadyPart& part,
                 NoteModel& model) {
  const std::size_t modelled = part.to - part.from;
  const auto parameters = static_cast<double>(model.parameters);
  model.periods = static_cast<int>(modelled / static_cast<std::size_t>(model.P));
  model.ratio = static_cast<double>(modelled) / parameters;
  model.whole_ratio = static_cast<double>(y.size()) / (parameters + static_cast<double>(y.size() - modelled));
  const HarmonicError error =
      harmonic_error(steady_samples(sound, part), steady_samples(y, part), model.P,
                     std::min(model.P / 2 - 1, static_cast<int>(kHighestHarmonic_hz / model.f0)));
  model.at_db = error.at_db, model.near_db = error.near_db, model.between_db = error.between_db;
}

}  // namespace

NoteModel model_note(const std::string& source, const std::vector<float>& mono, const NoteSettings& wanted) {
  NoteSettings settings = wanted;
  if (settings.N == 0) settings.N = settings.keep_harmonics ? kScalesKept : kScales;
  const std::vector<double> x(mono.begin(), mono.end());
  const NotePitch pitch = pitch_of(source, x);
  NoteModel model;
  model.f0 = pitch.f0;
  model.P = channels_for(pitch.f0);
  model.steady_from_s = static_cast<double>(pitch.from) / kAnalysisRate;
  model.steady_to_s = static_cast<double>(pitch.to) / kAnalysisRate;

  const AngleNote note = over_phase(x, pitch, model.P);
  const SteadyPart part = steady_part(source, pitch, note.origin, model.P, settings.N);
  const VarianceGains gains = calibrated_gains(note, part, model.P, settings);
  const std::vector<double> sound = synthesised(note, part, model.P, settings, gains, model.parameters);
  set_figures(sound, note.y, part, model);
  model.sound = back_in_time(sound, pitch, note.origin, model.P);
  return model;
}

}  // namespace rigsound::analysis
