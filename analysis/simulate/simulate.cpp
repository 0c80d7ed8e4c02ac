#include "rigsound/analysis/simulate.hpp"

#include <fmt/format.h>

#include <cmath>

#include "rigsound/analysis/rate.hpp"
#include "rigsound/analysis/wave_file.hpp"
#include "rigsound/file/make_folders.hpp"
#include "rigsound/machine/input_error.hpp"
#include "rigsound/number_of.hpp"
#include "simulate/diesel_files.hpp"
#include "simulate/drillbench_clip.hpp"
#include "simulate/feed_ramp_files.hpp"
#include "simulate/truth_files.hpp"

namespace rigsound::analysis {
namespace fs = std::filesystem;

namespace {

constexpr int kRate = static_cast<int>(kAnalysisRate);
constexpr double kBenchGain = 0.05;  // RMS 1 would clip: one gain for all, ratios stay

std::vector<double> mixed(const std::vector<double>& a, const std::vector<double>& b, double gain_b,
                          double gain) {
  std::vector<double> sum(a.size());
  for (std::size_t n = 0; n < a.size(); ++n) sum[n] = gain * (a[n] + gain_b * b[n]);
  return sum;
}

std::vector<double> scaled(std::vector<double> x, double gain) {
  for (double& v : x) v *= gain;
  return x;
}

double number(const std::string& text) {
  const auto value = number_of<double>(text);
  if (!value || !std::isfinite(*value))
    throw InputError("--snr", "'" + text + "' is not a ratio, expected decibels such as -6,0,6,12");
  return *value;
}

/// Under `folder`/`place`, its truth under `folder`/truth.
std::string write_situation(const fs::path& folder, const fs::path& place, const std::string& stem,
                            const SituationRecording& r) {
  const fs::path truth = folder / "truth";
  write_wave(truth / (stem + "_clean.wav"), r.clean, kRate);
  write_wave(truth / (stem + "_background.wav"), r.background, kRate);
  write_clicks_csv(truth / (stem + "_truth.csv"), r.clicks);
  ClickVoice voice;
  voice.envelope = r.envelope;
  write_envelope_csv(truth / (stem + "_envelope.csv"), r.envelope, voice.length());
  write_parameters_csv(truth / (stem + "_parameters.csv"), r);
  write_labels(folder / place / (stem + ".txt"), r);
  write_wave(folder / place / (stem + ".wav"), mixed(r.clean, r.background, 1, 1), kRate);
  return fmt::format("{}.wav parts={} clicks={} rate_hz={:.2f} rpm={:.0f}", (place / stem).string(),
                     r.parts.size(), r.clicks.size(), r.rate_hz, r.rpm);
}

}  // namespace

std::vector<std::string> write_situations(const fs::path& folder, std::uint64_t seed, double seconds,
                                          const Progress& progress) {
  constexpr double kDiesel = 0.4;  // of the work, roughly
  make_folders(folder / "truth");
  make_folders(folder / "engine");
  std::vector<std::string> lines;
  for (int i = 0; i < kSituationCount; ++i) {
    const auto situation = static_cast<Situation>(i);
    lines.push_back(write_situation(folder, {}, std::string(name(situation)),
                                    simulate_situation(situation, seed, seconds)));
    if (progress) progress((1 - kDiesel) * (i + 1) / kSituationCount);
  }
  for (std::string& line : write_diesel(folder, {seed})) lines.push_back(std::move(line));
  return lines;
}

std::vector<std::string> write_feed_ramp(const fs::path& folder, std::uint64_t seed, double seconds) {
  make_folders(folder / "truth");
  make_folders(folder / "feed");
  return write_ramp(folder, seed, seconds);
}

std::vector<std::string> write_rods(const fs::path& folder, std::uint64_t seed,
                                    const std::vector<int>& counts, double seconds,
                                    const Progress& progress) {
  make_folders(folder / "truth");
  make_folders(folder / "rods");
  std::vector<std::string> lines;
  for (const int rods : counts)
    for (const Situation s : {Situation::kUnderfeed, Situation::kNormal, Situation::kOverfeed}) {
      lines.push_back(write_situation(folder, "rods", fmt::format("rods{}_{}", rods, name(s)),
                                      simulate_situation(s, seed, seconds, rods)));
      show(progress, lines.size(), 3 * counts.size());
    }
  return lines;
}

std::vector<std::string> write_drillbench(const fs::path& folder, const DrillBenchRequest& request,
                                          const Progress& progress) {
  std::vector<double> ratios;
  for (const std::string& text : request.snr_db) ratios.push_back(number(text));
  for (const int id : request.ids)
    if (!drillbench_id(id))
      throw InputError("--ids",
                       fmt::format("clip {} does not exist, expected the last two digits to be 00-31", id));
  make_folders(folder);
  std::vector<std::string> lines;
  for (const int id : request.ids) {
    const DrillBenchClip clip = drillbench_clip(id, request.seconds, request.rate_factor);
    const std::vector<double> background = drillbench_background(id, request.seconds);
    const fs::path stem = folder / fmt::format("c{:03}", id);
    const auto file = [&](const std::string& what) { return fs::path(stem.string() + "_" + what); };
    write_wave(file("clean.wav"), scaled(clip.clean, kBenchGain), kRate);
    write_wave(file("bg.wav"), scaled(background, kBenchGain), kRate);
    for (std::size_t i = 0; i < ratios.size(); ++i)
      write_wave(file(request.snr_db[i] + ".wav"),
                 mixed(clip.clean, background, std::pow(10, -ratios[i] / 20), kBenchGain), kRate);
    write_clicks_csv(file("truth.csv"), clip.clicks);
    lines.push_back(fmt::format("c{:03} clicks={} T_0={:.2f} N_a={:.0f} alpha_a={:.6g} alpha_d={:.6g}", id,
                                clip.clicks.size(), clip.T0, clip.envelope.attack_samples,
                                clip.envelope.attack_bend, clip.envelope.decay));
    show(progress, lines.size(), request.ids.size());
  }
  return lines;
}

}  // namespace rigsound::analysis
