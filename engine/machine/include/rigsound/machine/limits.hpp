// Every fixed size of the real-time engine, in one place.
#pragma once

namespace rigsound {

/// Frames the engine computes at a time. A block is a whole number of chunks; inside a block every
/// layer works chunk by chunk, so the same state gives the same samples whatever the block size.
constexpr int kChunk = 32;

constexpr int kMaxBlock = 8192;         ///< frames a block
constexpr int kMaxChannels = 8;         ///< output channels
constexpr int kMaxBooms = 4;            ///< drills on one rig
constexpr int kMaxVoices = 64;          ///< clicks sounding at once, per boom and situation
constexpr int kMaxImpacts = 16;         ///< impacts that may start in one chunk, per boom
constexpr float kMaxSpeedSlope = 6000;  ///< r/min a second; no flywheel is faster
constexpr double kMinSampleRate = 32000.0;
constexpr double kMaxSampleRate = 192000.0;

}  // namespace rigsound
