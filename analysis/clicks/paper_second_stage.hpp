// Sections 3.3 to 3.5 of the drilling paper: detection with the click's own envelope, and the envelope
// refined.
#pragma once

#include "clicks/paper_first_stage.hpp"

namespace rigsound::analysis {

struct PaperClicks {
  std::vector<long> P;
  std::vector<double> beta;
};

/// Section 3.3: for every peak of the first stage the maximum of e_n with w_n = a_n (half a mean gap long)
/// over [P_l - N_a, P_r - N_a]; of two closer than half the median gap the weaker goes. beta = sqrt(e(P)/sum
/// a^4). Thread: OFF.
PaperClicks paper_detection(const Eigen::ArrayXd& y, const std::vector<EnergyPeak>& peaks,
                            const ClickEnvelope& envelope);

/// Section 3.4's flatness: variance over squared mean of the Hann energy (1024 samples) of z = y/g, with
/// g = sqrt(sum beta^2 a^2(n - P)), never below a tenth of the median beta. Thread: OFF.
double flatness(const Eigen::ArrayXd& y, const PaperClicks& clicks, const ClickEnvelope& envelope);

/// Section 3.4: the envelope of least flatness, by the simplex method from `start`, with N_a >= 2 and alpha_d
/// > 0. Thread: OFF.
ClickEnvelope paper_envelope(const Eigen::ArrayXd& y, const PaperClicks& clicks, const ClickEnvelope& start);

/// Sections 3.2 to 3.5; fewer than three clicks when there are no peaks to speak of. y: whitened, RMS 1.
/// Thread: OFF.
ClickTrain paper_clicks(const Eigen::ArrayXd& y);

}  // namespace rigsound::analysis
