// Banks beside their recordings: analysed again when first asked for, then kept in memory.
#pragma once

#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "recordings.hpp"
#include "rigsound/analysis/bank_comparison.hpp"
#include "rigsound/config/bank_files.hpp"

namespace rigsound::studio {

class Comparisons {
 public:
  explicit Comparisons(const Recordings& recordings) : recordings_(recordings) {}

  /// The recorded side of a bank; two that ask at once wait for one analysis. Errors: ApiError 404 when the
  /// recording is not in the folder, or is another one by now; InputError. Thread: any.
  std::shared_ptr<const analysis::RecordedSide> of(const config::StoredBank& bank);

 private:
  struct Entry {
    std::mutex mutex;
    std::shared_ptr<const analysis::RecordedSide> side;
  };
  std::shared_ptr<Entry> entry(const std::string& key);

  const Recordings& recordings_;
  std::mutex mutex_;
  std::list<std::pair<std::string, std::shared_ptr<Entry>>> entries_;  // latest first
};

}  // namespace rigsound::studio
