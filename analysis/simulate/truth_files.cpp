#include "simulate/truth_files.hpp"

#include <fmt/format.h>

#include "rigsound/analysis/chain.hpp"
#include "rigsound/file/atomic_file.hpp"

namespace rigsound::analysis {

void write_clicks_csv(const std::filesystem::path& path, const std::vector<SimulatedClick>& clicks) {
  std::string text = "time_s,amplitude,kind\n";
  for (const SimulatedClick& c : clicks)
    text += fmt::format("{:.6f},{:.6f},{}\n", c.P / kAnalysisRate, c.beta, static_cast<int>(c.kind));
  write_file(path, text);
}

void write_envelope_csv(const std::filesystem::path& path, const ClickEnvelope& envelope, int length) {
  std::string text = "time_s,envelope\n";
  const std::vector<double> a = envelope_curve(envelope, length);
  for (std::size_t n = 0; n < a.size(); ++n)
    text += fmt::format("{:.6f},{:.6g}\n", static_cast<double>(n) / kAnalysisRate, a[n]);
  write_file(path, text);
}

void write_parameters_csv(const std::filesystem::path& path, const SituationRecording& r) {
  write_file(path, fmt::format(
                       "key,value\nF0_hz,{:.6f}\nT_0,{:.4f}\njitter,{}\namplitude_cv,{}\nmiss,{}\ndouble,{}\n"
                       "N_a,{}\nalpha_a,{:.9g}\nalpha_d,{:.9g}\nrpm,{}\n",
                       r.rate_hz, r.process.T0(), r.process.jitter, r.process.amplitude_cv, r.process.miss,
                       r.process.twice, r.envelope.N_a, r.envelope.alpha_a, r.envelope.alpha_d, r.rpm));
}

void write_labels(const std::filesystem::path& path, const SituationRecording& r) {
  std::string text;
  for (const SimulatedPart& part : r.parts)
    text +=
        fmt::format("{:.6f}\t{:.6f}\t{} rods=1 rpm={:.0f}\n", part.start, part.end, name(r.situation), r.rpm);
  write_file(path, text);
}

void write_rpm_csv(const std::filesystem::path& path, const std::vector<double>& rpm) {
  constexpr std::size_t kEvery = 4800;  // 0.1 s
  std::string text = "time_s,rpm\n";
  for (std::size_t n = 0; n < rpm.size(); n += kEvery)
    text += fmt::format("{:.1f},{:.2f}\n", static_cast<double>(n) / kAnalysisRate, rpm[n]);
  write_file(path, text);
}

}  // namespace rigsound::analysis
