// What every page of ours begins and ends with: head, style sheet, title.
#pragma once

#include <string>

namespace rigsound::analysis {

/// Up to and with the heading. `style`: rules of the page itself. Light, dark and printed; from 420 pixels
/// on. Thread: OFF.
std::string page_start(const std::string& title, const std::string& style);

constexpr const char* kPageEnd = "</body></html>\n";

}  // namespace rigsound::analysis
