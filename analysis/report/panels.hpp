// The charts of one bank.
#pragma once

#include <string>

#include "bank/segment.hpp"
#include "rigsound/click_bank.hpp"

namespace rigsound::analysis {

/// Spectrograms of the recording, of what was taken away, and of what is left. Thread: OFF, and so are the
/// others.
std::string spectrogram_panels(const std::vector<float>& recorded, const ChainResult& segment);
/// The first second: recording, drilling, and a line at every detected click.
std::string waveform_panel(const std::vector<float>& recorded, const ChainResult& segment);
/// Mean level after a click against the envelope that was fitted.
std::string envelope_panel(const ChainResult& segment);
/// Every click of the bank.
std::string click_panels(const ClickBank& bank);
/// What was measured against the distributions the engine draws from.
std::string gap_panel(const Segments& segments, const ClickBank& bank);
std::string amplitude_panel(const Segments& segments, const ClickBank& bank);
/// Recorded against resynthesised.
std::string third_octave_panel(const Segments& segments, const std::vector<float>& synthesis);
std::string modulation_panel(const Segments& segments, const std::vector<float>& synthesis);

}  // namespace rigsound::analysis
