#include "dbc/dbc_attributes.hpp"

#include <algorithm>

#include "rigsound/number_of.hpp"

namespace rigsound::config {
namespace {

std::string value_text(DbcCursor& at) {
  if (at.at_string()) return at.expect_string("a value");
  if (!at.at_number()) at.fail_expected("a value");
  return std::string(at.take().text);
}

}  // namespace

bool is_dbc_object(std::string_view word) {
  return word == "BO_" || word == "SG_" || word == "BU_" || word == "EV_";
}

void DbcAttributes::read_definition(DbcCursor& at) {
  if (at.at_word() && is_dbc_object(at.peek().text)) at.take();
  const std::string name = at.expect_string("the name of an attribute in quotes");
  const std::string type = at.expect_word("INT, HEX, FLOAT, STRING or ENUM");
  if (type == "ENUM") {
    std::vector<std::string>& words = words_[name];
    while (at.at_string() || at.take_sign(','))
      if (at.at_string()) words.push_back(at.expect_string("a word"));
  }
  while (at.at_number()) at.take();
  at.expect_sign(';');
}

void DbcAttributes::read_default(DbcCursor& at) {
  const std::string name = at.expect_string("the name of an attribute in quotes");
  defaults_[name] = value_text(at);
  at.expect_sign(';');
}

void DbcAttributes::read_value(DbcCursor& at) {
  const std::string name = at.expect_string("the name of an attribute in quotes");
  const std::string object = at.at_word() ? at.expect_word("BO_, SG_, BU_ or EV_") : "";
  std::int64_t id = 0;
  if (object == "BO_" || object == "SG_") id = at.expect_integer("a message identifier", 0, 0xFFFFFFFF);
  const bool named = is_dbc_object(object) && object != "BO_";
  const std::string owner = named ? at.expect_word("a name") : "";
  const std::string value = value_text(at);
  if (object == "BO_") message_values_[{name, id}] = value;
  if (object == "SG_" && name == "SystemSignalLongSymbol") long_signals_[{owner, id}] = value;
  at.expect_sign(';');
}

std::optional<std::string> DbcAttributes::of_message(const std::string& attribute,
                                                     std::int64_t raw_id) const {
  const auto given = message_values_.find({attribute, raw_id});
  const auto usual = defaults_.find(attribute);
  if (given == message_values_.end() && usual == defaults_.end()) return std::nullopt;
  std::string value = given != message_values_.end() ? given->second : usual->second;
  const auto words = words_.find(attribute);
  if (words == words_.end()) return value;
  // An enumeration's value may be written as its word or as its index.
  const bool is_word = std::find(words->second.begin(), words->second.end(), value) != words->second.end();
  const auto index = number_of<double>(value);
  if (!is_word && index && *index >= 0 && *index < static_cast<double>(words->second.size()))
    value = words->second[static_cast<std::size_t>(*index)];
  return value;
}

void DbcAttributes::apply(std::int64_t raw_id, DbcMessage& message) const {
  message.j1939 = message.extended && of_message("VFrameFormat", raw_id) == "J1939PG";
  const auto cycle = of_message("GenMsgCycleTime", raw_id);
  if (const auto milliseconds = cycle ? number_of<double>(*cycle) : std::nullopt;
      milliseconds && *milliseconds > 0)
    message.cycle_s = *milliseconds / 1000;
  message.long_name = of_message("SystemMessageLongSymbol", raw_id).value_or("");
  for (DbcSignal& signal : message.signals) {
    const auto given = long_signals_.find({signal.name, raw_id});
    if (given != long_signals_.end()) signal.long_name = given->second;
  }
}

}  // namespace rigsound::config
