// Gains, channels and levels of the mix, against what the options say in dB.
#include "mix/mixer.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "rigsound/dsp/elementary.hpp"

using namespace rigsound;

namespace {

/// Without look-ahead what goes in comes out at once.
EngineOptions immediate(int channels) {
  EngineOptions options;
  options.channels = channels;
  options.mix.lookahead_s = 0;
  options.mix.ceiling_dbfs = 0;
  options.mix.drill_db = -3, options.mix.tool_db = -9, options.mix.diesel_db = -6;
  options.booms = {{"left", -1, 2, -1}, {"right", 1, -4, -1}};
  return options;
}

void fill(mix::Bus& bus, double level) {
  bus.sounds = true;
  for (double& x : bus.x) x = level;
}

/// The last frame of a chunk.
std::vector<double> last_frame(mix::Mixer& mixer, const mix::Buses& buses, int channels,
                               dsp::Ramp gain = {1, 1}) {
  std::vector<float> out(static_cast<std::size_t>(kChunk * channels), 9.0F);
  mixer.process(buses, gain, out.data());
  return {out.end() - channels, out.end()};
}

double linear(double db) { return std::pow(10, db / 20); }

}  // namespace

TEST_CASE("each layer has its own gain and its boom's, and the layers add up") {
  mix::Mixer mixer(immediate(2));
  const double left = 0.01 * linear(-3 + 2) + 0.02 * linear(-9 + 2), right = 0.04 * linear(-3 - 4),
               diesel = 0.08 * linear(-6) * std::sqrt(0.5);
  mix::Buses buses{};
  fill(buses.drill[0], 0.01);
  CHECK(last_frame(mixer, buses, 2)[0] == doctest::Approx(0.01 * linear(-3 + 2)).epsilon(1e-6));
  fill(buses.tool[0], 0.02);
  CHECK(last_frame(mixer, buses, 2)[0] == doctest::Approx(left).epsilon(1e-6));
  fill(buses.drill[1], 0.04);
  fill(buses.diesel, 0.08);
  const std::vector<double> all = last_frame(mixer, buses, 2);
  CHECK(all[0] == doctest::Approx(left + diesel).epsilon(1e-6));
  CHECK(all[1] == doctest::Approx(right + diesel).epsilon(1e-6));
  buses.drill[1].sounds = false;
  CHECK(last_frame(mixer, buses, 2)[1] == doctest::Approx(diesel).epsilon(1e-6));
}

TEST_CASE("the only channel takes all of every layer, more than two get silence") {
  for (const int channels : {1, 2, 3, 8}) {
    CAPTURE(channels);
    mix::Mixer mixer(immediate(channels));
    mix::Buses buses{};
    fill(buses.diesel, 0.1);
    fill(buses.drill[1], 0.2);
    const std::vector<double> frame = last_frame(mixer, buses, channels);
    const double diesel = 0.1 * linear(-6), drill = 0.2 * linear(-3 - 4);
    if (channels == 1) {
      CHECK(frame[0] == doctest::Approx(diesel + drill).epsilon(1e-6));
      continue;
    }
    CHECK(frame[0] == doctest::Approx(diesel * std::sqrt(0.5)).epsilon(1e-6));
    CHECK(frame[1] == doctest::Approx(diesel * std::sqrt(0.5) + drill).epsilon(1e-6));
    for (std::size_t c = 2; c < frame.size(); ++c) CHECK(frame[c] == 0);
  }
}

TEST_CASE(
    "a chunk's ramp of the output level begins one step above where it comes from and ends at its target") {
  mix::Mixer mixer(immediate(1));
  mix::Buses buses{};
  fill(buses.diesel, 0.1);
  float out[kChunk];
  mixer.process(buses, {0.25, 0.75}, out);
  for (int n = 0; n < kChunk; ++n)
    CHECK(double(out[n]) ==
          doctest::Approx(0.1 * linear(-6) * (0.25 + 0.5 * (n + 1) / kChunk)).epsilon(1e-6));
  mixer.process(buses, {0, 0}, out);
  for (const float x : out) CHECK(x == 0);
  mixer.process(buses, {0, 1}, out);
  CHECK(double(out[kChunk - 1]) == doctest::Approx(0.1 * linear(-6)).epsilon(1e-6));
}

