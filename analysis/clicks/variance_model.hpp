// Step 5: the whitened signal as noise whose variance follows the click train, y_n ~ N(0, v_n).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "clicks/envelope.hpp"
#include "clicks/train_power.hpp"

namespace rigsound::analysis {

/// A block's power never counts as more than this multiple of its modelled variance: outliers.
constexpr double kOutlierClip = 200;

/// The clicks of the model on blocks of one size.
struct ModelClicks {
  std::vector<long> onset;  ///< P_i, blocks, ascending
  Eigen::ArrayXd power;     ///< beta_i^2
  double floor = 0;         ///< variance between clicks
  Eigen::ArrayXd others;    ///< variance of what else is known to sound, a block; empty: nothing
};

/// Ascending samples as blocks of `block` of them. Thread: OFF.
std::vector<long> onsets_in_blocks(const std::vector<int>& P, int block);

/// Where powers and floor begin: all clicks alike, and a floor out of the pauses. Thread: OFF.
void set_first_powers(const Eigen::ArrayXd& q, ModelClicks& clicks);

/// v_n: of the clicks, the floor and the others. Thread: OFF.
void model_variance(const TrainPower& train, const ModelClicks& clicks, Eigen::ArrayXd& v);

/// The same of clicks of one shape, over `length` blocks. Thread: OFF.
Eigen::ArrayXd model_variance(const EnvelopePower& shape, const ModelClicks& clicks, long length);

/// sum of ln w + q / w: twice the negative log-likelihood per sample of a block. Thread: OFF.
double divergence(const Eigen::Ref<const Eigen::ArrayXd>& q, const Eigen::Ref<const Eigen::ArrayXd>& w);

/// 1/2 block sum(ln v + min(q/v, kOutlierClip)): the negative log-likelihood. Thread: OFF.
double model_cost(const Eigen::ArrayXd& q, const Eigen::ArrayXd& v, int block);

/// `sweeps` multiplicative updates of every beta_i^2 and of the floor towards the likelihood's maximum: the
/// first takes the full ratio for the powers, the others its root (monotone). Thread: OFF.
void update_powers(const Eigen::ArrayXd& q, const TrainPower& train, int sweeps, double clip,
                   ModelClicks& clicks);

/// Puts the clicks in order of onset. Thread: OFF.
void sort_clicks(ModelClicks& clicks);

/// Takes click i out. Thread: OFF.
void remove_click(ModelClicks& clicks, size_t i);

}  // namespace rigsound::analysis
