// The inner loop, for the lane width RIGSOUND_LANES. Included by one source file per width; everything has
// internal linkage, because the linker must not merge code compiled for different processors.
//
// Skew: lane m works on the sample that entered the cascade m samples ago, so all sections of a vector can
// advance at once. The cascade's extra delay of (sections - 1) samples is taken out of the delay line.
#pragma once

#include <cstring>

#include "tool/bar_kernel.hpp"

namespace rigsound::tool {
namespace {

constexpr int W = RIGSOUND_LANES;
typedef double V __attribute__((vector_size(W * sizeof(double))));
typedef std::uint64_t Bits __attribute__((vector_size(W * sizeof(double))));
typedef double V2 __attribute__((vector_size(16)));

template <class Vector, class T>
Vector load(const T* from) {
  Vector v;
  std::memcpy(&v, from, sizeof v);
  return v;
}

template <class Vector>
void store(double* to, Vector v) {
  std::memcpy(to, &v, sizeof v);
}

/// Lanes move up by one; the lowest gets `below`'s highest.
inline V shifted(V v, V below) {
#if RIGSOUND_LANES == 4
  return __builtin_shufflevector(v, below, 7, 0, 1, 2);
#else
  return __builtin_shufflevector(v, below, 3, 0);
#endif
}

/// `u` in the lane `entry` marks. The lanes before it idle at zero, so OR is as good as a choice.
inline V entered(V v, double u, Bits entry) {
  V all;
  for (int i = 0; i < W; ++i) all[i] = u;
  return (V)((Bits)v | ((Bits)all & entry));
}

/// Rest of both loops (DC blocker, shelf, reflection, delay line), then mix and high-pass.
class Glue {
 public:
  Glue(BarState& s, const BarDrive& drive, double* out)
      : s_(s),
        drive_(drive),
        out_(out),
        dc_d_(load<V2>(s.dc_d)),
        dc_r_(load<V2>(s.dc_r)),
        sh_0_(load<V2>(s.sh_0)),
        sh_1_(load<V2>(s.sh_1)),
        sh_q_(load<V2>(s.sh_q)),
        dc_s_(load<V2>(s.dc_s)),
        sh_s_(load<V2>(s.sh_s)),
        hp_m_(s.hp_m),
        hp_out_(s.hp_out),
        at_(s.at) {}

  ~Glue() {
    store(s_.dc_s, dc_s_);
    store(s_.sh_s, sh_s_);
    s_.hp_m = hp_m_;
    s_.hp_out = hp_out_;
    s_.at = at_;
  }

  Glue(const Glue&) = delete;
  Glue& operator=(const Glue&) = delete;

  double from_delay(Family family) const { return s_.ring[(at_ - s_.delay[family]) % kRing][family]; }

  /// Closes both loops for sample `i` of the chunk; v: what comes out of the cascades.
  void close(int i, V2 v) {
    const V2 dv = dc_d_ * v, b = dv + dc_s_;
    dc_s_ = dc_r_ * b - dv;
    const V2 w = sh_0_ * b + sh_s_;
    sh_s_ = sh_1_ * b + sh_q_ * w;
    const V2 y = V2{drive_.x[i], drive_.x[i]} + load<V2>(drive_.k[i]) * w;
    store(s_.ring[at_++ % kRing], y);
    const V2 weighed = load<V2>(drive_.mix[i]) * y;
    const double m = weighed[0] + weighed[1];
    out_[i] = hp_out_ = s_.hp_b * (m - hp_m_) + s_.hp_p * hp_out_;
    hp_m_ = m;
  }

