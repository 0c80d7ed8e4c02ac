// What visits the lists of options: the shipped rig, and the name of what a rig sounds like.
#include <doctest/doctest.h>

#include <functional>
#include <regex>
#include <set>
#include <sstream>

#include "config/rig/rig_texts.hpp"
#include "rig/sections.hpp"
#include "rigsound/config/fingerprint.hpp"
#include "temporary_folder.hpp"
#include "toml/toml_reader.hpp"

using namespace rigsound;
using namespace rigsound::test;
namespace fs = std::filesystem;

namespace {

struct Key {
  std::string name;
  std::vector<std::string> explained;  ///< what a comment must say
};

/// Keys of a list as a rig file has them, those of inline tables among them.
class KeyList {
 public:
  template <class Options>
  static std::vector<Key> of(std::vector<std::string> others = {}) {
    KeyList list;
    visit(list, Options{});
    for (std::string& name : others) list.keys_.push_back({std::move(name), {}});
    return list.keys_;
  }

  template <class Number>
  void operator()(const char* key, const Number&, const Range& range) {
    keys_.push_back({config::toml_key(key, range), {config::toml_range(range).text()}});
  }
  void operator()(const char* key, const bool&) { keys_.push_back({key, {}}); }
  void operator()(const char* key, const std::string&, Label = {}) { keys_.push_back({key, {}}); }
  template <class E, std::size_t N>
  void operator()(const char* key, const E&, const Word<E> (&words)[N]) {
    keys_.push_back({key, {}});
    for (const Word<E>& word : words) keys_.back().explained.push_back('"' + std::string(word.first) + '"');
  }
  template <class Item>
  void operator()(const char* key, const std::vector<Item>&) {
    (*this)(key, Item{});
  }
  template <class Options>
  void operator()(const char* key, const Options& options) {
    keys_.push_back({key, {}});
    visit(*this, options);
  }

 private:
  std::vector<Key> keys_;
};

/// The text of every table of demo.toml that bears `name`, those that are switched off too, with the comment
/// above its heading.
std::vector<std::string> tables_of_demo(const std::string& name) {
  std::vector<std::string> tables;
  std::istringstream lines(content(kDemo));
  const std::regex heading(R"(^(#: )?\[+([a-z.]+)\]+$)");
  bool inside = false;
  std::string comment;
  std::smatch found;
  for (std::string line; std::getline(lines, line);) {
    const bool is_heading = std::regex_match(line, found, heading);
    if (line.rfind("# ", 0) == 0) {
      comment += line + "\n";
      continue;
    }
    if (is_heading) inside = found[2] == name;
    if (is_heading && inside) tables.emplace_back();
    if (inside) tables.back() += comment + line + "\n";
    comment.clear();
  }
  return tables;
}

int count_of(const std::string& key, const std::string& table) {
  const std::regex given("(^|\\n)(#: )?" + key + " = |[{,] " + key + " = ");
  return static_cast<int>(
      std::distance(std::sregex_iterator(table.begin(), table.end(), given), std::sregex_iterator()));
}

/// The comments of the table: of the key's own line where it has one, of all lines for keys of inline tables.
std::string comments_on(const std::string& key, const std::string& table) {
  std::istringstream lines(table);
  std::string all;
  for (std::string line; std::getline(lines, line);) {
    const bool off = line.rfind("#: ", 0) == 0;
    const std::size_t hash = line.find('#', off ? 1 : 0);
    std::string comment = hash == std::string::npos ? "" : line.substr(hash);
    if (line.rfind((off ? "#: " : "") + key + " = ", 0) == 0) return comment;
    all += comment + "\n";
  }
  return all;
}

void require_named(const std::string& section, const std::vector<Key>& keys) {
  const std::vector<std::string> tables = tables_of_demo(section);
  REQUIRE_MESSAGE(!tables.empty(), section);
  std::set<std::string> names;
  for (const Key& key : keys) {
    INFO(section, ".", key.name);
    CHECK(names.insert(key.name).second);
    int total = 0;
    std::string comments;
    for (const std::string& table : tables) {
      const int count = count_of(key.name, table);
      CHECK(count <= 1);
      if (count > 0) comments += comments_on(key.name, table) + "\n";
      total += count;
    }
    CHECK(total >= 1);
    for (const std::string& text : key.explained)
      CHECK_MESSAGE(
          std::regex_search(
              comments, std::regex("(^|[^0-9.-])" + std::regex_replace(text, std::regex(R"([.+])"), "\\$&"))),
          text, " in ", comments);
  }
}

/// Changes number `wanted` of a list; counts them.
class Changer {
 public:
  explicit Changer(int wanted) : wanted_(wanted) {}
  int count() const { return count_; }

