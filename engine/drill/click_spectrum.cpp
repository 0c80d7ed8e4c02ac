#include "drill/click_spectrum.hpp"

#include <algorithm>
#include <cmath>

#include "drill/tilt_filter.hpp"
#include "rigsound/dsp/elementary.hpp"
#include "rigsound/dsp/fft.hpp"

namespace rigsound {
namespace drill {
namespace {

constexpr double kLowest_hz = 63;
constexpr double kFrom_hz = 150, kTo_hz = 8500;  // of the slope
constexpr std::size_t kClicks = 16;              // that stand for the bank
constexpr int kSize = 2048;                      // samples: a click has decayed by then
constexpr double kNothing = 1e-12;               // of a click's energy

}  // namespace

double ClickSpectrum::centre_hz(int band) { return kLowest_hz * dsp::exp(band * dsp::kLn2 / 3); }

ClickSpectrum::ClickSpectrum(const ClickBank& bank) {
  const dsp::Fft<double> fft(kSize);
  const double half_band = dsp::exp(dsp::kLn2 / 6);
  std::array<double, kBands> upper_hz{};
  for (int band = 0; band < kBands; ++band)
    upper_hz[static_cast<std::size_t>(band)] = centre_hz(band) * half_band;
  std::vector<double> re(kSize), im(kSize);
  for (std::size_t i = 0; i < std::min(kClicks, bank.clicks.size()); ++i) {
    const Click& click = bank.clicks[i];
    const std::size_t length = std::min<std::size_t>(click.size(), kSize);
    std::fill(std::copy_n(click.begin(), length, re.begin()), re.end(), 0.0);
    std::fill(im.begin(), im.end(), 0.0);
    fft.forward(re.data(), im.data());
    std::size_t band = 0;
    for (int k = 1; k < kSize / 2; ++k) {
      const double f = k * bank.sample_rate / kSize;
      while (band < kBands - 1 && f > upper_hz[band]) ++band;
      power_[band] += re[k] * re[k] + im[k] * im[k];
    }
  }
}

double ClickSpectrum::tilt_db_per_octave() const {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (int band = 0; band < kBands; ++band) {
    const double f = centre_hz(band), power = power_[static_cast<std::size_t>(band)];
    if (f < kFrom_hz || f > kTo_hz || power <= 0) continue;
    // Third octaves of a flat spectrum rise by 3 dB an octave: levels are those of a hertz.
    const double octave = band / 3.0, level = 10 / dsp::kLn10 * dsp::log(power / f);
    n += 1, x += octave, y += level, xx += octave * octave, xy += octave * level;
  }
  return n > 1 ? (n * xy - x * y) / (n * xx - x * x) : 0;
}

double ClickSpectrum::ln_norm(double tilt) const {
  double before = kNothing, after = kNothing;
  for (int band = 0; band < kBands; ++band) {
    const double power = power_[static_cast<std::size_t>(band)];
    before += power, after += power * tilt_power(tilt, centre_hz(band));
  }
  return 0.5 * dsp::log(after / before);
}

}  // namespace drill

double spectral_tilt(const ClickBank& bank) { return drill::ClickSpectrum(bank).tilt_db_per_octave(); }

}  // namespace rigsound