TEST_CASE("peak and rms of a block are those of its samples, both channels' power together") {
  EngineOptions options = immediate(2);
  mix::Mixer mixer(options);
  mix::Buses buses{};
  fill(buses.drill[0], 0.1);  // left
  fill(buses.drill[1], 0.4);  // right
  last_frame(mixer, buses, 2);
  buses = {};
  last_frame(mixer, buses, 2);
  const double left = 0.1 * linear(-1), right = 0.4 * linear(-7);
  const LayerLevel level = mixer.take_level(2 * kChunk);
  CHECK(double(level.peak) == doctest::Approx(right).epsilon(1e-6));
  CHECK(double(level.rms) == doctest::Approx(std::sqrt((left * left + right * right) / 2)).epsilon(1e-6));
  CHECK(mixer.take_level(kChunk).peak == 0);
  CHECK(mixer.take_level(kChunk).rms == 0);
}

TEST_CASE("the equaliser's bands follow one another in the mix, ring out after it and then rest") {
  EngineOptions options = immediate(2);
  options.mix.equaliser = {{500, 6, 2}, {500, 3, 2}, {8000, -12, 1}};
  mix::Mixer mixer(options), plain(immediate(2));
  mix::Buses buses{};
  buses.drill[1].sounds = true;
  double in = 0, out = 0;
  for (int chunk = 0; chunk < 600; ++chunk) {
    for (int n = 0; n < kChunk; ++n)
      buses.drill[1].x[n] = 0.05 * std::sin(2 * M_PI * 500 / 48000 * (n + chunk * kChunk));
    const double dry = last_frame(plain, buses, 2)[1], wet = last_frame(mixer, buses, 2)[1];
    if (chunk >= 300) in += dry * dry, out += wet * wet;
  }
  CHECK(10 * std::log10(out / in) == doctest::Approx(9).epsilon(0.01));
  buses = {};
  CHECK(last_frame(mixer, buses, 2)[1] != 0);
  int chunks = 0;
  while (last_frame(mixer, buses, 2)[1] != 0 && chunks < 5000) ++chunks;
  CHECK(chunks < 1000);
  CHECK(mixer.take_dropped() == 0);
}

TEST_CASE("the lowest gain of a chunk is that of the limiter in charge") {
  EngineOptions options = immediate(1);
  options.mix.ceiling_dbfs = -20;
  mix::Buses loud{};
  fill(loud.diesel, 0.8);
  const double wanted = 0.1 / (0.8 * linear(-6));
  mix::Mixer without(options);
  CHECK(without.lowest_gain() == 1);
  last_frame(without, loud, 1);
  CHECK(without.lowest_gain() == doctest::Approx(wanted).epsilon(1e-9));
  options.mix.lookahead_s = 0.002;
  mix::Mixer ahead(options);
  for (int chunk = 0; chunk < 100; ++chunk) {
    const std::vector<double> frame = last_frame(ahead, loud, 1);
    CHECK(frame[0] <= 0.1);
  }
  CHECK(ahead.lowest_gain() == doctest::Approx(wanted).scale(0).epsilon(0.1));
  CHECK(ahead.lowest_gain() < wanted);
}

TEST_CASE("with look-ahead a sound comes out so many chunks later as the options say") {
  for (const double lookahead_s : {0.002, 0.004, 0.02}) {
    EngineOptions options = immediate(2);
    options.mix.lookahead_s = lookahead_s;
    mix::Mixer mixer(options);
    mix::Buses buses{};
    fill(buses.diesel, 0.1);
    int chunks = 0;
    while (last_frame(mixer, buses, 2)[0] == 0 && chunks < 100) ++chunks;
    CHECK(chunks * kChunk == lookahead_frames(options));
    CHECK(chunks == std::max(3.0, std::ceil(lookahead_s * 48000 / kChunk)));
  }
}
