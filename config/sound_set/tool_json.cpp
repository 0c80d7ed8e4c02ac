#include "sound_set/tool_json.hpp"

#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "rigsound/machine/limits.hpp"
#include "sound_set/tool_fields.hpp"

namespace rigsound::config {
namespace {

using Json = nlohmann::ordered_json;

class Writer {
 public:
  explicit Writer(Json& out) : out_(out) {}

  void operator()(const char* key, double& value) { out_[key] = value; }
  void operator()(const char* key, int& value) { out_[key] = value; }
  void operator()(const char* key, ToolKind& kind) {
    out_[key] = kind == ToolKind::kPaper ? "paper" : "designed";
  }

  void operator()(const char* key, Allpass& allpass) {
    Json& sections = out_[key]["sections"] = Json::array();
    for (int i = 0; i < allpass.sections; ++i) {
      const auto [b, c] = allpass.section[static_cast<std::size_t>(i)];
      sections.push_back({b, c});
    }
    if (allpass.first_orders) out_[key]["first_order"] = allpass.a;
  }

  template <class Item>
  void operator()(const char* key, std::vector<Item>& list) {
    Json& array = out_[key] = Json::array();
    for (Item& item : list) {
      Writer writer(array.emplace_back(Json::object()));
      fields(writer, item);
    }
  }

  template <class Object>
  void operator()(const char* key, Object& object) {
    Writer writer(out_[key] = Json::object());
    fields(writer, object);
  }

 private:
  Json& out_;
};

/// Reads the keys that are there; the others keep their defaults.
class Reader {
 public:
  explicit Reader(const JsonFile& in, std::set<std::string> known = {}) : in_(in), known_(std::move(known)) {}

  void operator()(const char* key, double& value) {
    if (has(key)) value = in_.number(key, -kLargest, kLargest);
  }

  void operator()(const char* key, int& value) {
    if (has(key)) value = in_.integer(key, -1000000, 1000000);
  }

  void operator()(const char* key, ToolKind& kind) {
    if (!has(key)) return;
    const std::string name = in_.text(key);
    if (name != "designed" && name != "paper")
      in_.fail(key, '"' + name + "\" is no model, expected \"designed\" or \"paper\"");
    kind = name == "paper" ? ToolKind::kPaper : ToolKind::kDesigned;
  }

  void operator()(const char* key, Allpass& allpass) {
    known_.insert(key);
    const JsonFile in = in_.object(key);
    const nlohmann::json& sections = in.value("sections");
    if (!sections.is_array() || sections.size() > kMaxSections)
      in.fail("sections", "is no such list, expected at most 20 pairs [b, c]");
    for (const nlohmann::json& pair : sections) {
      if (!pair.is_array() || pair.size() != 2 || !pair[0].is_number() || !pair[1].is_number())
        in.fail("sections", pair.dump() + " stands in the list, expected pairs [b, c]");
      allpass.section[static_cast<std::size_t>(allpass.sections++)] = {pair[0].get<double>(),
                                                                       pair[1].get<double>()};
    }
    if (!in.root().contains("first_order")) return;
    allpass.first_orders = 1;
    allpass.a = in.number("first_order", 0, kLargest);
  }

  template <class Item>
  void operator()(const char* key, std::vector<Item>& list) {
    if (!has(key)) return;
    for (const JsonFile& item : in_.objects(key)) {
      Reader reader(item);
      fields(reader, list.emplace_back());
      reader.refuse_unknown();
    }
  }

  template <class Object>
  void operator()(const char* key, Object& object) {
    if (!has(key)) return;
    Reader reader(in_.object(key));
    fields(reader, object);
    reader.refuse_unknown();
  }

  void refuse_unknown() const {
    for (const auto& [key, value] : in_.root().items())
      if (!known_.count(key))
        in_.fail(key, "is no key of a tool, expected one that `rigsound tool --out` writes");
  }

 private:
  static constexpr double kLargest = 1e9;  // the engine's own check has the true ranges

  bool has(const char* key) {
    known_.insert(key);
    return in_.root().contains(key);
  }

  JsonFile in_;
  std::set<std::string> known_;
};

/// The engine's own check, its complaint (`KEY: what, expected`) with file and line.
void check_with_engine(const JsonFile& file, const ToolModel& tool) {
  try {
    require_valid(tool, kMaxSampleRate);
  } catch (const std::invalid_argument& error) {
    const std::string text = error.what();
    const std::size_t colon = text.find(": ");
    file.fail(text.substr(0, colon), text.substr(colon + 2));
  }
}

}  // namespace

std::string tool_json(const ToolModel& tool) {
  Json json;
  json["format"] = kToolFormat;
  ToolModel copy = tool;
  Writer writer(json);
  fields(writer, copy);
  return json.dump(2) + "\n";
}

ToolModel read_tool_json(const JsonFile& file) {
  file.require_format(kToolFormat);
  for (const char* needed : {"length_m", "diameter_m"}) file.value(needed);
  ToolModel tool;
  Reader reader(file, {"format"});
  fields(reader, tool);
  reader.refuse_unknown();
  check_with_engine(file, tool);
  return tool;
}

}  // namespace rigsound::config