  template <class Number>
  void operator()(const char*, Number& x, const Range& range) {
    if (count_++ == wanted_) x = static_cast<Number>(x == range.max ? range.min : range.max);
  }
  void operator()(const char*, std::string& name, Label) { name += "2"; }
  template <class Item>
  void operator()(const char*, std::vector<Item>& list) {
    for (Item& item : list) fields(*this, item);
  }
  template <class Options>
  void operator()(const char*, Options& options) {
    fields(*this, options);
  }

 private:
  int wanted_, count_ = 0;
};

}  // namespace

TEST_CASE("demo.toml names every key of every list once a table, with its range and unit") {
  require_named("audio", KeyList::of<audio::AudioOptions>());
  require_named("sound", KeyList::of<config::SoundSection>());
  require_named("boom", KeyList::of<BoomOptions>({"tool"}));
  require_named("scene", KeyList::of<SceneOptions>());
  require_named("mix", KeyList::of<MixOptions>({"db_spl_at_0dbfs"}));
  require_named("safety", KeyList::of<SafetyOptions>());
  require_named("can", KeyList::of<can::CanOptions>({"dbc", "j1939"}));
  require_named("modbus", KeyList::of<modbus::ModbusOptions>({"allow"}));
  require_named("udp", KeyList::of<udp::UdpOptions>({"allow", "signals"}));
  require_named("osc", KeyList::of<osc::OscOptions>({"allow", "signals", "targets"}));
  require_named("control", KeyList::of<config::ControlOptions>());
}

TEST_CASE("demo.toml explains the rule of a signal") {
  const std::string safety = tables_of_demo("safety").at(0);
  for (const Key& key : KeyList::of<SafetyRule>()) {
    INFO(key.name);
    CHECK(count_of(key.name, safety) >= 1);
    for (const std::string& text : key.explained) CHECK(safety.find(text) != std::string::npos);
  }
}

TEST_CASE("demo.toml explains every key of a Modbus register") {
  const std::vector<std::string> tables = tables_of_demo("modbus.signals");
  REQUIRE(tables.size() == 2);
  for (const Key& key : KeyList::of<modbus::RegisterRoute>()) {
    INFO(key.name);
    CHECK(count_of(key.name, tables[0]) == 1);
    for (const std::string& text : key.explained) CHECK(tables[0].find(text) != std::string::npos);
  }
}

TEST_CASE("every number of the engine's options is in the fingerprint, a boom's name and the seed are not") {
  config::Rig rig;
  rig.engine.booms = {{"a", 0, 0, -1}, {"b", 0, 0, -1}};
  rig.boom_tools = {"", ""};
  rig.engine.mix.equaliser = {{}, {}};
  Changer counter(-1);
  config::Rig renamed = rig;
  fields(counter, renamed.engine);
  CHECK(renamed.engine.booms[0].name == "a2");
  CHECK(config::fingerprint(renamed) == config::fingerprint(rig));
  renamed.engine.seed = 77;
  CHECK(config::fingerprint(renamed) == config::fingerprint(rig));

  std::set<std::string> prints = {config::fingerprint(rig)};
  REQUIRE(counter.count() > 20);
  for (int i = 0; i < counter.count(); ++i) {
    config::Rig changed = rig;
    Changer changer(i);
    fields(changer, changed.engine);
    prints.insert(config::fingerprint(changed));
  }
  rig.boom_tools = {"", "steel"};
  prints.insert(config::fingerprint(rig));
  CHECK(static_cast<int>(prints.size()) == counter.count() + 2);
}

TEST_CASE("a sound set's file is in the fingerprint as a text of its bytes, however long it is") {
  const test::TemporaryFolder folder;
  for (const std::size_t bytes : {0, 5, 1 << 16, 3 * (1 << 16) + 13}) {
    std::string text(bytes, 'a');
    for (std::size_t i = 0; i < bytes; ++i) text[i] = static_cast<char>(i * i % 251);
    config::Rig read, said;
    read.engine.booms = said.engine.booms = {{"a", 0, 0, -1}, {"b", 0, 0, -1}};
    read.boom_tools = {"steel"}, read.sound_set = folder.write("x.rigset", text);
    said.boom_tools = {"steel", text};
    CHECK(config::fingerprint(read) == config::fingerprint(said));
  }
}
