// Work that takes longer than a request.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "http.hpp"

namespace rigsound::studio {

/// Thrown out of work that somebody has stopped.
struct Stopped {};

/// What a job's work tells of itself. Thread: that of the work.
class JobControl {
 public:
  virtual ~JobControl() = default;

  /// `share` 0...1 of the work is done. Errors: Stopped, when somebody has stopped the job.
  virtual void progress(double share) = 0;
  virtual void done(const std::string& name) = 0;  ///< a part of the work
  /// `stop` is called, from another thread, when somebody stops the job; at once when that is so already.
  virtual void on_stop(std::function<void()> stop) = 0;
  virtual bool stopped() const = 0;
};

class Jobs {
 public:
  using Work = std::function<Json(JobControl& control)>;

  /// At most `at_once` run, further ones wait. Thread: OFF.
  explicit Jobs(int at_once) : free_(at_once) {}
  ~Jobs();  ///< stops all and waits for them

  /// Its id. Errors: ApiError 503 when too many wait.
  std::string start(const std::string& kind, Work work);

  Json status(const std::string& id) const;  ///< errors: ApiError 404
  Json all() const;                          ///< latest first
  void stop(const std::string& id);          ///< errors: ApiError 404

  /// Waits until the job says something new, `patience` at most. `seen`: what it had said, which is brought
  /// up to date. False once it has ended and all was told. Errors: ApiError 404.
  bool news(const std::string& id, std::optional<Json>& seen, std::chrono::milliseconds patience) const;

 private:
  struct Job;
  class Control;

  std::shared_ptr<Job> find(const std::string& id) const;
  void stop(Job& job);  ///< mutex_ is held
  void run(Job& job, const Work& work);
  void forget_old();

  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  std::list<std::shared_ptr<Job>> jobs_;  // latest first
  int free_, next_ = 1;
};

}  // namespace rigsound::studio
