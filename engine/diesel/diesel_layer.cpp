#include "diesel/diesel_layer.hpp"

#include <algorithm>

#include "diesel/angle_reader.hpp"
#include "diesel/crank.hpp"
#include "diesel/high_layer.hpp"
#include "diesel/hydraulic_voice.hpp"
#include "diesel/low_layer.hpp"
#include "diesel/start_stop.hpp"
#include "rigsound/dsp/butterworth.hpp"
#include "rigsound/dsp/linear_prediction.hpp"
#include "rigsound/machine/signal.hpp"

namespace rigsound::diesel {
namespace {

constexpr int kMaxSpan = 512;  // angle samples a chunk reaches over at 4000 r/min and 32 kHz
constexpr double kLowest_rpm = 1;

const DieselModel& checked(const DieselModel& model) {
  require_valid(model);
  return model;
}

bool one_load(const DieselModel& model) {
  return std::all_of(model.points.begin(), model.points.end(),
                     [&](const DieselPoint& p) { return p.load == model.points.front().load; });
}

}  // namespace

class DieselLayer::Voice {
 public:
  Voice(DieselModel model, double sample_rate, std::uint64_t seed, double idle_rpm)
      : machine_(std::make_shared<const Machine>(std::move(model), sample_rate)),
        sample_rate_(sample_rate),
        load_slope_db_(one_load(machine_->model) ? machine_->model.load_slope_db : 0.0),
        high_(machine_->model, sample_rate, seed),
        low_(machine_->model, seed),
        body_(dsp::all_pole_at_rate({machine_->model.body_filter.begin(), machine_->model.body_filter.end()},
                                    machine_->model.sample_rate, sample_rate)),
        crossover_(machine_->model.crossover_hz, sample_rate),
        tones_(machine_->model.oscillators, sample_rate, seed, 46),
        hydraulic_(machine_->model, sample_rate, seed),
        start_stop_(machine_->model, sample_rate, idle_rpm) {}

  bool process(const DieselInput& input, double* out) noexcept;
  void reset() noexcept;

 private:
  /// What a voice and its copies only read: megabytes that no beginning anew shall copy.
  struct Machine {
    Machine(DieselModel m, double sample_rate) : model(std::move(m)), grid(checked(model), sample_rate) {}

    DieselModel model;
    OperatingGrid grid;
    AngleReader reader;
  };

  void set_speed(double rpm) noexcept;
  void run(double* out) noexcept;
  void table_segment(const AngleSpan& span, int count, float* out) noexcept;

