// What a verb of ours prints, for routes that are a verb with a page around it.
#pragma once

#include <string>
#include <vector>

namespace rigsound::studio {

/// Standard output of `rigsound WORDS`, without its notes on standard error. Errors: ApiError 422 with the
/// verb's last line when it ends with another code than 0, or says more than 64 MiB; DeviceError. Thread:
/// any.
std::string verb_output(const std::vector<std::string>& words);

}  // namespace rigsound::studio
