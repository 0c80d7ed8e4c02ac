#include "rig/dbc_library.hpp"

#include <algorithm>
#include <vector>

#include "rigsound/can/signal_reading.hpp"
#include "rigsound/config/nearest_word.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::config {
namespace {

std::string not_there(const std::string& what, const std::string& name, const std::string& where,
                      const std::vector<std::string>& names) {
  const std::string_view near = nearest_word(name, names);
  return "there is no " + what + " '" + name + "' in " + where +
         (near.empty() ? ", expected one of its " + std::to_string(names.size())
                       : ", did you mean '" + std::string(near) + "'?");
}

template <class Named>
void append_names(const std::vector<Named>& all, std::vector<std::string>& names) {
  for (const Named& one : all) names.push_back(one.name);
}

bool same_field(const can::BitField& a, const can::BitField& b) {
  return a.start_bit == b.start_bit && a.length == b.length && a.order == b.order;
}

bool same_layout(const can::SignalLayout& a, const can::SignalLayout& b) {
  const auto same_selector = [](const can::Selector& x, const can::Selector& y) {
    return same_field(x.field, y.field) && x.ranges == y.ranges;
  };
  return same_field(a.field, b.field) && a.type == b.type && a.scale == b.scale && a.offset == b.offset &&
         std::equal(a.selectors.begin(), a.selectors.end(), b.selectors.begin(), b.selectors.end(),
                    same_selector);
}

bool same_frames(const DbcMessage& a, const DbcMessage& b) {
  if (a.extended != b.extended || a.j1939 != b.j1939) return false;
  return a.j1939 ? can::pgn(a.id) == can::pgn(b.id) : a.id == b.id;
}

bool say_the_same(const DbcLibrary::Entry& a, const DbcLibrary::Entry& b) {
  return same_frames(*a.message, *b.message) && same_layout(a.signal->layout, b.signal->layout) &&
         a.signal->values == b.signal->values;
}

std::string place(const DbcLibrary::Entry& entry) {
  return *entry.file + ":" + std::to_string(entry.signal->line);
}

}  // namespace

void DbcLibrary::add(const std::filesystem::path& file) {
  files_.push_back({file.string(), load_dbc(file)});
  if (!files_.back().dbc.messages.empty()) return;
  const std::vector<std::string>& unread = files_.back().dbc.unread;
  throw InputError(file.string(), unread.empty() ? "holds no message, expected BO_ sections"
                                                 : "holds no message that can be read: " + unread.front());
}

std::string DbcLibrary::no_message(const std::string& message) const {
  std::vector<std::string> names;
  std::string where, unread;
  for (const File& file : files_) {
    append_names(file.dbc.messages, names);
    where += (where.empty() ? "" : " and ") + file.name;
    for (const std::string& line : file.dbc.unread) unread += "; not read: " + line;
  }
  return not_there("message", message, where, names) + unread;
}

std::optional<DbcLibrary::Entry> DbcLibrary::find(const std::string& message, const std::string& signal,
                                                  std::string& problem) const {
  std::vector<Entry> found;
  problem = no_message(message);
  for (const File& file : files_) {
    const DbcMessage* const m = file.dbc.find(message);
    if (m == nullptr) continue;
    if (!m->broken.empty()) {
      problem = message + " cannot be read: " + m->broken;
      continue;
    }
    if (const DbcSignal* const s = m->find(signal)) {
      found.push_back({&file.name, m, s});
      continue;
    }
    std::vector<std::string> names;
    append_names(m->signals, names);
    problem = not_there("signal", signal, message + " of " + file.name, names);
  }
  if (found.empty()) return std::nullopt;
  const auto other = std::find_if(found.begin() + 1, found.end(),
                                  [&](const Entry& entry) { return !say_the_same(found.front(), entry); });
  if (other == found.end()) return found.front();
  problem = "'" + message + "." + signal + "' is in " + place(found.front()) + " and, otherwise, in " +
            place(*other) + ", expected it in one of them";
  return std::nullopt;
}

}  // namespace rigsound::config