  std::shared_ptr<const Machine> machine_;
  double sample_rate_, load_slope_db_;
  HighLayer high_;
  LowLayer low_;
  dsp::AllPole body_;
  dsp::Crossover6 crossover_;
  ToneBank tones_;
  HydraulicVoice hydraulic_;
  StartStop start_stop_;
  Crank crank_;
  OperatingPoint at_;
  GridPlace before_;
  dsp::Ramp rpm_, load_gain_{1, 1};
  AngleSpan fine_, coarse_;
};

/// No flywheel jumps, whatever a state says, and an extrapolated speed stays in the signal's range.
void DieselLayer::Voice::set_speed(double rpm) noexcept {
  const double step = static_cast<double>(kMaxSpeedSlope) * kChunk / sample_rate_;
  const double wanted = std::min(rpm, info(Signal::kEngineRpm).max);
  rpm_.go_to(std::clamp(wanted, rpm_.to - step, rpm_.to + step));
  if (rpm == 0 && rpm_.to < kLowest_rpm) rpm_.to = 0;
}

void DieselLayer::Voice::table_segment(const AngleSpan& span, int count, float* out) noexcept {
  const auto mixed = [&](const GridPlace& place, float* y) {
    const int N = machine_->model.angle_samples;
    int from = static_cast<int>((span.base + AngleReader::kFirst + N) % N), done = 0;
    while (done < count) {
      const int run = std::min(count - done, N - from);
      machine_->grid.table(place, from, run, y + done);
      done += run, from = 0;
    }
  };
  mixed(at_.place, out);
  if (before_.index == at_.place.index && before_.weight == at_.place.weight) return;
  // From the place of the last chunk to this one sample by sample: a change at once would buzz.
  std::array<float, kMaxSpan> old;
  mixed(before_, old.data());
  const float step = 1 / static_cast<float>(count);
  for (int i = 0; i < count; ++i) {
    const float from = old[static_cast<std::size_t>(i)];
    out[i] = from + (out[i] - from) * (static_cast<float>(i + 1) * step);
  }
}

void DieselLayer::Voice::run(double* out) noexcept {
  crank_.turn(cycles_per_second(rpm_.from), cycles_per_second(rpm_.to), sample_rate_);
  crank_.span(machine_->model.angle_samples, fine_);
  crank_.span(machine_->model.low_channels, coarse_);
  const int fine_count = fine_.count + AngleReader::kTaps, coarse_count = coarse_.count + AngleReader::kTaps;
  high_.produce(fine_.base + AngleReader::kFirst + fine_count, machine_->grid, at_);
  low_.produce(coarse_.base + AngleReader::kFirst + coarse_count, machine_->grid, at_.place);

  std::array<float, kMaxSpan> table, high, low;
  table_segment(fine_, fine_count, table.data());
  high_.ring().read(fine_.base + AngleReader::kFirst, fine_count, high.data());
  low_.ring().read(coarse_.base + AngleReader::kFirst, coarse_count, low.data());

  const AngleReader& reader = machine_->reader;
  std::array<float, kChunk> rough, soft;
  for (std::size_t n = 0; n < kChunk; ++n) {
    const AngleReader::Weights fine = reader.weights(fine_.fraction[n]);
    const dsp::FloatLanes read =
        dsp::totals(AngleReader::read(fine, table.data() + fine_.offset[n]),
                    AngleReader::read(fine, high.data() + fine_.offset[n]),
                    AngleReader::read(reader.weights(coarse_.fraction[n]), low.data() + coarse_.offset[n]),
                    dsp::FloatLanes{});
    out[n] = static_cast<double>(read[0]);
    rough[n] = read[1];
    soft[n] = read[2];
  }
  body_.process(rough.data(), kChunk);
  crossover_.add(soft.data(), rough.data(), out, kChunk);
}

bool DieselLayer::Voice::process(const DieselInput& input, double* out) noexcept {
  set_speed(input.rpm);
  start_stop_.advance(rpm_.to);
  if (start_stop_.silent()) return std::fill(out, out + kChunk, 0.0), false;

  const double rpm = 0.5 * (rpm_.from + rpm_.to);
  before_ = at_.place;
  at_ = {machine_->grid.place(rpm, input.load), rpm, input.load};
  run(out);
  tones_.add(cycles_per_second(rpm), {1, 1}, out);
  load_gain_.go_to(load_slope_db_ == 0 ? 1.0
                                       : dsp::gain_of_db(load_slope_db_ *
                                                         (input.load - machine_->model.points.front().load)));
  if (!start_stop_.gain().rests_at(1)) dsp::scale(start_stop_.gain(), out, kChunk);
  if (!load_gain_.rests_at(1)) dsp::scale(load_gain_, out, kChunk);
  hydraulic_.add(cycles_per_second(rpm), input.feed, start_stop_.gain().to, out);
  start_stop_.add_to(out);
  return true;
}

void DieselLayer::Voice::reset() noexcept {
  high_.reset();
  low_.reset();
  body_.reset();
  crossover_.reset();
  hydraulic_.reset();
}

DieselLayer::DieselLayer(const std::vector<DieselModel>& models, double sample_rate, std::uint64_t seed,
                         double idle_rpm) {
  if (!models.empty()) voice_ = std::make_unique<Voice>(models.front(), sample_rate, seed, idle_rpm);
}
DieselLayer::~DieselLayer() = default;
DieselLayer::DieselLayer(const DieselLayer& other)
    : voice_(other.voice_ ? std::make_unique<Voice>(*other.voice_) : nullptr) {}
DieselLayer::DieselLayer(DieselLayer&&) noexcept = default;
DieselLayer& DieselLayer::operator=(const DieselLayer& other) noexcept {
  if (voice_ && other.voice_ && this != &other) *voice_ = *other.voice_;
  return *this;
}

bool DieselLayer::process(const DieselInput& input, double* out) noexcept {
  if (voice_) return voice_->process(input, out);
  std::fill(out, out + kChunk, 0.0);
  return false;
}

void DieselLayer::reset() noexcept {
  if (voice_) voice_->reset();
}

}  // namespace rigsound::diesel
