#include <algorithm>
#include <optional>
#include <utility>

#include "dbc/dbc_attributes.hpp"
#include "dbc/dbc_cursor.hpp"
#include "dbc/dbc_multiplexing.hpp"
#include "dbc/dbc_signal_line.hpp"
#include "rigsound/can/frame.hpp"
#include "rigsound/config/dbc.hpp"
#include "rigsound/machine/input_error.hpp"
#include "text/read_text.hpp"

namespace rigsound::config {
namespace {

constexpr std::int64_t kExtendedBit = 0x80000000;
constexpr std::int64_t kMaxRawId = 0xFFFFFFFF;
constexpr double kMostRaw = 9e18;                     // what a 64 bit key holds
constexpr std::int64_t kUnboundSignals = 0xC0000000;  // the pseudo message of signals that no message carries

class Parser {
 public:
  Parser(std::string_view text, const std::string& file) : file_(file), at_(dbc_tokens(text), file_) {}

  Dbc parse() {
    while (!at_.at_end()) guarded(std::nullopt, [this] { section(); });
    for (std::size_t i = 0; i < dbc_.messages.size(); ++i) {
      attributes_.apply(raw_ids_[i], dbc_.messages[i]);
      guarded(i, [&] { resolve_multiplexing(dbc_.messages[i], mux_[i], file_); });
    }
    return std::move(dbc_);
  }

 private:
  using Values = std::map<std::int64_t, std::string>;
  using Action = void (Parser::*)();

  /// What `read` cannot read costs the message it is about: message `about`, or the one a section turned to.
  template <class Read>
  void guarded(std::optional<std::size_t> about, const Read& read) {
    about_ = about;
    try {
      read();
    } catch (const InputError& error) {
      if (!about_ && section_ == "BO_") dbc_.unread.emplace_back(error.what());
      if (about_ && dbc_.messages[*about_].broken.empty()) dbc_.messages[*about_].broken = error.what();
      if (!about) skip_to_section();
    }
  }

  void skip_to_section() {
    const auto at_section = [this] {
      return at_.peek().first_in_line && at_.at_word() && at_.peek().text != "SG_" &&
             is_dbc_section(at_.peek().text);
    };
    while (!at_.at_end() && !at_section()) at_.take();
  }

  void section() {
    static constexpr std::pair<std::string_view, Action> kActions[] = {
        {"BO_", &Parser::message},
        {"BU_", &Parser::nodes},
        {"CM_", &Parser::comment},
        {"VAL_", &Parser::values},
        {"VAL_TABLE_", &Parser::value_table},
        {"SIG_VALTYPE_", &Parser::value_type},
        {"SG_MUL_VAL_", &Parser::mux_values},
        {"BO_TX_BU_", &Parser::senders},
        {"NS_", &Parser::new_symbols},
    };
    const DbcToken token = at_.take();
    at_.enter(token.text);
    section_ = token.text;
    if (token.text == "BA_DEF_") return attributes_.read_definition(at_);
    if (token.text == "BA_DEF_DEF_") return attributes_.read_default(at_);
    if (token.text == "BA_") return attributes_.read_value(at_);
    for (const auto& [name, action] : kActions)
      if (token.text == name && token.kind == DbcToken::Kind::kWord) return (this->*action)();
    skip();
  }

  // An unknown section ends with a semicolon, or where a line begins with a section that we know.
  void skip() {
    while (!at_.at_end()) {
      if (at_.peek().first_in_line && at_.at_word() && is_dbc_section(at_.peek().text)) return;
      if (at_.take_sign(';')) return;
      at_.take();
    }
  }

  // The list holds words that begin sections elsewhere; a section begins where such a word is followed by
  // what only a section has.
  void new_symbols() {
    at_.expect_sign(':');
    while (at_.at_word()) {
      if (at_.peek().text == "BO_" || at_.peek(1).kind != DbcToken::Kind::kWord) return;
      if (is_dbc_object(at_.peek(1).text) && at_.peek(2).kind == DbcToken::Kind::kString) return;
      at_.take();
    }
  }

  // A word followed by a number or a string is the name of an unknown section, not a node.
  void nodes() {
    at_.expect_sign(':');
    while (at_.at_word() && !is_dbc_section(at_.peek().text)) {
      const DbcToken::Kind next = at_.peek(1).kind;
      if (next == DbcToken::Kind::kNumber || next == DbcToken::Kind::kString) return;
      dbc_.nodes.push_back(at_.expect_word("a node"));
    }
    at_.take_sign(';');
  }

  std::int64_t raw_id() { return at_.expect_integer("a message identifier", 0, kMaxRawId); }

  void message() {
    DbcMessage message;
    message.line = at_.peek().line;
    const std::int64_t id = raw_id();
    message.extended = (id & kExtendedBit) != 0;
    message.id = static_cast<std::uint32_t>(id & can::kMaxExtendedId);
    message.name = at_.expect_word("the name of a message");
    at_.expect_sign(':');
    message.size = static_cast<int>(at_.expect_integer("the size of a message in bytes", 0, 1785));
    if (at_.at_word() && !is_dbc_section(at_.peek().text))
      message.senders.push_back(at_.expect_word("a node"));
    if (id == kUnboundSignals) return skip_to_section();
    raw_ids_.push_back(id);
    mux_.emplace_back();
    dbc_.messages.push_back(std::move(message));
    about_ = dbc_.messages.size() - 1;
    while (at_.at_word() && at_.peek().text == "SG_") {
      at_.enter(at_.take().text);
      dbc_.messages.back().signals.push_back(read_signal_line(at_, mux_.back()));
    }
  }

