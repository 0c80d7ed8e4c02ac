#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "rigsound/config/rig.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::config {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kShortest = 16, kLongest = 512;

bool may_be_said(char c) { return c > ' ' && c <= '~' && c != '"' && c != '\\'; }

}  // namespace

std::string control_token(const Rig& rig) {
  const std::string& file = rig.control.token_file;
  if (file.empty()) return {};
  std::error_code error;
  const fs::file_status about = fs::status(file, error);
  if ((about.permissions() & fs::perms::others_all) != fs::perms::none && fs::is_regular_file(about))
    throw InputError(file, "is open to every user, expected a token for few (chmod o= FILE)");
  std::ifstream in(file);
  if (!fs::is_regular_file(about) || !in)
    throw InputError(file, "cannot be read, expected the token of [control] tcp");
  std::string token;
  std::getline(in, token);
  if (!token.empty() && token.back() == '\r') token.pop_back();
  const bool good = token.size() >= kShortest && token.size() <= kLongest &&
                    std::all_of(token.begin(), token.end(), may_be_said);
  if (!good)
    throw InputError(file, 1, {},
                     "is no token, expected " + std::to_string(kShortest) + "..." + std::to_string(kLongest) +
                         " letters and digits without blanks, such as `openssl rand -hex 32` makes");
  return token;
}

}  // namespace rigsound::config
