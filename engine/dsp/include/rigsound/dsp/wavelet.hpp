// Daubechies' orthogonal wavelet with four vanishing moments (8 taps), the one the background uses.
#pragma once

namespace rigsound::dsp {

constexpr int kDb4Taps = 8;

/// Minimum-phase scaling filter, sum = sqrt 2. Spectral factorisation in 50 digits, rounded to double:
/// the digits usually printed make the transform orthogonal to 1e-12 only.
constexpr double kDb4Scaling[kDb4Taps] = {
    0.23037781330889650086,  0.71484657055291564709,  0.63088076792985890788,  -0.027983769416859854211,
    -0.18703481171909308408, 0.030841381835560763627, 0.032883011666885199735, -0.010597401785069032105};

/// Wavelet filter g[k] = (-1)^k h[7 - k].
constexpr double db4_wavelet(int k) {
  return (k & 1) ? -kDb4Scaling[kDb4Taps - 1 - k] : kDb4Scaling[kDb4Taps - 1 - k];
}

/// One level of the periodised analysis: `x` of even length n into n/2 approximations and n/2 details.
/// a[i] = sum_k h[k] x[2i + k], d[i] = sum_k g[k] x[2i + k], indices modulo n. Thread: RT.
template <class T>
void db4_analyse(const T* x, int n, T* a, T* d) noexcept {
  for (int i = 0; i < n / 2; ++i) {
    T low = 0, high = 0;
    for (int k = 0; k < kDb4Taps; ++k) {
      const T value = x[(2 * i + k) % n];
      low += static_cast<T>(kDb4Scaling[k]) * value;
      high += static_cast<T>(db4_wavelet(k)) * value;
    }
    a[i] = low, d[i] = high;
  }
}

/// Its inverse: n/2 approximations and details into n samples. Thread: RT.
template <class T>
void db4_synthesise(const T* a, const T* d, int n, T* x) noexcept {
  for (int i = 0; i < n; ++i) {
    T sum = 0;
    for (int k = i & 1; k < kDb4Taps; k += 2) {
      const int j = ((i - k) / 2 % (n / 2) + n / 2) % (n / 2);
      sum += static_cast<T>(kDb4Scaling[k]) * a[j] + static_cast<T>(db4_wavelet(k)) * d[j];
    }
    x[i] = sum;
  }
}

}  // namespace rigsound::dsp
