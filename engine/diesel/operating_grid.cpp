#include "diesel/operating_grid.hpp"

#include <algorithm>
#include <optional>

#include "diesel/order_tables.hpp"
#include "diesel/source_point.hpp"
#include "diesel/wavelet_tree.hpp"
#include "rigsound/dsp/elementary.hpp"
#include "rigsound/dsp/lanes.hpp"
#include "rigsound/dsp/passes.hpp"

namespace rigsound::diesel {
namespace {

constexpr int kPerOctave = 24;
constexpr double kBelow = 0.5;     // of the slowest point: there the grid begins
constexpr double kTop_rpm = 4000;  // to the top, so that no order ever folds over
constexpr int kLoadSteps = 3;      // between two loads of the model

std::vector<double> load_axis(const DieselModel& model) {
  std::vector<double> known;
  for (const DieselPoint& p : model.points) known.push_back(p.load);
  std::sort(known.begin(), known.end());
  known.erase(std::unique(known.begin(), known.end()), known.end());
  std::vector<double> axis = {known.front()};
  for (std::size_t i = 1; i < known.size(); ++i)
    for (int step = 1; step <= kLoadSteps; ++step)
      axis.push_back(known[i - 1] + (known[i] - known[i - 1]) * step / kLoadSteps);
  return axis;
}

std::vector<float> exponentials(const std::vector<double>& logarithms) {
  std::vector<float> y(logarithms.size());
  std::transform(logarithms.begin(), logarithms.end(), y.begin(),
                 [](double x) { return static_cast<float>(dsp::exp(x)); });
  return y;
}

/// `deviations` with the body on them; channel q lies at order (q + 1/2) / 2.
std::vector<float> with_body(const DieselModel& model, const std::vector<float>& deviations, double rpm) {
  const auto channels = static_cast<std::size_t>(model.low_channels),
             groups = std::size_t{WaveletTree::kGroups};
  const std::size_t rows = deviations.size() / channels, width = channels / groups;
  std::vector<float> lo(deviations.size());
  for (std::size_t q = 0; q < channels; ++q) {
    const double f = (static_cast<double>(q) + 0.5) / 2 * cycles_per_second(rpm);
    const auto body = static_cast<float>(dsp::gain_of_db(body_db(model.body, f)));
    for (std::size_t row = 0; row < rows; ++row)
      lo[(q % groups * rows + row) * width + q / groups] = deviations[row * channels + q] * body;
  }
  return lo;
}

/// What is the same wherever the model is held.
struct Source {
  explicit Source(const SourcePoint& point)
      : orders(point),
        lo(exponentials(point.lo)),
        slots(std::make_shared<const SlotStatistics>(
            SlotStatistics{exponentials(point.hi), {point.s.begin(), point.s.end()}, point.rho})) {}

  OrderTables::Source orders;
  std::vector<float> lo;  // without the body
  std::shared_ptr<const SlotStatistics> slots;
};

/// out[i] = the weighted sum of the neighbours' values_of(state)[first + i].
template <class ValuesOf>
void mix_values(const OperatingGrid& grid, const GridPlace& place, ValuesOf values_of, int first, int count,
                double* out) noexcept {
  std::fill(out, out + count, 0.0);
  dsp::with_widest<dsp::Passes>([&](auto passes) {
    for (std::size_t n = 0; n < place.index.size(); ++n)
      if (place.weight[n] != 0)
        passes.add_scaled(place.weight[n], values_of(grid.state(place.index[n])).data() + first, count, out);
  });
}

}  // namespace

OperatingGrid::OperatingGrid(const DieselModel& model, double sample_rate) : loads_(load_axis(model)) {
  const SourceMap sources(model);
  rpm_min_ = kBelow * std::min(sources.held(0), kTop_rpm);
  speeds_ = 1 + static_cast<int>(std::ceil(kPerOctave * dsp::log(kTop_rpm / rpm_min_) / dsp::kLn2));
  OrderTables tables(model, sample_rate);
  for (const double load : loads_) {
    std::optional<Source> source;
    double held_rpm = 0;
    for (int i = 0; i < speeds_; ++i) {
      const double rpm = rpm_min_ * dsp::exp(dsp::kLn2 * i / kPerOctave);
      if (const double held = sources.held(rpm); !source || held != held_rpm)
        source.emplace(sources.at(rpm, load)), held_rpm = held;
      tables.put(states_.size() % 2 == 1, source->orders, cycles_per_second(rpm));
      states_.push_back({{}, with_body(model, source->lo, rpm), source->slots});
      if (states_.size() % 2 == 0) tables.take(states_[states_.size() - 2].table, states_.back().table);
    }
  }
  if (states_.size() % 2 == 1) {
    std::vector<float> nothing;
    tables.take(states_.back().table, nothing);
  }
}

GridPlace OperatingGrid::place(double rpm, double load) const noexcept {
  const double octaves = dsp::log(std::max(rpm, 1.0) / rpm_min_) / dsp::kLn2;
  const double at = std::clamp(octaves * kPerOctave, 0.0, speeds_ - 1.0);
  const int i = std::min(static_cast<int>(at), std::max(0, speeds_ - 2));
  const double speed_way = at - i;
  const int next = std::min(i + 1, speeds_ - 1);

  std::size_t row = 0;
  while (row + 2 < loads_.size() && loads_[row + 1] <= load) ++row;
  const std::size_t upper = std::min(row + 1, loads_.size() - 1);
  const double span = loads_[upper] - loads_[row];
  const double load_way = span > 0 ? std::clamp((load - loads_[row]) / span, 0.0, 1.0) : 0.0;

  const int a = static_cast<int>(row) * speeds_, b = static_cast<int>(upper) * speeds_;
  return {{a + i, a + next, b + i, b + next},
          {(1 - load_way) * (1 - speed_way), (1 - load_way) * speed_way, load_way * (1 - speed_way),
           load_way * speed_way}};
}

void OperatingGrid::mix(const GridPlace& place, std::vector<float> OperatingState::*member, int first,
                        int count, double* out) const noexcept {
  const auto values = [member](const OperatingState& s) -> const auto& { return s.*member; };
  mix_values(*this, place, values, first, count, out);
}

void OperatingGrid::mix(const GridPlace& place, std::vector<float> SlotStatistics::*member, int first,
                        int count, double* out) const noexcept {
  const auto values = [member](const OperatingState& s) -> const auto& { return (*s.slots).*member; };
  mix_values(*this, place, values, first, count, out);
}

void OperatingGrid::table(const GridPlace& place, int first, int count, float* out) const noexcept {
  std::fill(out, out + count, 0.0F);
  for (std::size_t n = 0; n < place.index.size(); ++n) {
    if (place.weight[n] == 0) continue;
    const float* const values = state(place.index[n]).table.data() + first;
    const auto weight = static_cast<float>(place.weight[n]);
    int i = 0;
    for (; i + 3 < count; i += 4)
      dsp::store_floats(out + i, dsp::load_floats(out + i) + weight * dsp::load_floats(values + i));
    for (; i < count; ++i) out[i] += weight * values[i];
  }
}

double OperatingGrid::rho(const GridPlace& place) const noexcept {
  double sum = 0;
  for (std::size_t n = 0; n < place.index.size(); ++n)
    sum += place.weight[n] * state(place.index[n]).slots->rho;
  return sum;
}

}  // namespace rigsound::diesel