 private:
  BarState& s_;
  const BarDrive& drive_;
  double* out_;
  V2 dc_d_, dc_r_, sh_0_, sh_1_, sh_q_;
  V2 dc_s_, sh_s_;
  double hp_m_, hp_out_;
  unsigned at_;
};

/// NT vectors of transversal sections, then NL of longitudinal ones; each family ends in a vector's last
/// lane.
template <int NT, int NL>
void run_sections(BarState& state, const BarDrive& drive, double* out) noexcept {
  constexpr int N = NT + NL;
  SectionLanes& lanes = state.sections;
  V g0[N], g1[N], g2[N], h[N], e[N], x1[N], x2[N], y[N];
  for (int j = 0; j < N; ++j) {
    g0[j] = load<V>(&lanes.g0[W * j]), g1[j] = load<V>(&lanes.g1[W * j]), g2[j] = load<V>(&lanes.g2[W * j]);
    h[j] = load<V>(&lanes.h[W * j]), e[j] = load<V>(&lanes.e[W * j]);
    x1[j] = load<V>(&lanes.x1[W * j]), x2[j] = load<V>(&lanes.x2[W * j]), y[j] = load<V>(&lanes.y[W * j]);
  }
  const Bits entry_T = load<Bits>(state.entry[kTransversal]),
             entry_L = load<Bits>(state.entry[kLongitudinal]);
  Glue glue(state, drive, out);
  for (int i = 0; i < drive.frames; ++i) {
    V below{};
#pragma GCC unroll 24
    for (int j = 0; j < N; ++j) {
      V u = shifted(y[j], below);
      if (j == 0) u = entered(u, glue.from_delay(kTransversal), entry_T);
      if (j == NT) u = entered(u, glue.from_delay(kLongitudinal), entry_L);
      below = j == NT - 1 ? V{} : y[j];
      const V m = (g0[j] * x1[j] - g1[j] * x2[j]) + g2[j] * u;
      y[j] = u - h[j] * m;
      x1[j] = m - x1[j];
      x2[j] = x2[j] + e[j] * m;
    }
    glue.close(i, V2{y[NT - 1][W - 1], y[N - 1][W - 1]});
  }
  for (int j = 0; j < N; ++j) {
    store(&lanes.x1[W * j], x1[j]);
    store(&lanes.x2[W * j], x2[j]);
    store(&lanes.y[W * j], y[j]);
  }
}

void run_paper(BarState& state, const BarDrive& drive, double* out) noexcept {
  PaperLanes& lanes = state.paper;
  const int vectors = state.vectors[kTransversal];
  const double lambda = lanes.lambda;
  V s[kPaperLanes / W], y[kPaperLanes / W];
  for (int j = 0; j < vectors; ++j) s[j] = load<V>(&lanes.s[W * j]), y[j] = load<V>(&lanes.y[W * j]);
  const Bits entry_T = load<Bits>(state.entry[kTransversal]);
  Glue glue(state, drive, out);
  for (int i = 0; i < drive.frames; ++i) {
    V below{}, enter = entered(V{}, glue.from_delay(kTransversal), entry_T);
    for (int j = 0; j < vectors; ++j) {
      V u = shifted(y[j], below);
      if (j == 0) u = (V)((Bits)u | (Bits)enter);
      below = y[j];
      y[j] = lambda * u + s[j];
      s[j] = u - lambda * y[j];
    }
    glue.close(i, V2{y[vectors - 1][W - 1], glue.from_delay(kLongitudinal)});
  }
  for (int j = 0; j < vectors; ++j) store(&lanes.s[W * j], s[j]), store(&lanes.y[W * j], y[j]);
}

template <int NL>
BarKernel with_transversal(int vectors_T) {
  static constexpr BarKernel kTable[] = {
    run_sections<1, NL>,
    run_sections<2, NL>,
    run_sections<3, NL>,
    run_sections<4, NL>,
    run_sections<5, NL>,
#if RIGSOUND_LANES == 2
    run_sections<6, NL>,
    run_sections<7, NL>,
    run_sections<8, NL>,
    run_sections<9, NL>,
    run_sections<10, NL>,
#endif
  };
  static_assert(sizeof kTable / sizeof *kTable * W == kMaxSections);
  return kTable[vectors_T - 1];
}

}  // namespace
}  // namespace rigsound::tool
