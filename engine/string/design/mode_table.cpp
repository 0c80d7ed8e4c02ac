#include "string/design/mode_table.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/dsp/elementary.hpp"
#include "rigsound/steel.hpp"
#include "tool/design/mode_law.hpp"

namespace rigsound::string {
namespace {

constexpr double kStep = 0.04;     // of the logarithm of the length, from row to row
constexpr double kHighest = 0.45;  // of the sample rate; what lies above does not sound

}  // namespace

double warped(double hz, double sample_rate) noexcept { return dsp::tan(dsp::kPi * hz / sample_rate); }

ModeTable::ModeTable(const StringModel& model, double sample_rate)
    : low_(dsp::log(kShortest * model.rod_diameter_m) - kStep) {
  const double span = dsp::log(model.rod_length_m) - low_;
  rows_ = static_cast<int>(std::floor(span / kStep)) + 3;
  t_.resize(static_cast<std::size_t>(rows_) * kMaxModes);
  for (int row = 0; row < rows_; ++row) {
    const tool::TransversalLaw law(Bar{dsp::exp(low_ + row * kStep), model.rod_diameter_m});
    for (int k = 0; k < kMaxModes; ++k)
      t_[row * kMaxModes + k] = warped(std::min(law.at(k + 1), kHighest * sample_rate), sample_rate);
  }
}

TableCut ModeTable::cut(double length_m) const noexcept {
  const double position = (dsp::log(length_m) - low_) / kStep;
  const double held = std::min(std::max(position, 1.0), rows_ - 2.0);
  const int first = std::min(static_cast<int>(held) - 1, rows_ - 4);
  const double x = held - first, a = x - 1, b = x - 2, c = x - 3;  // Lagrange's cubic over rows 0...3
  TableCut cut;
  for (int i = 0; i < 4; ++i) cut.row[i] = &t_[(first + i) * kMaxModes];
  cut.weight[0] = -(a * b * c) / 6;
  cut.weight[1] = x * b * c / 2;
  cut.weight[2] = -(x * a * c) / 2;
  cut.weight[3] = x * a * b / 6;
  return cut;
}

}  // namespace rigsound::string
