#include "dbc/dbc_signal_line.hpp"

#include <algorithm>
#include <iterator>

namespace rigsound::config {
namespace {

/// What the NS_ section of a file may list; the words that begin a section.
constexpr std::string_view kSections[] = {"VERSION",
                                          "NS_",
                                          "BS_",
                                          "BU_",
                                          "BO_",
                                          "SG_",
                                          "CM_",
                                          "BA_DEF_",
                                          "BA_",
                                          "VAL_",
                                          "VAL_TABLE_",
                                          "BA_DEF_DEF_",
                                          "SIG_VALTYPE_",
                                          "SG_MUL_VAL_",
                                          "BO_TX_BU_",
                                          "EV_",
                                          "ENVVAR_DATA_",
                                          "SGTYPE_",
                                          "SGTYPE_VAL_",
                                          "SIG_GROUP_",
                                          "BA_DEF_REL_",
                                          "BA_REL_",
                                          "BA_DEF_DEF_REL_",
                                          "CAT_DEF_",
                                          "CAT_",
                                          "FILTER",
                                          "SIG_TYPE_REF_",
                                          "EV_DATA_",
                                          "BU_SG_REL_",
                                          "NS_DESC_"};

// start|length@order sign (scale,offset)
can::SignalLayout read_layout(DbcCursor& at) {
  can::SignalLayout layout;
  layout.field.start_bit = static_cast<int>(at.expect_integer("a start bit", 0, 1785 * 8 - 1));
  at.expect_sign('|');
  layout.field.length = static_cast<int>(at.expect_integer("a length in bits", 1, 1785 * 8));
  at.expect_sign('@');
  const bool intel = at.expect_integer("a byte order, 0 or 1,", 0, 1) == 1;
  layout.field.order = intel ? can::ByteOrder::kIntel : can::ByteOrder::kMotorola;
  if (at.take_sign('-'))
    layout.type = can::ValueType::kSigned;
  else
    at.expect_sign('+');
  at.expect_sign('(');
  layout.scale = at.expect_number("a scale");
  at.expect_sign(',');
  layout.offset = at.expect_number("an offset");
  at.expect_sign(')');
  return layout;
}

}  // namespace

bool is_dbc_section(std::string_view word) {
  return std::find(std::begin(kSections), std::end(kSections), word) != std::end(kSections);
}

DbcSignal read_signal_line(DbcCursor& at, std::map<std::string, DbcMux>& mux) {
  DbcSignal signal;
  signal.line = at.peek().line;
  signal.name = at.expect_word("the name of a signal");
  if (at.at_word() && !parse_mux(at.take().text, mux[signal.name]))
    at.fail("signal " + signal.name + " has a wrong multiplexing word, expected M, m0, m0M, ...");
  at.expect_sign(':');
  signal.layout = read_layout(at);
  at.expect_sign('[');
  signal.min = at.expect_number("the least value");
  at.expect_sign('|');
  signal.max = at.expect_number("the greatest value");
  at.expect_sign(']');
  signal.unit = at.expect_string("a unit in quotes");
  while ((at.at_word() && !is_dbc_section(at.peek().text)) || at.at_sign(',')) at.take();  // receivers
  return signal;
}

}  // namespace rigsound::config
