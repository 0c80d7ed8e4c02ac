#include "subscription.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "live_values.hpp"
#include "rigsound/config/nearest_word.hpp"
#include "rigsound/machine/fields.hpp"

namespace rigsound::daemon {
namespace {

constexpr Range kEvery{0.1, 3600, "s"};

/// Parts of the status that a client chooses; the rest is always told.
constexpr std::array<std::string_view, 7> kTopics = {"audio",  "buses",   "booms",  "exposure",
                                                     "meters", "session", "signals"};

// What is other in every status says nothing by itself.
constexpr std::array<std::string_view, 5> kOfAudio = {"blocks", "block_ms", "block_mean_us", "block_worst_us",
                                                      "load"};
constexpr std::array<std::string_view, 2> kLevelsOfBoom = {"levels", "impacts_made_hz"};

template <class Names>
void erase(Json& object, const Names& names) {
  for (const std::string_view name : names) object.erase(std::string(name));
}

/// A list of objects as an object by their names; `trim` takes from each what is not told.
template <class Trim>
Json by_name(const Json& list, Trim trim) {
  Json objects = Json::object();
  for (Json item : list) {
    const std::string name = item["name"];
    item.erase("name");
    trim(item);
    objects[name] = std::move(item);
  }
  return objects;
}

void trim_signal(Json& signal) {
  signal.erase("age_s");
  if (signal["last_refused"].is_null()) signal.erase("last_refused");  // null would say: no longer there
}

void trim_bus(Json& bus) { bus = {{"up", bus["up"]}, {"problem", bus["problem"]}}; }

Json view_of(Json status, const std::set<std::string>& topics) {
  for (const std::string_view topic : kTopics)
    if (topics.count(std::string(topic)) == 0) status.erase(std::string(topic));
  for (const char* name : {"ok", "uptime_s"}) status.erase(name);
  if (status.contains("audio")) erase(status["audio"], kOfAudio);
  if (status.contains("session")) status["session"].erase("bytes");
  if (status.contains("exposure") && status["exposure"].is_object()) status["exposure"].erase("since_s");
  if (status.contains("signals")) status["signals"] = by_name(status["signals"], trim_signal);
  if (status.contains("buses")) status["buses"] = by_name(status["buses"], trim_bus);
  if (status.contains("booms"))
    status["booms"] = by_name(status["booms"], [&](Json& boom) {
      if (topics.count("meters") == 0) erase(boom, kLevelsOfBoom);
    });
  return status;
}

Json merge_patch(const Json& before, const Json& after) {
  Json patch = Json::object();
  for (const auto& [key, value] : after.items()) {
    const auto old = before.find(key);
    if (old != before.end() && old->is_object() && value.is_object()) {
      if (Json inner = merge_patch(*old, value); !inner.empty()) patch[key] = std::move(inner);
    } else if (old == before.end() || *old != value) {
      patch[key] = value;
    }
  }
  for (const auto& [key, value] : before.items())
    if (!after.contains(key)) patch[key] = nullptr;
  return patch;
}

std::string topic_named(const Json& given) {
  std::string name = given.is_string() ? given.get<std::string>() : config::json_line(given);
  if (std::find(kTopics.begin(), kTopics.end(), name) != kTopics.end()) return name;
  const std::string_view near = config::nearest_word(name, kTopics);
  throw Refused(near.empty() ? fmt::format("topics: {}: is none, expected {}", name, list_of(kTopics))
                             : fmt::format("topics: {}: is none, did you mean {}?", name, near));
}

}  // namespace

Subscription::Subscription(const Json& request) {
  every_s_ = request.value("every_s", every_s_);
  if (!kEvery.holds(every_s_)) throw Refused("every_s: " + kEvery.problem(every_s_));
  const Json topics = request.value("topics", Json(kTopics));
  if (!topics.is_array() || topics.empty())
    throw Refused(fmt::format("topics: expected a list of {}", list_of(kTopics)));
  for (const Json& topic : topics) topics_.insert(topic_named(topic));
}

std::string Subscription::line(const Json& status, double now_s) {
  next_s_ = now_s + every_s_;
  Json view = view_of(status, topics_);
  const Json change = merge_patch(told_, view);
  if (change.empty()) return {};
  told_ = std::move(view);
  const Json line = {
      {"event", "change"}, {"uptime_s", status["uptime_s"]}, {"missed", missed_}, {"change", change}};
  missed_ = 0;
  return config::json_line(line) + "\n";
}

void Subscription::miss(double now_s) {
  next_s_ = now_s + every_s_;
  ++missed_;
}

}  // namespace rigsound::daemon
