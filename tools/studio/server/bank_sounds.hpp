// The sounds of a bank: recorded, denoised and synthesised have one length and one start, so that what is
// switched between goes on where it was. Thread: any.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "workplace.hpp"

namespace rigsound::studio {

constexpr double kSynthesis_s = 4;           ///< without a recording beside it
constexpr std::uint64_t kSynthesisSeed = 1;  ///< that of report.html

struct BankSound {
  std::vector<float> samples;
  int rate = 0;  ///< Hz; 48 000 unless the bank comes from elsewhere
};

/// The first `most_s` of `which`: recorded, denoised or synthesised (the bank as refined). Errors: ApiError
/// 404 when there is no such bank or sound, or not the recording; InputError.
BankSound bank_sound(Workplace& place, const std::string& bank, const std::string& which, double most_s);

}  // namespace rigsound::studio
