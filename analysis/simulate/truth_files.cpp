#include "simulate/truth_files.hpp"

#include <fmt/format.h>

#include <cmath>

#include "rigsound/analysis/rate.hpp"
#include "rigsound/file/atomic_file.hpp"
#include "simulate/diesel_body.hpp"
#include "simulate/drilling_click.hpp"

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
                       "N_a,{}\nalpha_a,{:.9g}\nalpha_d,{:.9g}\nrpm,{}\nrods,{}\nfeed_bar,{}\n",
                       r.rate_hz, r.process.T0(), r.process.jitter, r.process.amplitude_cv, r.process.miss,
                       r.process.twice, r.envelope.attack_samples, r.envelope.attack_bend, r.envelope.decay,
                       r.rpm, r.rods, r.feed_bar));
}

void write_labels(const std::filesystem::path& path, const SituationRecording& r) {
  std::string pressures, text;
  if (r.feed_bar > 0)
    pressures = fmt::format(" feed={:.0f} percussion={:.0f}", r.feed_bar, DrillingLaws::kPercussion_bar);
  for (const SimulatedPart& part : r.parts)
    text += fmt::format("{:.6f}\t{:.6f}\t{} rods={} rpm={:.0f}{}\n", part.start, part.end, name(r.situation),
                        r.rods, r.rpm, pressures);
  write_file(path, text);
}

void write_laws_csv(const std::filesystem::path& path, const DrillingLaws& laws, int rods) {
  std::string text =
      "feed_bar,rate_hz,level_db,rms_db,alpha_d,decay_s,brightness_hz,tilt_db_per_octave,ring_share,miss,"
      "gap_variation,amplitude_variation,rpm\n";
  for (double feed = 20; feed <= 220; feed += 5) {
    const DrillingPoint p = laws.at(feed, rods);
    const double made_hz = p.rate_hz * (1 - p.miss_share), squares = 1 + p.norm_variation * p.norm_variation;
    const double rms = p.norm * std::sqrt(squares * made_hz / kAnalysisRate);
    text += fmt::format(
        "{},{:.5f},{:.4f},{:.4f},{:.6g},{:.5f},{:.1f},{:.3f},{:.4f},{:.5f},{:.5f},{:.5f},{:.1f}\n", feed,
        p.rate_hz, 20 * std::log10(p.norm), 20 * std::log10(rms), p.decay,
        std::log(1000.0) / p.decay / kAnalysisRate, brightness_hz(p, rods), p.tilt_db_per_octave,
        p.ring_share, p.miss_share, p.gap_variation, p.norm_variation, p.diesel_rpm);
  }
  write_file(path, text);
}

void write_slopes_csv(const std::filesystem::path& path, const FeedLaws& slopes) {
  write_file(path, fmt::format("key,value\nln_gap,{}\nln_level,{}\nln_decay,{}\ngap_variation,{}\n"
                               "amplitude_variation,{}\ntilt_db_per_octave,{}\n",
                               slopes.ln_gap, slopes.ln_level, slopes.ln_decay, slopes.gap_variation,
                               slopes.amplitude_variation, slopes.tilt_db_per_octave));
}

void write_track_csv(const std::filesystem::path& path, const std::string& what,
                     const std::vector<double>& track) {
  constexpr std::size_t kEvery = 4800;  // 0.1 s
  std::string text = fmt::format("time_s,{}\n", what);
  const auto row = [&](std::size_t n) {
    text += fmt::format("{:.6g},{:.3f}\n", static_cast<double>(n) / kAnalysisRate, track[n]);
  };
  for (std::size_t n = 0; n < track.size(); n += kEvery) row(n);
  if (!track.empty()) row(track.size() - 1);
  write_file(path, text);
}

void write_body_csv(const std::filesystem::path& path) {
  std::string text = "frequency_hz,gain_db\n";
  for (double f_hz = 30; f_hz < 16000; f_hz *= std::exp2(1.0 / 18))
    text += fmt::format("{:.2f},{:.3f}\n", f_hz, simulated_body_db(f_hz));
  write_file(path, text);
}

}  // namespace rigsound::analysis
