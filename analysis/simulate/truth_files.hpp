// The truth beside a simulated recording, as CSV and labels.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "simulate/drilling_laws.hpp"
#include "simulate/situation_recording.hpp"

namespace rigsound::analysis {

void write_clicks_csv(const std::filesystem::path& path, const std::vector<SimulatedClick>& clicks);
void write_envelope_csv(const std::filesystem::path& path, const ClickEnvelope& envelope, int length);
void write_parameters_csv(const std::filesystem::path& path, const SituationRecording& recording);
void write_labels(const std::filesystem::path& path, const SituationRecording& recording);

/// The laws of the simulated drill every 5 bar from 20 to 220 bar. level_db is that of the mean click's L2
/// norm, rms_db that of the drilling, both re full scale; brightness_hz is the root mean square frequency.
void write_laws_csv(const std::filesystem::path& path, const DrillingLaws& laws, int rods);

/// key,value of the slopes over the feed, 1/bar, with the keys of [[laws]] in soundset.toml.
void write_slopes_csv(const std::filesystem::path& path, const FeedLaws& slopes);

/// time_s,`what` every 0.1 s of a series at kAnalysisRate.
void write_track_csv(const std::filesystem::path& path, const std::string& what,
                     const std::vector<double>& track);

/// frequency_hz,gain_db of the simulated diesel's body, 30 Hz...16 kHz in 1/18 octaves.
void write_body_csv(const std::filesystem::path& path);

}  // namespace rigsound::analysis
