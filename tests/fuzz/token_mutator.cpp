// Changes JSON and TOML by whole tokens, so that what comes out still parses most of the time: numbers become
// others at the edges, keys and values change places, are doubled, dropped or nested.
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz_target.hpp"

namespace {

constexpr std::string_view kBreaks = "{}[],:=\"\n# ";

constexpr const char* kNumbers[] = {"0",
                                    "-0.0",
                                    "1",
                                    "-1",
                                    "0.5",
                                    "1e-320",
                                    "1e-38",
                                    "1e38",
                                    "1e308",
                                    "1e400",
                                    "255",
                                    "256",
                                    "65535",
                                    "65536",
                                    "2147483647",
                                    "2147483648",
                                    "-2147483649",
                                    "4294967296",
                                    "9007199254740993",
                                    "18446744073709551616",
                                    "nan",
                                    "inf",
                                    "-inf",
                                    "1e"};

constexpr const char* kValues[] = {"true", "false", "null", "{}",    "[]",
                                   "\"\"", "[{}]",  "[[]]", "\"a\"", "{\"a\":1}"};

/// A text in quotes is one token, every bracket, comma, colon and blank one, and what lies between them.
std::vector<std::string> tokens_of(std::string_view text) {
  std::vector<std::string> tokens;
  while (!text.empty()) {
    std::size_t size = std::min(text.find_first_of(kBreaks), text.size());
    if (size == 0 && text[0] == '"') size = std::min(text.find('"', 1), text.size() - 1) + 1;
    size = std::max<std::size_t>(size, 1);
    tokens.emplace_back(text.substr(0, size));
    text.remove_prefix(size);
  }
  return tokens;
}

bool is_number(const std::string& token) {
  return token.find_first_of("0123456789") != std::string::npos && token[0] != '"';
}

/// A small generator of its own: libFuzzer wants the same output for the same seed.
class Dice {
 public:
  explicit Dice(unsigned seed) : state_(seed * 2654435761U + 1) {}
  std::size_t below(std::size_t n) {
    state_ = state_ * 1664525U + 1013904223U;
    return n == 0 ? 0 : (state_ >> 8) % n;
  }
  template <std::size_t N>
  const char* of(const char* const (&list)[N]) {
    return list[below(N)];
  }

 private:
  std::uint32_t state_;
};

void change_number(std::vector<std::string>& tokens, Dice& dice) {
  const std::size_t from = dice.below(tokens.size());
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    std::string& token = tokens[(from + i) % tokens.size()];
    if (!is_number(token)) continue;
    if (dice.below(3) == 0)
      token += static_cast<char>('0' + dice.below(10));
    else
      token = dice.of(kNumbers);
    return;
  }
}

/// Some tokens in a row go to another place, too.
void repeat(std::vector<std::string>& tokens, Dice& dice) {
  const std::size_t from = dice.below(tokens.size()),
                    count = 1 + dice.below(std::min<std::size_t>(tokens.size() - from, 24));
  const std::vector<std::string> some(tokens.begin() + static_cast<std::ptrdiff_t>(from),
                                      tokens.begin() + static_cast<std::ptrdiff_t>(from + count));
  tokens.insert(tokens.begin() + static_cast<std::ptrdiff_t>(dice.below(tokens.size())), some.begin(),
                some.end());
}

void nest(std::vector<std::string>& tokens, Dice& dice) {
  const std::size_t at = dice.below(tokens.size()), depth = 1 + dice.below(40);
  std::string opened, closed;
  for (std::size_t i = 0; i < depth; ++i) opened += '[', closed += ']';
  tokens[at] = opened + tokens[at] + closed;
}

void mutate(std::vector<std::string>& tokens, Dice& dice) {
  const std::size_t at = dice.below(tokens.size());
  switch (dice.below(8)) {
    case 0:
    case 1:
    case 2:
      return change_number(tokens, dice);
    case 3:
      return repeat(tokens, dice);
    case 4:
      return std::swap(tokens[at], tokens[dice.below(tokens.size())]);
    case 5:
      tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(at));
      return;
    case 6:
      return nest(tokens, dice);
    default:
      tokens[at] = dice.of(kValues);
  }
}

}  // namespace

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  Dice dice(seed);
  if (size == 0 || dice.below(8) == 0) return LLVMFuzzerMutate(data, size, most);
  std::vector<std::string> tokens = tokens_of({reinterpret_cast<const char*>(data), size});
  for (std::size_t times = 1 + dice.below(3); times > 0 && !tokens.empty(); --times) mutate(tokens, dice);
  std::string text;
  for (const std::string& token : tokens) text += token;
  text.resize(std::min(text.size(), most));
  std::copy(text.begin(), text.end(), data);
  return text.size();
}
