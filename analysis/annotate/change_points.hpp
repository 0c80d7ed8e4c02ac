// Changes of the mean of a series of vectors, by penalised likelihood.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace rigsound::analysis {

/// From `first` on the mean is another; `gain`: of twice the log-likelihood over its neighbours' being one.
struct ChangePoint {
  long first = 0;
  double gain = 0;
};

/// Series whose noise is white with variance 1 in every row: whitening_of() times the series.
/// The partition that minimises the squared deviations from the means of its segments plus `penalty` a
/// change, no segment shorter than `shortest` columns (Killick, Fearnhead, Eckley 2012: PELT; exact). `each`
/// is called once a column. Thread: OFF.
std::vector<ChangePoint> change_points(const Eigen::ArrayXXd& white, double penalty, long shortest,
                                       const std::function<void(long)>& each = {});

/// What makes the noise of a series white with variance 1, for sums over many columns: from the differences
/// of means of neighbouring blocks, each bounded by three times their median, so that changes count little;
/// shrunk to its diagonal where blocks are few. `floor`: least standard deviation a column, row by row.
/// Thread: OFF.
Eigen::MatrixXd whitening_of(const Eigen::ArrayXXd& series, long block, const Eigen::ArrayXd& floor);

}  // namespace rigsound::analysis
