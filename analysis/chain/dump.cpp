#include "chain/dump.hpp"

#include <fmt/format.h>

#include "rigsound/analysis/rate.hpp"
#include "rigsound/analysis/wave_file.hpp"
#include "rigsound/file/atomic_file.hpp"
#include "rigsound/file/make_folders.hpp"

namespace rigsound::analysis {

Dump::Dump(std::filesystem::path folder) : folder_(std::move(folder)) {
  if (!folder_.empty()) make_folders(folder_);
}

void Dump::signal(const std::string& name, const Eigen::ArrayXd& samples) const {
  if (folder_.empty()) return;
  write_wave(folder_ / (name + ".wav"), std::vector<double>(samples.begin(), samples.end()),
             static_cast<int>(kAnalysisRate));
}

void Dump::table(const std::string& name, const std::string& header, const Eigen::ArrayXXd& table) const {
  if (folder_.empty()) return;
  std::string text = header + "\n";
  for (const auto& row : table.rowwise()) {
    for (long c = 0; c < row.size(); ++c) text += fmt::format(c ? ",{:.9g}" : "{:.9g}", row(c));
    text += "\n";
  }
  write_file(folder_ / (name + ".csv"), text);
}

void Dump::train(const std::string& name, const ClickTrain& train) const {
  Eigen::ArrayXXd clicks(train.P.size(), 2);
  for (long i = 0; i < clicks.rows(); ++i) clicks.row(i) << train.P[i] / kAnalysisRate, train.beta[i];
  table(name + "_clicks", "time_s,beta", clicks);
  Eigen::ArrayXXd envelope(1, 4);
  envelope << train.envelope.attack_samples, train.envelope.attack_bend, train.envelope.decay,
      train.mean_gap_samples;
  table(name + "_envelope", "N_a,alpha_a,alpha_d,T_0", envelope);
}

}  // namespace rigsound::analysis
