#include "rigsound/udp/datagram_reader.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace rigsound::udp {
namespace {

constexpr std::size_t kLongestName = 64;

/// The value of a word of the signal, or nothing.
std::optional<double> value_of(Signal s, std::string_view word) {
  const SignalInfo& signal = info(s);
  for (double value = signal.min; signal.kind == SignalKind::kWord && value <= signal.max; ++value)
    if (value_word(s, value) == word) return value;
  return std::nullopt;
}

/// Takes a datagram apart as it is parsed: nothing is built of what is not known. (The names of its functions
/// are nlohmann's.)
class Handler : public nlohmann::json_sax<nlohmann::json> {
 public:
  Handler(const std::map<std::string, SignalId, std::less<>>& names, double time_s)
      : names_(names), time_s_(time_s) {}

  DatagramContent content;
  std::string problem;

  bool null() override { return value(0, Validity::kNotAvailable); }
  bool boolean(bool on) override { return value(on ? 1 : 0, Validity::kValid); }
  bool number_integer(number_integer_t x) override { return whole(x); }
  bool number_unsigned(number_unsigned_t x) override {
    return whole(static_cast<std::int64_t>(std::min<number_unsigned_t>(x, INT64_MAX)));
  }
  bool number_float(number_float_t x, const string_t&) override { return value(x, Validity::kValid); }
  bool string(string_t& word) override {
    const auto signal = known();
    const auto meant = signal ? value_of(signal->signal, word) : std::nullopt;
    return value(meant.value_or(std::nan("")), Validity::kValid);
  }
  bool binary(binary_t&) override { return fail("binary"); }
  bool key(string_t& name) override {
    key_ = name.size() <= kLongestName ? name : name.substr(0, kLongestName);
    return true;
  }
  bool start_object(std::size_t) override {
    if (++depth_ == 2) boom_ = key_ + ".";
    return depth_ <= 2 || fail("an object in a boom's object");
  }
  bool end_object() override {
    if (depth_-- == 2) boom_.clear();
    return true;
  }
  bool start_array(std::size_t) override { return fail("a list"); }
  bool end_array() override { return true; }
  bool parse_error(std::size_t at, const std::string&, const nlohmann::detail::exception&) override {
    return fail("no JSON at byte " + std::to_string(at));
  }

 private:
  bool fail(const std::string& what) {
    if (problem.empty()) problem = what;
    return false;
  }
  std::optional<SignalId> known() const {
    const auto found = names_.find(boom_ + key_);
    return found == names_.end() ? std::nullopt : std::optional<SignalId>(found->second);
  }
  bool whole(std::int64_t x) {
    if (depth_ == 1 && key_ == "seq") {
      content.sequence = x;
      return true;
    }
    return value(static_cast<double>(x), Validity::kValid);
  }
  bool value(double x, Validity validity) {
    if (depth_ == 0) return fail("no object");
    const auto signal = known();
    if (signal) {
      content.readings.push_back({*signal, x, validity, time_s_});
      return true;
    }
    if (content.unknown_count++ == 0) content.unknown = boom_ + key_;
    return true;
  }

  const std::map<std::string, SignalId, std::less<>>& names_;
  double time_s_;
  int depth_ = 0;
  std::string key_, boom_;
};

}  // namespace

DatagramReader::DatagramReader(const std::vector<NameRoute>& routes) {
  for (const NameRoute& route : routes) {
    names_[route.name] = route.target;
    if (!route.alias.empty()) names_[route.alias] = route.target;
  }
}

std::optional<DatagramContent> DatagramReader::read(std::string_view text, double time_s,
                                                    std::string& problem) const {
  Handler handler(names_, time_s);
  const bool good = nlohmann::json::sax_parse(text.begin(), text.end(), &handler);
  if (good && handler.problem.empty()) return std::move(handler.content);
  problem = handler.problem;
  return std::nullopt;
}

bool SequenceFilter::passes(std::int64_t sequence, double time_s) {
  constexpr std::int64_t kFarBehind = 1000;
  constexpr double kPause_s = 1;
  const bool late =
      last_ && sequence <= *last_ && *last_ - sequence < kFarBehind && time_s - last_s_ < kPause_s;
  if (late) return false;
  last_ = sequence;
  last_s_ = time_s;
  return true;
}

}  // namespace rigsound::udp
