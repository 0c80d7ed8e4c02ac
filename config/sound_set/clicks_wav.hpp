// clicks.wav: clicks end to end, a cue point at the start of each.
#pragma once

#include <filesystem>
#include <vector>

#include "rigsound/click.hpp"
#include "sound_set/click_store.hpp"

namespace rigsound::config {

using Clicks = std::vector<Click>;

/// Mono float WAV, reproducible byte for byte. Errors: DeviceError.
void write_clicks_wav(const std::filesystem::path& file, const Clicks& clicks, int sample_rate);

/// Clicks of unit L2 norm in `store`, one from each cue point to the next. Any sample format, so that a bank
/// edited in an audio editor still loads. Errors: InputError for another rate than `sample_rate`, more than
/// one channel, samples that are not finite, a silent click, no cue point, cue points out of order.
Clicks read_clicks_wav(const std::filesystem::path& file, int sample_rate, ClickStore& store);

}  // namespace rigsound::config
