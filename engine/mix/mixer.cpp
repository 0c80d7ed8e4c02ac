#include "mix/mixer.hpp"

#include <algorithm>

#include "rigsound/dsp/elementary.hpp"
#include "rigsound/dsp/passes.hpp"

namespace rigsound::mix {
namespace {

/// Equal-power pan law: -3 dB each in the middle. The only channel takes all.
dsp::Lanes gains(double db, double pan, int channels) {
  const double gain = dsp::gain_of_db(db), angle = (pan + 1) * dsp::kPi / 4;
  return channels == 1 ? dsp::Lanes{gain, 0} : dsp::Lanes{gain * dsp::cos(angle), gain * dsp::sin(angle)};
}

std::optional<LookaheadLimiter> limiter_of(const EngineOptions& options) {
  if (lookahead_frames(options) == 0) return {};
  return LookaheadLimiter(dsp::gain_of_db(options.mix.ceiling_dbfs), lookahead_frames(options) / kChunk,
                          options.sample_rate);
}

/// What sounds of all buses, in the order in which it is added.
struct Sounding {
  void take(const Bus& bus, dsp::Lanes gain) noexcept {
    if (bus.sounds) placed[count++] = {bus.x, gain};
  }

  dsp::Placed placed[1 + 2 * kMaxBooms];
  int count = 0;
};

}  // namespace

Mixer::Mixer(const EngineOptions& options)
    : booms_(static_cast<int>(options.booms.size())),
      diesel_(gains(options.mix.diesel_db, 0, options.channels)),
      ahead_(limiter_of(options)),
      limiter_(dsp::gain_of_db(options.mix.ceiling_dbfs), options.sample_rate),
      output_(dsp::gain_of_db(options.mix.ceiling_dbfs), options.channels) {
  for (std::size_t b = 0; b < options.booms.size(); ++b) {
    const BoomOptions& boom = options.booms[b];
    drill_[b] = gains(options.mix.drill_db + boom.gain_db, boom.pan, options.channels);
    tool_[b] = gains(options.mix.tool_db + boom.gain_db, boom.pan, options.channels);
  }
  for (const EqualiserBand& band : options.mix.equaliser)
    equaliser_.emplace_back(dsp::peaking(band.frequency_hz, band.gain_db, band.q, options.sample_rate));
}

bool Mixer::place(const Buses& buses, dsp::Lanes* x) const noexcept {
  Sounding sounding;
  sounding.take(buses.diesel, diesel_);
  for (std::size_t b = 0; b < static_cast<std::size_t>(booms_); ++b) {
    sounding.take(buses.drill[b], drill_[b]);
    sounding.take(buses.tool[b], tool_[b]);
  }
  if (sounding.count == 0) return false;
  const dsp::Placed* const p = sounding.placed;
  dsp::with_widest<dsp::Passes>([&](auto passes) {
    if (sounding.count == 1) return passes.place(p[0], kChunk, x);
    passes.place(p[0], p[1], kChunk, x);
    for (int bus = 2; bus < sounding.count; ++bus) passes.add_placed(p[bus], kChunk, x);
  });
  return true;
}

/// A chunk with which a band rings beyond all bounds is dropped, and all bands begin again.
bool Mixer::equalise(bool sounds, dsp::Lanes* x) noexcept {
  for (dsp::BiquadPair& band : equaliser_) {
    if (!sounds && band.rests()) continue;
    if (!sounds) std::fill_n(x, kChunk, dsp::Lanes{});
    band.process(x, kChunk);
    sounds = band.settle();
    if (sounds) continue;
    for (dsp::BiquadPair& each : equaliser_) each.reset();
    ++dropped_;
    return false;
  }
  return sounds;
}

bool Mixer::mix(const Buses& buses, const dsp::Ramp& gain, dsp::Lanes* x) noexcept {
  const bool sounds = equalise(place(buses, x), x);
  if (!sounds || gain.rests_at(0)) return false;
  if (!gain.rests_at(1)) dsp::scale(gain, x, kChunk);
  return true;
}

void Mixer::process(const Buses& buses, const dsp::Ramp& gain, float* out) noexcept {
  const dsp::Lanes* due = x_;
  GainCurve curve;
  if (ahead_) {
    due = ahead_->process(mix(buses, gain, ahead_->input()));
    curve = ahead_->gain();
  } else {
    if (!mix(buses, gain, x_)) std::fill_n(x_, kChunk, dsp::Lanes{});
    limiter_.process(x_);
  }
  if (due != nullptr)
    output_.write(due, curve, out);
  else
    output_.write_silence(out);
}

double Mixer::lowest_gain() const noexcept {
  return ahead_ ? ahead_->gain().lowest() : limiter_.lowest_gain();
}

}  // namespace rigsound::mix
