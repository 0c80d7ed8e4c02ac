#include "rigsound/dsp/mdct.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "rigsound/dsp/elementary.hpp"

namespace rigsound::dsp {
namespace {

bool is_fast(int M) { return M >= 4 && (M & (M - 1)) == 0; }

}  // namespace

template <class T>
Mdct<T>::Mdct(int M) : M_(M), fast_(is_fast(M)), fft_(fast_ ? M / 2 : 1), u_(static_cast<std::size_t>(M)) {
  for (int k = 0; k < 2 * M; ++k) window_.push_back(static_cast<T>(sin(kPi / (4 * M) * (2 * k + 1))));
  if (fast_) {
    const double scale = std::sqrt(std::sqrt(2.0 / M));
    for (int n = 0; n < M / 2; ++n) {
      twist_cos_.push_back(static_cast<T>(scale * cos(kPi / (8 * M) * (8 * n + 1))));
      twist_sin_.push_back(static_cast<T>(scale * sin(kPi / (8 * M) * (8 * n + 1))));
    }
    re_.resize(static_cast<std::size_t>(M / 2));
    im_.resize(static_cast<std::size_t>(M / 2));
    return;
  }
  sums_.resize(static_cast<std::size_t>(M));
  for (std::int64_t k = 0; k < 2 * M; ++k)
    for (std::int64_t q = 0; q < M; ++q) {
      // Reduced exactly before the cosine: the angle is a whole multiple of pi / 4M.
      const std::int64_t angle = (2 * k + 1 + M) * (2 * q + 1) % (8 * M);
      matrix_.push_back(static_cast<T>(sin(kPi / (4 * M) * static_cast<double>(2 * k + 1)) *
                                       std::sqrt(2.0 / M) * cos(kPi / (4 * M) * static_cast<double>(angle))));
    }
}

template <class T>
void Mdct<T>::twist(const T* x) noexcept {
  const int H = M_ / 2;
  const T *c = twist_cos_.data(), *s = twist_sin_.data();
  for (int n = 0; n < H; ++n) {
    const T a = x[2 * n], b = x[M_ - 1 - 2 * n];
    re_[static_cast<std::size_t>(n)] = a * c[n] + b * s[n];
    im_[static_cast<std::size_t>(n)] = b * c[n] - a * s[n];
  }
}

template <class T>
void Mdct<T>::twist_back(T* u) const noexcept {
  const int H = M_ / 2;
  const T *c = twist_cos_.data(), *s = twist_sin_.data();
  for (int k = 0; k < H; ++k) {
    const T r = re_[static_cast<std::size_t>(k)], i = im_[static_cast<std::size_t>(k)];
    u[2 * k] = r * c[k] + i * s[k];
    u[M_ - 1 - 2 * k] = r * s[k] - i * c[k];
  }
}

template <class T>
void Mdct<T>::dct4(const T* x, T* u) noexcept {
  twist(x);
  fft_.forward(re_.data(), im_.data());
  twist_back(u);
}

template <class T>
void Mdct<T>::analyse(const T* x, T* X) noexcept {
  if (!fast_) {
    sums_.assign(sums_.size(), 0.0);
    const T* row = matrix_.data();
    for (int k = 0; k < 2 * M_; ++k, row += M_)
      for (int q = 0; q < M_; ++q)
        sums_[static_cast<std::size_t>(q)] += static_cast<double>(x[k]) * static_cast<double>(row[q]);
    for (int q = 0; q < M_; ++q) X[q] = static_cast<T>(sums_[static_cast<std::size_t>(q)]);
    return;
  }
  // x = [a b c d] folds to [-c_r - d, a - b_r], whose DCT-IV is X.
  const int H = M_ / 2;
  const T* w = window_.data();
  for (int k = 0; k < H; ++k) {
    X[k] = -x[3 * H - 1 - k] * w[3 * H - 1 - k] - x[3 * H + k] * w[3 * H + k];
    X[H + k] = x[k] * w[k] - x[M_ - 1 - k] * w[M_ - 1 - k];
  }
  dct4(X, X);
}

template <class T>
void Mdct<T>::synthesise(const T* X, T* overlap, T* y) noexcept {
  for (int number = 0; number < steps(); ++number) step(number, X);
  finish(overlap, y);
}

template <class T>
void Mdct<T>::step(int number, const T* X) noexcept {
  if (!fast_)
    std::copy_n(X, M_, u_.data());
  else if (number == 0)
    twist(X);
  else if (number <= fft_.stages())
    fft_.stage(number - 1, re_.data(), im_.data());
  else
    twist_back(u_.data());
}

template <class T>
void Mdct<T>::finish(T* overlap, T* y) noexcept {
  const T* u = u_.data();
  if (!fast_) {
    const T* row = matrix_.data();
    for (int k = 0; k < 2 * M_; ++k, row += M_) {
      double sum = 0;
      for (int q = 0; q < M_; ++q) sum += static_cast<double>(u[q]) * static_cast<double>(row[q]);
      if (k < M_)
        y[k] = overlap[k] + static_cast<T>(sum);
      else
        overlap[k - M_] = static_cast<T>(sum);
    }
    return;
  }
  const int H = M_ / 2;
  const T* w = window_.data();
  for (int k = 0; k < H; ++k) {
    y[k] = overlap[k] + u[H + k] * w[k];
    y[H + k] = overlap[H + k] - u[M_ - 1 - k] * w[H + k];
  }
  for (int k = 0; k < H; ++k) {
    overlap[k] = -u[H - 1 - k] * w[M_ + k];
    overlap[H + k] = -u[k] * w[M_ + H + k];
  }
}

template class Mdct<float>;
template class Mdct<double>;

}  // namespace rigsound::dsp
