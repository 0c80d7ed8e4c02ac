// What is no sound stays out of the mix, is counted, and its layer comes back.
#include "mix/layer_meter.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "drill/tilt_filter.hpp"
#include "rigsound/dsp/biquad.hpp"
#include "rigsound/dsp/ramp.hpp"

using namespace rigsound;

namespace {

/// A recursive filter that one bad sample has got into.
struct FailingLayer {
  dsp::Biquad filter{{1, 0, 0, -0.5, 0}};

  void process(double input, mix::Bus& bus) {
    for (double& x : bus.x) x = 0.25;
    bus.x[3] = input;
    filter.process(bus.x, kChunk);
    bus.sounds = true;
  }
  void reset() noexcept { filter.reset(); }
};

double constant_through(dsp::Biquad& filter, double x) {
  double y = 0;
  for (int n = 0; n < 2000; ++n) {
    y = filter.process(x);
    if (n % kChunk == 0) filter.settle();
  }
  return y;
}

}  // namespace

TEST_CASE("a layer that makes what is no sound is left out of that chunk, counted, and plays the next") {
  for (const double bad : {double(NAN), double(INFINITY), -double(INFINITY), 1e40}) {
    CAPTURE(bad);
    FailingLayer layer;
    mix::LayerMeter meter;
    mix::Bus bus;
    layer.process(0.25, bus), meter.admit(layer, bus);
    CHECK(bus.sounds);
    CHECK(meter.take_dropped() == 0);
    layer.process(bad, bus), meter.admit(layer, bus);
    CHECK_FALSE(bus.sounds);
    layer.process(0.25, bus), meter.admit(layer, bus);
    CHECK(bus.sounds);
    CHECK(bus.x[kChunk - 1] == doctest::Approx(0.5));
    CHECK(meter.take_dropped() == 1);
    CHECK(meter.take_dropped() == 0);
    CHECK(meter.take(1, 3 * kChunk).peak == doctest::Approx(0.5));
  }
}

TEST_CASE("filters heal from what is no number") {
  for (const double bad : {double(NAN), double(INFINITY), 1e300}) {
    CAPTURE(bad);
    dsp::Biquad bell(dsp::peaking(1000, 6, 0.7, 48000));
    bell.process(bad);
    CHECK(constant_through(bell, 0.25) == doctest::Approx(0.25));

    drill::TiltFilter tilt(48000);
    double x[kChunk];
    std::fill(x, x + kChunk, bad);
    tilt.process(3, x);
    for (int chunk = 0; chunk < 100; ++chunk) {
      std::fill(x, x + kChunk, 0.25);
      tilt.process(3, x);
    }
    CHECK(x[kChunk - 1] == doctest::Approx(0.25).epsilon(1e-3));
  }
  CHECK(dsp::approached(NAN, 0.5, 0.9) == 0.5);
  CHECK(dsp::approached(INFINITY, 0.5, 0.9) == 0.5);
  CHECK(dsp::approached(1, 0.5, 0.5) == 0.75);
}
