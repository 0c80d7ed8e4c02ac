#include <doctest/doctest.h>

#include <cmath>

#include "diesel/order_tables.hpp"
#include "engine/heard.hpp"

using namespace rigsound;
using namespace rigsound::diesel;
using namespace rigsound::tests;

namespace {

DieselModel plain_model() {
  DieselModel model;
  model.angle_samples = 1024;
  return model;
}

/// sum over k of e^level cos(2 pi k n / N + phase)
double sum_of_orders(const SourcePoint& source, int n, int N) {
  double sum = 0;
  for (std::size_t k = 1; k <= source.level.size(); ++k)
    sum += std::exp(source.level[k - 1]) *
           std::cos(2 * M_PI * static_cast<double>(k) * n / N + source.phase[k - 1]);
  return sum;
}

void check_table(const std::vector<float>& table, const SourcePoint& source) {
  const int N = static_cast<int>(table.size());
  double worst = 0;
  for (int n = 0; n < N; ++n)
    worst = std::max(worst, std::fabs(static_cast<double>(table[static_cast<std::size_t>(n)]) -
                                      sum_of_orders(source, n, N)));
  CHECK(worst < 1e-6);
}

}  // namespace

TEST_CASE("two states share a transform, and each table is the sum of its own orders") {
  SourcePoint slow, fast;
  slow.level = {-0.5, -2, -1}, slow.phase = {0.3, -2.1, 1.4};
  fast.level = {-1, -0.2, -3, -0.7}, fast.phase = {2.8, 0.6, -0.9, -3};
  const DieselModel model = plain_model();
  OrderTables tables(model, kRate);
  std::vector<float> first, second;
  tables.put(false, OrderTables::Source(slow), 5);
  tables.put(true, OrderTables::Source(fast), 7);
  tables.take(first, second);
  check_table(first, slow);
  check_table(second, fast);

  tables.put(false, OrderTables::Source(fast), 7);
  tables.take(first, second);
  check_table(first, fast);
  for (const float nothing : second) CHECK(std::fabs(nothing) < 1e-14F);
}

TEST_CASE("no order of a table folds over") {
  SourcePoint high;
  high.level.assign(400, 0.0), high.phase.assign(400, 0.0);
  const DieselModel model = plain_model();
  OrderTables tables(model, kRate);
  std::vector<float> table, none;
  const double f = 100;  // order 220 lies at 22 kHz, where no order is left
  tables.put(false, OrderTables::Source(high), f);
  tables.take(table, none);
  double re = 0, im = 0;
  for (std::size_t n = 0; n < table.size(); ++n) {
    const double angle = 2 * M_PI * 221 * static_cast<double>(n) / 1024;
    re += static_cast<double>(table[n]) * std::cos(angle),
        im += static_cast<double>(table[n]) * std::sin(angle);
  }
  CHECK(std::hypot(re, im) / 512 < 1e-6);  // one that sounds has 1
}
