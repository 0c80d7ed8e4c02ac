#include "diesel/hbwt.hpp"

#include <algorithm>

#include "rigsound/dsp/mdct.hpp"
#include "rigsound/dsp/wavelet.hpp"

namespace rigsound::analysis {

template <class T>
std::vector<T> mdct_frames(const std::vector<T>& x, int M) {
  const std::size_t m = static_cast<std::size_t>(M), frames = x.size() / m;
  std::vector<T> two(2 * m),
      X((frames + 1) * m);  // a frame sees the hop before it, and zeros beyond the ends
  dsp::Mdct<T> bank(M);
  for (std::size_t t = 0; t <= frames; ++t) {
    std::copy(two.begin() + M, two.end(), two.begin());
    if (t < frames)
      std::copy_n(x.begin() + static_cast<std::ptrdiff_t>(t * m), m, two.begin() + M);
    else
      std::fill(two.begin() + M, two.end(), T(0));
    bank.analyse(two.data(), &X[t * m]);
  }
  return X;
}

template <class T>
std::vector<T> from_mdct_frames(const std::vector<T>& X, int M) {
  const std::size_t m = static_cast<std::size_t>(M), frames = X.size() / m;
  std::vector<T> overlap(m, T(0)), y(frames * m);
  dsp::Mdct<T> bank(M);
  for (std::size_t t = 0; t < frames; ++t) bank.synthesise(&X[t * m], overlap.data(), &y[t * m]);
  y.erase(y.begin(), y.begin() + M);  // what ends before the first sample
  return y;
}

template <class T>
HbwtCoefficients<T> hbwt(const std::vector<T>& x, const HbwtShape& shape) {
  HbwtCoefficients<T> c;
  c.shape = shape;
  c.length = static_cast<int>(x.size());
  const int M = shape.M(), P = shape.P;
  const int hops = (c.length + M - 1) / M + 1;  // one frame more than hops covers the last sample
  const int group = shape.L << shape.N;
  const int T_frames = (hops + group - 1) / group * group;
  c.frames = T_frames / shape.L;

  std::vector<T> padded = x;
  const int wanted = (T_frames - 1) * M;
  for (int i = c.length; i < wanted; ++i) padded.push_back(i >= P ? padded[i - P] : T(0));
  const std::vector<T> X = mdct_frames(padded, M);

  const std::size_t columns = static_cast<std::size_t>(P);
  for (int n = 1; n <= shape.N; ++n) c.d.emplace_back(static_cast<std::size_t>(c.frames >> n) * columns);
  c.a.resize(static_cast<std::size_t>(c.frames >> shape.N) * columns);
  std::vector<T> line(static_cast<std::size_t>(c.frames)), low(line.size()), high(line.size());
  for (std::size_t column = 0; column < columns; ++column) {
    for (std::size_t r = 0; r < line.size(); ++r) line[r] = X[r * columns + column];
    for (int n = 1; n <= shape.N; ++n) {
      const int size = c.frames >> (n - 1);
      dsp::db4_analyse(line.data(), size, low.data(), high.data());
      for (int i = 0; i < size / 2; ++i) c.d[n - 1][static_cast<std::size_t>(i) * columns + column] = high[i];
      std::copy_n(low.begin(), size / 2, line.begin());
    }
    for (int i = 0; i < c.frames >> shape.N; ++i)
      c.a[static_cast<std::size_t>(i) * columns + column] = line[i];
  }
  return c;
}

template <class T>
std::vector<T> inverse_hbwt(const HbwtCoefficients<T>& c) {
  const std::size_t columns = static_cast<std::size_t>(c.shape.P);
  std::vector<T> X(static_cast<std::size_t>(c.frames) * columns);
  std::vector<T> line(static_cast<std::size_t>(c.frames)), high(line.size()), next(line.size());
  for (std::size_t column = 0; column < columns; ++column) {
    for (int i = 0; i < c.frames >> c.shape.N; ++i)
      line[i] = c.a[static_cast<std::size_t>(i) * columns + column];
    for (int n = c.shape.N; n >= 1; --n) {
      const int size = c.frames >> (n - 1);
      for (int i = 0; i < size / 2; ++i) high[i] = c.d[n - 1][static_cast<std::size_t>(i) * columns + column];
      dsp::db4_synthesise(line.data(), high.data(), size, next.data());
      line.swap(next);
    }
    for (std::size_t r = 0; r < line.size(); ++r) X[r * columns + column] = line[r];
  }
  std::vector<T> y = from_mdct_frames(X, c.shape.M());
  y.resize(static_cast<std::size_t>(c.length));
  return y;
}

template HbwtCoefficients<float> hbwt(const std::vector<float>&, const HbwtShape&);
template HbwtCoefficients<double> hbwt(const std::vector<double>&, const HbwtShape&);
template std::vector<float> inverse_hbwt(const HbwtCoefficients<float>&);
template std::vector<double> inverse_hbwt(const HbwtCoefficients<double>&);
template std::vector<float> mdct_frames(const std::vector<float>&, int);
template std::vector<double> mdct_frames(const std::vector<double>&, int);
template std::vector<float> from_mdct_frames(const std::vector<float>&, int);
template std::vector<double> from_mdct_frames(const std::vector<double>&, int);

}  // namespace rigsound::analysis
