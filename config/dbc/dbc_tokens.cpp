#include "dbc/dbc_tokens.hpp"

#include "dbc/dbc_signal_line.hpp"

namespace rigsound::config {
namespace {

using Kind = DbcToken::Kind;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_word(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v'; }

bool has_open_quote(std::string_view text) {
  bool open = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (open && text.substr(i, 2) == "\\\"")
      ++i;
    else if (text[i] == '"')
      open = !open;
  }
  return open;
}

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text), unbalanced_(has_open_quote(text)) {
    if (text_.substr(0, 3) == "\xEF\xBB\xBF") at_ = 3;  // byte order mark
  }

  DbcToken next() {
    skip_space();
    DbcToken token;
    token.line = line_;
    token.first_in_line = fresh_line_;
    fresh_line_ = false;
    const std::size_t start = at_;
    if (at_ == text_.size()) return token;
    if (text_[at_] == '"') return string(token);
    if (starts_number()) {
      token.kind = Kind::kNumber;
      eat_number();
    } else if (is_word(text_[at_])) {
      token.kind = Kind::kWord;
      while (is_word(at(0))) ++at_;
    } else {
      token.kind = Kind::kSign;
      ++at_;
    }
    token.text = text_.substr(start, at_ - start);
    return token;
  }

 private:
  char at(std::size_t ahead) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  void skip_space() {
    while (at_ < text_.size()) {
      if (text_[at_] == '/' && at(1) == '/') {
        while (at_ < text_.size() && text_[at_] != '\n') ++at_;
      } else if (is_space(text_[at_])) {
        if (text_[at_] == '\n') ++line_, fresh_line_ = true;
        ++at_;
      } else {
        return;
      }
    }
  }

  DbcToken string(DbcToken token) {
    token.kind = Kind::kString;
    const std::size_t start = ++at_;
    for (; at_ < text_.size() && text_[at_] != '"'; ++at_) {
      if (text_[at_] == '\\' && at(1) == '"') ++at_;
      if (text_[at_] != '\n') continue;
      if (unbalanced_ && section_begins(at_ + 1)) return unclosed(token, start);
      ++line_;
    }
    token.text = text_.substr(start, at_ - start);
    if (at_ < text_.size()) ++at_;
    return token;
  }

  /// A sign that goes nowhere: the section it stands in cannot be read.
  DbcToken unclosed(DbcToken token, std::size_t start) const {
    token.kind = Kind::kSign;
    token.text = text_.substr(start - 1, 1);
    return token;
  }

  bool section_begins(std::size_t at) const {
    while (at < text_.size() && (text_[at] == ' ' || text_[at] == '\t')) ++at;
    std::size_t end = at;
    while (end < text_.size() && is_word(text_[end])) ++end;
    return is_dbc_section(text_.substr(at, end - at));
  }

  // In 3-5 the dash is a range, in (1,-5) a minus; what stands right before it tells.
  bool starts_number() const {
    const std::size_t sign = at(0) == '-' || at(0) == '+' ? 1 : 0;
    if (sign == 1 && at_ > 0 && is_word(text_[at_ - 1])) return false;
    return is_digit(at(sign)) || (at(sign) == '.' && is_digit(at(sign + 1)));
  }

  void eat_number() {
    ++at_;
    while (is_digit(at(0)) || at(0) == '.') ++at_;
    if (at(0) != 'e' && at(0) != 'E') return;
    const std::size_t sign = at(1) == '-' || at(1) == '+' ? 1 : 0;
    if (!is_digit(at(1 + sign))) return;
    at_ += 1 + sign;
    while (is_digit(at(0))) ++at_;
  }

  std::string_view text_;
  bool unbalanced_;  // a quote is missing: then strings do not reach into the next section
  std::size_t at_ = 0;
  int line_ = 1;
  bool fresh_line_ = true;
};

}  // namespace

std::vector<DbcToken> dbc_tokens(std::string_view text) {
  Scanner scanner(text);
  std::vector<DbcToken> tokens;
  do tokens.push_back(scanner.next());
  while (tokens.back().kind != Kind::kEnd);
  return tokens;
}

}  // namespace rigsound::config
