// Every fixed size of the real-time engine, in one place.
#pragma once

#include "rigsound/machine/fields.hpp"

namespace rigsound {

/// Frames the engine computes at a time. A block is a whole number of chunks; inside a block every
/// layer works chunk by chunk, so the same state gives the same samples whatever the block size.
constexpr int kChunk = 32;

constexpr int kMaxBlock = 8192;         ///< frames a block
constexpr int kMaxChannels = 8;         ///< output channels
constexpr int kMaxBooms = 4;            ///< drills on one rig
constexpr int kMaxVoices = 64;          ///< clicks sounding at once, per boom and situation
constexpr int kLeastLookahead = 3;      ///< chunks, of a limiter that looks ahead at all
constexpr int kMaxImpacts = 16;         ///< impacts that may start in one chunk, per boom
constexpr float kMaxSpeedSlope = 6000;  ///< r/min a second; no flywheel is faster
constexpr double kMinSampleRate = 32000.0;
constexpr double kMaxSampleRate = 192000.0;

constexpr Range kSampleRates{kMinSampleRate, kMaxSampleRate, "Hz"};
constexpr Range kBlocks = Range{kChunk, kMaxBlock, "frames"}.multiples_of(kChunk);
constexpr Range kChannelCounts = Range{1, kMaxChannels}.whole();
constexpr Range kIdleSpeeds{100, 4000, "r/min"};
constexpr Range kBusScales{-1e9, 1e9};  ///< of scale and offset of a value on a bus

constexpr double kHighestCorner = 0.45;  ///< of a filter, as a share of the sample rate

}  // namespace rigsound