  void comment() {
    const std::string object = at_.at_word() ? at_.expect_word("BO_, SG_, BU_ or EV_") : "";
    DbcMessage* message = object == "BO_" || object == "SG_" ? known_message() : nullptr;
    about_.reset();  // a message is whole without its comment
    const std::string name = object.empty() || object == "BO_" ? "" : at_.expect_word("a name");
    const std::string text = at_.expect_string("a comment in quotes");
    if (object == "BO_" && message != nullptr) message->comment = text;
    if (DbcSignal* signal = object == "SG_" ? known_signal(message, name) : nullptr) signal->comment = text;
    at_.expect_sign(';');
  }

  Values value_texts() {
    Values values;
    while (at_.at_number()) {
      const double raw = std::clamp(at_.expect_number("a value"), -kMostRaw, kMostRaw);
      values[static_cast<std::int64_t>(raw)] = at_.expect_string("the text of a value in quotes");
    }
    at_.expect_sign(';');
    return values;
  }

  void values() {
    if (at_.at_word()) {  // of an environment variable
      at_.take();
      value_texts();
      return;
    }
    DbcMessage* message = known_message();
    DbcSignal* signal = known_signal(message, at_.expect_word("the name of a signal"));
    const bool by_table = at_.at_word();
    const std::string table = by_table ? at_.expect_word("the name of a value table") : "";
    Values texts = value_texts();
    if (signal != nullptr) signal->values = by_table ? dbc_.value_tables[table] : std::move(texts);
  }

  void value_table() {
    const std::string name = at_.expect_word("the name of a value table");
    dbc_.value_tables[name] = value_texts();
  }

  void value_type() {
    DbcMessage* message = known_message();
    DbcSignal* signal = known_signal(message, at_.expect_word("the name of a signal"));
    at_.take_sign(':');
    const std::int64_t type = at_.expect_integer("0 (integer), 1 (float) or 2 (double),", 0, 2);
    if (signal != nullptr && type == 1) signal->layout.type = can::ValueType::kFloat32;
    if (signal != nullptr && type == 2) signal->layout.type = can::ValueType::kFloat64;
    at_.expect_sign(';');
  }

  void mux_values() {
    const DbcMessage* message = known_message();
    const std::string signal = at_.expect_word("the name of a signal");
    DbcMux mux;
    mux.parent = at_.expect_word("the name of a multiplexor");
    do {
      const auto first = static_cast<std::uint64_t>(at_.expect_integer("a multiplexor value", 0, INT64_MAX));
      at_.expect_sign('-');
      const auto last = static_cast<std::uint64_t>(at_.expect_integer("a multiplexor value", 0, INT64_MAX));
      mux.ranges.emplace_back(first, last);
    } while (at_.take_sign(','));
    at_.expect_sign(';');
    if (message == nullptr) return;
    auto& known = mux_[static_cast<std::size_t>(message - dbc_.messages.data())];
    const auto found = known.find(signal);
    if (found == known.end() || !found->second.is_multiplexed) return;
    found->second.parent = std::move(mux.parent);
    found->second.ranges = std::move(mux.ranges);
  }

  void senders() {
    DbcMessage* message = known_message();
    at_.expect_sign(':');
    while (at_.at_word() || at_.at_sign(',')) {
      const DbcToken token = at_.take();
      if (token.kind == DbcToken::Kind::kWord && message != nullptr)
        message->senders.emplace_back(token.text);
    }
    at_.expect_sign(';');
  }

  DbcMessage* known_message() {
    const auto found = std::find(raw_ids_.begin(), raw_ids_.end(), raw_id());
    if (found == raw_ids_.end()) return nullptr;
    about_ = static_cast<std::size_t>(found - raw_ids_.begin());
    return &dbc_.messages[*about_];
  }

  static DbcSignal* known_signal(DbcMessage* message, const std::string& name) {
    return message == nullptr ? nullptr : const_cast<DbcSignal*>(message->find(name));
  }

  const std::string& file_;
  DbcCursor at_;
  Dbc dbc_;
  DbcAttributes attributes_;
  std::vector<std::int64_t> raw_ids_;               ///< of dbc_.messages, bit 31 in place
  std::vector<std::map<std::string, DbcMux>> mux_;  ///< of dbc_.messages, by signal
  std::optional<std::size_t> about_;                ///< the message that is being read about
  std::string_view section_;                        ///< that is being read
};

/// Refuses what is no text of one byte a letter, and says how to make it one.
void require_plain_text(std::string_view text, const std::string& file) {
  const std::string_view start = text.substr(0, 64);
  const bool marked = start.substr(0, 2) == "\xFF\xFE" || start.substr(0, 2) == "\xFE\xFF";
  if (marked || start.find('\0') != std::string_view::npos)
    throw InputError(file, "is UTF-16, expected UTF-8 or Windows-1252: iconv -f UTF-16 -t UTF-8");
  if (text.find('\r') != std::string_view::npos && text.find('\n') == std::string_view::npos)
    throw InputError(file, "has line ends of CR alone, expected LF or CRLF: tr '\\r' '\\n'");
}

template <class Named>
const Named* find_named(const std::vector<Named>& all, std::string_view name) {
  const auto named = [&](const Named& one) {
    return one.name == name || (!name.empty() && one.long_name == name);
  };
  const auto found = std::find_if(all.begin(), all.end(), named);
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

const DbcSignal* DbcMessage::find(std::string_view signal) const { return find_named(signals, signal); }

const DbcMessage* Dbc::find(std::string_view message) const { return find_named(messages, message); }

Dbc parse_dbc(std::string_view text, const std::string& file) {
  require_plain_text(text, file);
  return Parser(text, file).parse();
}

Dbc load_dbc(const std::filesystem::path& file) {
  return parse_dbc(read_text(file, kDbcText), file.string());
}

}  // namespace rigsound::config
