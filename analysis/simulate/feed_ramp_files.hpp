// A recording along a feed ramp, with the bus beside it and the laws it follows.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace rigsound::analysis {

/// feed/ramp.wav, .txt (labels) and .log (bus) under `folder`, and under truth/ feed_ramp_*.wav and .csv:
/// clean, background, clicks, the feed over time, the laws over the feed and their slopes. The folders exist.
/// `seconds`
/// >= 10. Errors: DeviceError. Thread: OFF.
std::vector<std::string> write_ramp(const std::filesystem::path& folder, std::uint64_t seed, double seconds);

}  // namespace rigsound::analysis
