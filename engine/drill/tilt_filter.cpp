#include "drill/tilt_filter.hpp"

#include <cmath>

#include "rigsound/dsp/elementary.hpp"
#include "rigsound/machine/limits.hpp"

namespace rigsound::drill {
namespace {

// A state: what is less is dropped before it turns denormal, what is more will soon be no number.
constexpr double kLeast = 1e-12, kMost = 1e50;

}  // namespace

// A shelf is (1 + s g / w) / (1 + s / (g w)): from 1 to g^2, g of it at w.
double tilt_power(double db_per_octave, double frequency_hz) {
  const double g = dsp::gain_of_db(db_per_octave);
  double power = 1;
  for (const double shelf_hz : kShelves_hz) {
    const double w = frequency_hz / shelf_hz;
    power *= (1 + w * w * g * g) / (1 + w * w / (g * g));
  }
  return power;
}

TiltFilter::TiltFilter(double sample_rate) : shelves_{} {
  for (std::size_t i = 0; i < shelves_.size(); ++i)
    shelves_[i].warp = 1 / dsp::tan(dsp::kPi * kShelves_hz[i] / sample_rate);
}

void TiltFilter::place(double db_per_octave) noexcept {
  tilt_ = db_per_octave;
  const double g = dsp::gain_of_db(db_per_octave);
  for (Shelf& shelf : shelves_) {
    const double zero = shelf.warp * g, pole = shelf.warp / g, scale = 1 / (1 + pole);
    shelf.b0 = (1 + zero) * scale, shelf.b1 = (1 - zero) * scale, shelf.a1 = (1 - pole) * scale;
  }
}

void TiltFilter::reset() noexcept {
  for (Shelf& shelf : shelves_) shelf.state = 0;
}

bool TiltFilter::rests() const noexcept {
  for (const Shelf& shelf : shelves_)
    if (shelf.state != 0) return false;
  return true;
}

void TiltFilter::process(double db_per_octave, double* x) noexcept {
  if (db_per_octave != tilt_) place(db_per_octave);
  if (tilt_ == 0 && rests()) return;
  for (Shelf& shelf : shelves_) {
    double state = shelf.state;
    for (int n = 0; n < kChunk; ++n) {
      const double y = shelf.b0 * x[n] + state;
      state = shelf.b1 * x[n] - shelf.a1 * y;
      x[n] = y;
    }
    const double size = std::fabs(state);
    shelf.state = size >= kLeast && size < kMost ? state : 0;
  }
}

}  // namespace rigsound::drill
