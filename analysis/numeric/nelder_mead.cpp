#include "numeric/nelder_mead.hpp"

#include <nlopt.h>

#include <algorithm>
#include <memory>

namespace rigsound::analysis {
namespace {

struct Problem {
  const std::function<double(const std::vector<double>&)>* cost;
  std::vector<double> at;
};

double evaluate(unsigned size, const double* x, double*, void* data) {
  auto& problem = *static_cast<Problem*>(data);
  problem.at.assign(x, x + size);
  return (*problem.cost)(problem.at);
}

}  // namespace

std::vector<double> nelder_mead(const std::function<double(const std::vector<double>&)>& cost,
                                std::vector<double> start, const SimplexOptions& options) {
  const auto size = static_cast<unsigned>(start.size());
  for (unsigned k = 0; k < size; ++k) start[k] = std::clamp(start[k], options.lower[k], options.upper[k]);
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> search(nlopt_create(NLOPT_LN_NELDERMEAD, size),
                                                                      &nlopt_destroy);
  Problem problem{&cost, start};
  nlopt_set_min_objective(search.get(), evaluate, &problem);
  nlopt_set_lower_bounds(search.get(), options.lower.data());
  nlopt_set_upper_bounds(search.get(), options.upper.data());
  nlopt_set_initial_step(search.get(), options.step.data());
  nlopt_set_xtol_abs(search.get(), options.tolerance.data());
  nlopt_set_maxeval(search.get(), options.evaluations);
  double least = 0;
  nlopt_optimize(search.get(), start.data(), &least);
  return start;
}

}  // namespace rigsound::analysis
