#include "json/json_positions.hpp"

#include <algorithm>

#include "rigsound/config/json_depth.hpp"

namespace rigsound::config {
namespace {

/// Steps from one bracket, comma, colon or text to the next; numbers and spaces are passed over.
class Tokens {
 public:
  Tokens(std::string_view text, std::size_t at) : text_(text), next_(at) {}

  bool step() {
    before_ = kind();
    at_ = text_.find_first_of("{}[],:\"", next_);
    if (at_ == kNowhere) return false;
    next_ = at_ + 1;
    if (kind() == '"') pass_text();
    if (kind() == '{' || kind() == '[') ++depth_;
    if (kind() == '}' || kind() == ']') --depth_;
    return true;
  }

  char kind() const { return at_ == kNowhere ? '\0' : text_[at_]; }
  char before() const { return before_; }  ///< kind of the token before
  int depth() const { return depth_; }     ///< brackets open behind this token
  std::size_t at() const { return at_; }
  std::string_view word() const { return text_.substr(at_ + 1, next_ - at_ - 2); }  ///< of a text, as written

 private:
  void pass_text() {
    while (next_ < text_.size() && text_[next_] != '"') next_ += text_[next_] == '\\' ? 2 : 1;
    next_ = std::min(next_ + 1, text_.size());
  }

  std::string_view text_;
  std::size_t at_ = kNowhere, next_;
  char before_ = '\0';
  int depth_ = 0;
};

}  // namespace

std::size_t key_position(std::string_view text, std::size_t object, std::string_view key) {
  for (Tokens t(text, object); t.step() && t.depth() > 0;) {
    const bool is_key = t.depth() == 1 && t.kind() == '"' && (t.before() == '{' || t.before() == ',');
    if (is_key && t.word() == key) return t.at();
  }
  return kNowhere;
}

std::vector<std::size_t> item_positions(std::string_view text, std::size_t list) {
  std::vector<std::size_t> items;
  Tokens t(text, text.find('[', list));
  while (t.step() && t.depth() > 0)
    if (t.kind() == '{' && t.depth() == 2) items.push_back(t.at());
  return items;
}

std::size_t position_below(std::string_view text, int depth) {
  for (Tokens t(text, 0); t.step();)
    if (t.depth() > depth) return t.at();
  return kNowhere;
}

int line_at(std::string_view text, std::size_t position) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(position, text.size()));
  return 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
}

}  // namespace rigsound::config
