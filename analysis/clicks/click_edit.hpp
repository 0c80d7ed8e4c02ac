// Step 5, the count: weak clicks are pruned, missed ones added, by likelihood ratio.
#pragma once

#include "clicks/variance_model.hpp"

namespace rigsound::analysis {

constexpr double kEvidenceToKeep = 6;  ///< nats that a click is worth, usually

/// Rise of the negative log-likelihood if click i were taken out and the others stayed, nats at `block`
/// samples a block. Thread: OFF.
double removal_cost(const Eigen::ArrayXd& q, const Eigen::ArrayXd& v, const Eigen::ArrayXd& a2, long onset,
                    double power, int block);

struct Addition {
  long onset = 0;    ///< blocks
  double power = 0;  ///< beta^2
  double gain = 0;   ///< fall of the negative log-likelihood, nats
};

/// The best click within three blocks of `block_at`, given the variance of the others. Thread: OFF.
Addition best_addition(const Eigen::ArrayXd& q, const Eigen::ArrayXd& v, const Eigen::ArrayXd& a2,
                       long block_at, int block);

/// Takes out clicks, weakest evidence first, that are worth less than kEvidenceToKeep (0.5 where a gap of
/// over 1.5 T_0 would be left), lie closer than 0.28 T_0 to a stronger one, or hold under 1 % of the median
/// power. T_0 in blocks. Thread: OFF.
void remove_weak_clicks(const Eigen::ArrayXd& q, const EnvelopePower& shape, double T_0, int block,
                        ModelClicks& clicks);

/// Adds candidates (blocks) at least 0.30 T_0 from every click and worth over 5 nats in a gap of over 1.45
/// T_0, or over 25 elsewhere. Thread: OFF.
void add_missed_clicks(const Eigen::ArrayXd& q, const EnvelopePower& shape, double T_0, int block,
                       const std::vector<long>& candidates, ModelClicks& clicks);

}  // namespace rigsound::analysis
