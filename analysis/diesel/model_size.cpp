#include "rigsound/analysis/diesel.hpp"

namespace rigsound::analysis {

std::size_t parameter_count(const DieselModel& model) {
  std::size_t count = model.body_filter.size() + model.body.db.size() + 4 * model.oscillators.size() +
                      model.hydraulic.pump.size() + model.hydraulic.flow_filter.size() + 12;
  for (const DieselPoint& p : model.points)
    count +=
        2 * p.orders.size() + p.low_variance.size() + p.slot_variance.size() + p.slot_log_variance.size() + 3;
  return count;
}

}  // namespace rigsound::analysis
