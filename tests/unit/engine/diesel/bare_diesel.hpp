// A model that makes no sound unless a test asks for some.
#pragma once

#include "rigsound/diesel_model.hpp"

namespace rigsound::tests {

/// One flat point: nothing but what is added to it.
inline DieselModel bare_diesel(double rpm) {
  DieselModel m;
  m.body_filter = {1.0F};
  DieselPoint p;
  p.rpm = rpm;
  p.low_variance.assign(static_cast<std::size_t>((m.low_scales + 1) * m.low_channels), 0.0F);
  p.slot_variance.assign(static_cast<std::size_t>(m.slots) * (slot_band_edges(m.slot_samples()).size() - 1),
                         0.0F);
  p.slot_log_variance.assign(static_cast<std::size_t>(m.slots), 0.0F);
  m.points = {p};
  return m;
}

}  // namespace rigsound::tests
