// The truth beside a simulated recording, as CSV and labels.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "simulate/situation_recording.hpp"

namespace rigsound::analysis {

void write_clicks_csv(const std::filesystem::path& path, const std::vector<SimulatedClick>& clicks);
void write_envelope_csv(const std::filesystem::path& path, const ClickEnvelope& envelope, int length);
void write_parameters_csv(const std::filesystem::path& path, const SituationRecording& recording);
void write_labels(const std::filesystem::path& path, const SituationRecording& recording);

/// time_s,`what` every 0.1 s of a series at kAnalysisRate.
void write_track_csv(const std::filesystem::path& path, const std::string& what,
                     const std::vector<double>& track);

/// frequency_hz,gain_db of the simulated diesel's body, 30 Hz...16 kHz in 1/18 octaves.
void write_body_csv(const std::filesystem::path& path);

}  // namespace rigsound::analysis
