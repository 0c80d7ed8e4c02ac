// The diesel and its hydraulics, as the background layer plays them.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

namespace rigsound {

constexpr int kMaxCrankAngle = 8192;    ///< largest angle_samples
constexpr double kGrainOverlap = 0.25;  ///< of a cycle, equal power

/// A four-stroke's cycle is two turns of the crank: cycles a second at `rpm` r/min.
constexpr double cycles_per_second(double rpm) noexcept { return rpm / 120; }
constexpr double rpm_of_cycles(double cycles_per_second) noexcept { return cycles_per_second * 120; }

/// The diesel at one speed and load. Angles count cycles of 720 degrees of crank; the cycles of all points of
/// a model begin at the same crank angle. Levels: full scale = 1.
struct DieselPoint {
  std::string source;                       ///< recording it was learned from
  double rpm = 900;                         ///< r/min, 400...3000
  double load = 0;                          ///< 0...1
  std::vector<std::complex<float>> orders;  ///< C_k, orders 1, 2, ...: sum_k Re(C_k exp(2 pi i k theta))
  std::vector<float> low_variance;   ///< (N + 1) x P_lo: variance per scale n = 1...N, then the scaling band
  std::vector<float> slot_variance;  ///< L x bands: variance of the whitened MDCT coefficients, per slot
  std::vector<float> slot_log_variance;  ///< L: variance of the logarithm of the slot's power, 0...1.5
  double slot_correlation = 0;           ///< correlation of that logarithm from slot to slot, 0...0.9
  std::vector<std::vector<float>>
      grains;  ///< cycles of the whitened high layer, (1 + overlap) angle_samples each
};

/// E(f): what the body adds to every order, dB at f_k = f_min * 2^(k / per_octave). Empty: unknown, flat.
struct BodyResponse {
  double f_min = 30;
  int per_octave = 18;
  std::vector<float> db;
};

/// A line that is not locked to the cycle.
struct DieselOscillator {
  double frequency = 0;  ///< orders (cycles a cycle) or Hz
  bool order_locked = false;
  double amplitude = 0;     ///< linear peak
  double linewidth_hz = 0;  ///< its phase walks at random by 2 pi * linewidth rad^2 a second
};

/// Pump and oil flow: stationary coloured noise plus pump orders. Its gain follows the feed pressure.
struct HydraulicPart {
  double pump_order = 18;          ///< strokes a cycle of 720 degrees: nine pistons at engine speed
  std::vector<float> pump;         ///< peak amplitude of the harmonics of the pump order, linear
  double flow = 0;                 ///< rms of the flow noise, linear
  std::vector<float> flow_filter;  ///< colour of the flow noise, a[0] = 1 ... a[p], at `sample_rate`
  double exponent = 0.7;           ///< gain = (feed pressure / overfeed pressure) ^ exponent
};

/// One machine: points joined in the order domain, and what they share.
struct DieselModel {
  std::string name;
  double sample_rate = 48000;      ///< Hz, of A, the hydraulic colour and the one-shots
  int angle_samples = 4096;        ///< angle samples a cycle, a power of two, 1024...8192
  int slots = 64;                  ///< slots a cycle, a power of two, 16...256; slot_samples() each
  int low_channels = 256;          ///< channels of the low layer, a power of two
  int low_scales = 3;              ///< its wavelet scales, 0...4
  double crossover_hz = 400;       ///< Hz, crossover of low and high layer, 200...800
  std::vector<float> body_filter;  ///< a[0] = 1 ... a[p]: 1/A(z) is the body above f_x
  BodyResponse body;
  double load_slope_db = 5;         ///< level over load while all points have one load, dB from 0 to 1
  std::vector<DieselPoint> points;  ///< at least one
  std::vector<DieselOscillator> oscillators;
  HydraulicPart hydraulic;
  std::vector<float> start, stop;  ///< one-shots; empty: the engine fades with its speed

  int slot_samples() const { return angle_samples / slots; }
};

/// Throws std::invalid_argument naming the field whose shape or range the voice cannot play. Thread: OFF.
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
