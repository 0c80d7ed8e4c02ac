// What a loop does at a complex frequency, against products of its sections in std::complex.
#include "tool/design/loop_response.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <complex>

using namespace rigsound;
using namespace rigsound::tool;
using Complex = std::complex<double>;

namespace {

Allpass allpass_of(int first_orders) {
  Allpass allpass;
  allpass.sections = 4;
  allpass.section[0] = {0.05, 0.002};
  allpass.section[1] = {0.3, 0.15};
  allpass.section[2] = {0.9, 1.4};
  allpass.section[3] = {2.5, 9};
  allpass.first_orders = first_orders;
  allpass.a = 0.4;
  return allpass;
}

LoopDesign loop_of(int first_orders) {
  LoopDesign loop;
  loop.delay_samples = 37;
  loop.allpass = allpass_of(first_orders);
  loop.filters = {0.0023, 0.4, 0.7};
  return loop;
}

Complex section_product(const Allpass& a, Complex p) {
  Complex h = 1;
  for (std::size_t i = 0; i < static_cast<std::size_t>(a.sections); ++i) {
    const auto [b, c] = a.section[i];
    h *= (p * p - b * p + c) / (p * p + b * p + c);
  }
  return h * std::pow((a.a - p) / (a.a + p), a.first_orders);
}

Complex filter_product(const LoopFilters& f, Complex p) {
  return p / (p + f.dc) * (f.shelf + f.shelf_gain * p) / (f.shelf + p);
}

/// k F A e^(-N s): 1 at a pole.
Complex round_trip(const LoopDesign& loop, double k, Complex s) {
  const Complex p = std::tanh(s / 2.0);
  return k * filter_product(loop.filters, p) * section_product(loop.allpass, p) *
         std::exp(-static_cast<double>(loop.delay_samples) * s);
}

dsp::Complex ours(Complex x) { return {x.real(), x.imag()}; }
Complex theirs(dsp::Complex x) { return {x.re, x.im}; }

}  // namespace

TEST_CASE("the bilinear variable is tanh(s / 2)") {
  for (const Complex s : {Complex(-0.01, 0.3), Complex(0, 1.5), Complex(-0.5, 3)})
    CHECK(std::abs(theirs(bilinear(ours(s))) - std::tanh(s / 2.0)) < 1e-12);
}

TEST_CASE("responses are the products of their sections, on and off the unit circle") {
  for (const int first_orders : {0, 1, 5})
    for (const Complex p :
         {Complex(0, 0.01), Complex(0, 0.7), Complex(-0.02, 0.4), Complex(0.3, -2), Complex(0.1, 8)}) {
      const Allpass allpass = allpass_of(first_orders);
      CHECK(std::abs(theirs(response(allpass, ours(p))) - section_product(allpass, p)) < 1e-12);
      const LoopFilters filters{0.02, 0.4, 0.7};
      CHECK(std::abs(theirs(response(filters, ours(p))) - filter_product(filters, p)) < 1e-12);
    }
}

TEST_CASE("the allpass's lag is its unwrapped phase, from 0 to order pi, and the group delay its slope") {
  for (const int first_orders : {0, 1, 5}) {
    CAPTURE(first_orders);
    const Allpass allpass = allpass_of(first_orders);
    double unwrapped = 0, before = 0;
    for (double omega = 1e-4; omega < 3.14; omega += 1e-4) {
      const double phase = std::arg(section_product(allpass, {0, std::tan(omega / 2)}));
      unwrapped += std::remainder(before - phase, 2 * M_PI);
      before = phase;
      REQUIRE(lag(allpass, omega) == doctest::Approx(unwrapped).epsilon(1e-9));
      if (omega < 0.01 || omega > 3.13) continue;
      const double h = 1e-5, slope = (lag(allpass, omega + h) - lag(allpass, omega - h)) / (2 * h);
      REQUIRE(group_delay(allpass, omega) == doctest::Approx(slope).epsilon(1e-5));
    }
    CHECK(lag(allpass, M_PI - 1e-9) == doctest::Approx(allpass.order() * M_PI).epsilon(1e-6));
  }
}

TEST_CASE("the filters' lag is what their phase falls behind") {
  const LoopFilters filters{0.02, 0.4, 0.7};
  for (const double omega : {0.01, 0.04, 0.3, 1.0, 3.0})
    CHECK(lag(filters, omega) ==
          doctest::Approx(-std::arg(filter_product(filters, {0, std::tan(omega / 2)}))).epsilon(1e-12));
}

TEST_CASE("a pole closes the loop, near the mode it was asked for, wherever the search begins") {
  for (const int first_orders : {0, 1, 5})
    for (const double k : {0.6, 0.89, 0.999}) {
      const LoopDesign loop = loop_of(first_orders);
      double before = 0;
      for (double omega = 0.1; omega < 2.9; omega += 0.003) {
        CAPTURE(omega);
        const Pole pole = closed_loop_pole(loop, k, omega);
        REQUIRE(std::abs(round_trip(loop, k, {pole.sigma, pole.omega}) - 1.0) < 1e-10);
        REQUIRE(pole.sigma < 0);
        // From one start to the next it is the same pole or the next one up.
        REQUIRE(pole.omega > before - 1e-9);
        REQUIRE(std::fabs(pole.omega - omega) < 0.2);
        before = pole.omega;
      }
    }
}

TEST_CASE("the decay rate keeps the size of a wave after a round trip, at a pole it is the pole's") {
  for (const int first_orders : {0, 1, 5})
    for (const double k : {0.6, 0.89, 0.999}) {
      const LoopDesign loop = loop_of(first_orders);
      for (double omega = 0.05; omega < 3; omega += 0.01) {
        const double sigma = decay_rate(loop, k, omega);
        REQUIRE(std::abs(round_trip(loop, k, {sigma, omega})) == doctest::Approx(1).epsilon(1e-12));
        const Pole pole = closed_loop_pole(loop, k, omega);
        REQUIRE(decay_rate(loop, k, pole.omega) == doctest::Approx(pole.sigma).epsilon(1e-9));
      }
    }
  CHECK(t60_samples(-std::log(1000.0) / 480) == doctest::Approx(480).epsilon(1e-12));
}
