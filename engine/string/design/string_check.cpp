#include "field_check.hpp"
#include "rigsound/string_model.hpp"

namespace rigsound {
namespace {

constexpr double kThickestRod = 0.1;  // diameter of a rod, as a share of its length

}  // namespace

void require_valid(const StringModel& m) {
  const FieldCheck check(m.name.empty() ? "" : "string \"" + m.name + "\": ");
  check.ranges(m);
  check.at_most(kThickestRod * m.rod_length_m, "a tenth of rod_length_m", m.rod_diameter_m, "rod_diameter_m");
  check.at_most(m.string_low_s, "string_low_s", m.string_high_s, "string_high_s");
  check.at_most(m.bending_low_s, "bending_low_s", m.bending_high_s, "bending_high_s");
  check.at_most(m.bending_low_s, "bending_low_s", m.contact_low_s, "contact_low_s");
  check.at_most(m.contact_low_s, "contact_low_s", m.contact_high_s, "contact_high_s");
  check.at_most(m.bending_high_s, "bending_high_s", m.contact_high_s, "contact_high_s");
}

}  // namespace rigsound
