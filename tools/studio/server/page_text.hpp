// Bytes inside a page that is one file, in less room than base64. Thread: any.
#pragma once

#include <string>
#include <string_view>

namespace rigsound::studio {

/// Seven bits a letter, highest first, the last filled up with zeros: U+0000...U+007F. The three that the
/// text of a script element cannot hold, U+0000, U+000D and U+003C, are letter U+0100 + 128 i + the next
/// seven bits, i = 0, 1, 2 in that order; where none are next, U+0280 + 128 i.
std::string page_text(std::string_view bytes);

std::string deflated(std::string_view bytes);  ///< a zlib stream

/// Every fourth byte from the first on, then from the second on, and so forth: of floats the parts that are
/// alike stand together. A rest under four bytes stays at the end.
std::string byte_planes(std::string_view bytes);

}  // namespace rigsound::studio
