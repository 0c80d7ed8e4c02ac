// The truth beside a simulated recording, as CSV and labels.
#pragma once

#include <filesystem>

#include "simulate/situation_recording.hpp"

namespace rigsound::analysis {

void write_clicks_csv(const std::filesystem::path& path, const std::vector<SimulatedClick>& clicks);
void write_envelope_csv(const std::filesystem::path& path, const ClickEnvelope& envelope, int length);
void write_parameters_csv(const std::filesystem::path& path, const SituationRecording& recording);
void write_labels(const std::filesystem::path& path, const SituationRecording& recording);
void write_rpm_csv(const std::filesystem::path& path, const std::vector<double>& rpm);

}  // namespace rigsound::analysis
