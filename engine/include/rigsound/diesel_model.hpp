// The diesel and its hydraulics, as the background layer plays them.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "rigsound/machine/fields.hpp"

namespace rigsound {

constexpr int kMaxCrankAngle = 8192;    ///< largest angle_samples
constexpr double kGrainOverlap = 0.25;  ///< of a cycle, equal power

/// Levels of files. The lowest stands for nothing.
constexpr Range kLevels = Range{-240, 60, "dB"}.rounded(2);

/// Marks numbers that are linear here and levels in a file: powers (variances).
struct PowersInDb {
  Range levels;
};

/// A four-stroke's cycle is two turns of the crank: cycles a second at `rpm` r/min.
constexpr double cycles_per_second(double rpm) noexcept { return rpm / 120; }
constexpr double rpm_of_cycles(double cycles_per_second) noexcept { return cycles_per_second * 120; }

/// The diesel at one speed and load. Angles count cycles of 720 degrees of crank; the cycles of all points of
/// a model begin at the same crank angle. Levels: full scale = 1.
struct DieselPoint {
  std::string source;  ///< recording it was learned from
  double rpm = 900;
  double load = 0;                          ///< share of full load
  std::vector<std::complex<float>> orders;  ///< C_k, orders 1, 2, ...: sum_k Re(C_k exp(2 pi i k theta))
  std::vector<float> low_variance;   ///< (N + 1) x P_lo: variance per scale n = 1...N, then the scaling band
  std::vector<float> slot_variance;  ///< L x bands: variance of the whitened MDCT coefficients, per slot
  std::vector<float> slot_log_variance;  ///< L: variance of the logarithm of the slot's power
  double slot_correlation = 0;           ///< correlation of that logarithm from slot to slot
  std::vector<std::vector<float>>
      grains;  ///< cycles of the whitened high layer, (1 + overlap) angle_samples each
};

/// Everything but the grains.
template <class Archive>
void fields(Archive& a, DieselPoint& o) {
  a("source", o.source);
  a("rpm", o.rpm, Range{300, 4000, "r/min"}.rounded(3));
  a("load", o.load, Range{0, 1}.rounded(3));
  a("order_level_db", "order_phase", o.orders, kLevels, Range{-4, 4, "rad"}.rounded(3));
  a("v_lo_db", o.low_variance, PowersInDb{kLevels});
  a("v_hi_db", o.slot_variance, PowersInDb{kLevels});
  a("s2", o.slot_log_variance, Range{0, 2}.rounded(3));
  a("rho", o.slot_correlation, Range{0, 0.95}.rounded(3));
}

/// E(f): what the body adds to every order, dB at f_k = f_min * 2^(k / per_octave). Empty: unknown, flat.
struct BodyResponse {
  double f_min = 30;
  int per_octave = 18;
  std::vector<float> db;
};

template <class Archive>
void fields(Archive& a, BodyResponse& o) {
  a("f_min", o.f_min, Range{1, 1000, "Hz"});
  a("per_octave", o.per_octave, Range{1, 96});
  a("db", o.db, Range{-200, 120, "dB"}.rounded(2));
}

/// A line that is not locked to the cycle.
struct DieselOscillator {
  double frequency = 0;  ///< orders (cycles a cycle) or Hz
  bool order_locked = false;
  double amplitude = 0;     ///< linear peak
  double linewidth_hz = 0;  ///< its phase walks at random by 2 pi * linewidth rad^2 a second
};

template <class Archive>
void fields(Archive& a, DieselOscillator& o) {
  a("frequency", o.frequency, Range{0, 24000});
  a("order_locked", o.order_locked);
  a("amplitude", o.amplitude, Range{0, 10}.rounded(7));
  a("linewidth_hz", o.linewidth_hz, Range{0, 100, "Hz"}.rounded(4));
}

constexpr Range kFilterCoefficients = Range{-1e6, 1e6}.rounded(8);

/// Pump and oil flow: stationary coloured noise plus pump orders. Its gain follows the feed pressure.
struct HydraulicPart {
  double pump_order = 18;          ///< strokes a cycle of 720 degrees: nine pistons at engine speed
  std::vector<float> pump;         ///< peak amplitude of the harmonics of the pump order, linear
  double flow = 0;                 ///< rms of the flow noise, linear
  std::vector<float> flow_filter;  ///< colour of the flow noise, a[0] = 1 ... a[p], at `sample_rate`
  double exponent = 0.7;           ///< gain = (feed pressure / overfeed pressure) ^ exponent
};

template <class Archive>
void fields(Archive& a, HydraulicPart& o) {
  constexpr Range kAmplitudes = Range{0, 1}.rounded(6);
  a("pump_order", o.pump_order, Range{0.01, 1000});
  a("pump", o.pump, kAmplitudes);
  a("flow", o.flow, kAmplitudes);
  a("flow_A", o.flow_filter, kFilterCoefficients);
  a("exponent", o.exponent, Range{0, 4});
}

/// One machine: points joined in the order domain, and what they share.
struct DieselModel {
  std::string name;
  double sample_rate = 48000;      ///< Hz, of A, the hydraulic colour and the one-shots
  int angle_samples = 4096;        ///< angle samples a cycle, a power of two
  int slots = 64;                  ///< slots a cycle, a power of two; slot_samples() each
  int low_channels = 256;          ///< channels of the low layer, a power of two
  int low_scales = 3;              ///< its wavelet scales
  double crossover_hz = 400;       ///< crossover of low and high layer
  std::vector<float> body_filter;  ///< a[0] = 1 ... a[p]: 1/A(z) is the body above f_x
  BodyResponse body;
  double load_slope_db = 5;         ///< level over load while all points have one load, dB from 0 to 1
  std::vector<DieselPoint> points;  ///< at least one
  std::vector<DieselOscillator> oscillators;
  HydraulicPart hydraulic;
  std::vector<float> start, stop;  ///< one-shots; empty: the engine fades with its speed

  int slot_samples() const { return angle_samples / slots; }
};

/// Everything but the one-shots.
template <class Archive>
void fields(Archive& a, DieselModel& o) {
  a("sample_rate", o.sample_rate, Range{8000, 192000, "Hz"});
  a("N_theta", o.angle_samples, Range{1024, kMaxCrankAngle});
  a("L", o.slots, Range{16, 256});
  a("P_lo", o.low_channels, Range{64, 1024});
  a("N", o.low_scales, Range{0, 4});
  a("f_x", o.crossover_hz, Range{200, 800, "Hz"});
  a("load_slope_db", o.load_slope_db, Range{-24, 24, "dB"});
  a("A", o.body_filter, kFilterCoefficients);
  a("E", o.body);
  a("hydraulic", o.hydraulic);
  a("oscillators", o.oscillators);
  a("points", o.points);
}

/// Throws InvalidField for the field whose shape or range the voice cannot play. Thread: OFF.
void require_valid(const DieselModel& model);

/// Edges of the bands in which slot_variance is pooled, 1/6 octave wide and at least one channel: 0 ... M.
/// Thread: OFF.
inline std::vector<int> slot_band_edges(int M) {
  std::vector<int> edges = {0};
  while (edges.back() < M) {
    const int width = static_cast<int>(std::floor(edges.back() * 0.122462048309373 + 0.5));  // 2^(1/6) - 1
    edges.push_back(std::min(M, edges.back() + (width > 1 ? width : 1)));
  }
  return edges;
}

}  // namespace rigsound
