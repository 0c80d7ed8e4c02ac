// Trials of a blind listening test: which sound is which, nobody outside knows before the trial has ended.
#pragma once

#include <list>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "http.hpp"

namespace rigsound::studio {

struct ListeningTrial {
  std::string id, test, bank;
  double seconds = 0;
  std::vector<std::pair<std::string, std::string>> sounds;  ///< place (`a`, `1`), and what is heard there
  std::map<std::string, std::string> waves;                 ///< of each kind; none once the trial has ended
  std::map<std::string, double> gains_db;                   ///< of each kind
};

/// Thread: any.
class ListeningTrials {
 public:
  /// Keeps it under a new id, which is returned. The sounds of the last eight are kept.
  std::string open(ListeningTrial trial);

  /// Errors: ApiError 404 when there is no such trial or place, or the trial has ended.
  std::string wave(const std::string& id, const std::string& place) const;

  /// Ends it and says what it was; the last 64 say so again. Errors: ApiError 404.
  ListeningTrial end(const std::string& id);

 private:
  mutable std::mutex mutex_;
  std::list<ListeningTrial> trials_;  // latest first
};

/// The sounds' places in a random order of `kinds`: A, B and X, which is one of them; or the reference, which
/// is the first of `kinds`, and all of them once more under numbers.
std::vector<std::pair<std::string, std::string>> abx_places(std::vector<std::string> kinds);
std::vector<std::pair<std::string, std::string>> rating_places(std::vector<std::string> kinds);

}  // namespace rigsound::studio
