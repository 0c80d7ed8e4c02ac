#include "jobs.hpp"

#include <algorithm>

namespace rigsound::studio {
namespace {

constexpr std::size_t kMostWaiting = 32, kMostKnown = 64;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

struct Jobs::Job {
  std::string id, kind, state = "waiting", error;
  double share = 0;
  std::vector<std::string> done;
  Json result;
  Clock::time_point start;
  std::atomic<bool> stopped{false};
  std::function<void()> stop;
  std::thread thread;

  bool ended() const { return state == "done" || state == "failed" || state == "stopped"; }

  /// What is left at the speed so far.
  Json left() const {
    if (state != "running" || share <= 0.01) return nullptr;
    return seconds_since(start) * (1 - share) / share;
  }

  Json json() const {
    return {{"id", id},         {"kind", kind},
            {"state", state},   {"progress", share},
            {"left_s", left()}, {"done", done},
            {"result", result}, {"error", error.empty() ? Json() : Json(error)}};
  }
};

class Jobs::Control : public JobControl {
 public:
  Control(Jobs& jobs, Job& job) : jobs_(jobs), job_(job) {}

  void progress(double share) override {
    if (job_.stopped) throw Stopped();
    const std::lock_guard lock(jobs_.mutex_);
    job_.share = std::clamp(share, 0.0, 1.0);
    jobs_.changed_.notify_all();
  }

  void done(const std::string& name) override {
    const std::lock_guard lock(jobs_.mutex_);
    job_.done.push_back(name);
    jobs_.changed_.notify_all();
  }

  void on_stop(std::function<void()> stop) override {
    const std::lock_guard lock(jobs_.mutex_);
    job_.stop = std::move(stop);
    if (job_.stopped && job_.stop) job_.stop();
  }

  bool stopped() const override { return job_.stopped; }

 private:
  Jobs& jobs_;
  Job& job_;
};

Jobs::~Jobs() {
  std::vector<std::shared_ptr<Job>> jobs;
  {
    const std::lock_guard lock(mutex_);
    jobs.assign(jobs_.begin(), jobs_.end());
    for (const auto& job : jobs) stop(*job);
  }
  for (const auto& job : jobs)
    if (job->thread.joinable()) job->thread.join();
}

std::string Jobs::start(const std::string& kind, Work work) {
  const std::lock_guard lock(mutex_);
  const auto waiting =
      std::count_if(jobs_.begin(), jobs_.end(), [](const auto& job) { return job->state == "waiting"; });
  if (waiting >= static_cast<long>(kMostWaiting)) throw ApiError(503, "too many jobs are waiting already");
  forget_old();
  const auto job = std::make_shared<Job>();
  job->id = "j" + std::to_string(next_++);
  job->kind = kind;
  jobs_.push_front(job);
  job->thread = std::thread([this, job, work = std::move(work)] { run(*job, work); });
  return job->id;
}

void Jobs::forget_old() {
  while (jobs_.size() >= kMostKnown) {
    const auto oldest =
        std::find_if(jobs_.rbegin(), jobs_.rend(), [](const auto& job) { return job->ended(); });
    if (oldest == jobs_.rend()) return;
    const std::shared_ptr<Job> job = *oldest;
    jobs_.remove(job);
    job->thread.join();  // it has nothing left to do
  }
}

void Jobs::run(Job& job, const Work& work) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return free_ > 0 || job.stopped; });
  const auto end = [&](const char* state, const std::string& error) {
    job.state = state;
    job.error = error;
    job.stop = nullptr;
    changed_.notify_all();
  };
  if (job.stopped) return end("stopped", "");
  --free_;
  job.state = "running";
  job.start = Clock::now();
  changed_.notify_all();
  lock.unlock();
  Json result;
  std::string error;
  bool failed = false;
  try {
    Control control(*this, job);
    result = work(control);
  } catch (const Stopped&) {
    job.stopped = true;
  } catch (const std::exception& problem) {
    failed = true;
    error = problem.what();
  }
  lock.lock();
  ++free_;
  if (job.stopped) return end("stopped", "");
  if (failed) return end("failed", error);
  job.result = std::move(result);
  job.share = 1;
  end("done", "");
}

std::shared_ptr<Jobs::Job> Jobs::find(const std::string& id) const {
  const auto found = std::find_if(jobs_.begin(), jobs_.end(), [&](const auto& job) { return job->id == id; });
  if (found == jobs_.end()) throw ApiError(404, "there is no such job");
  return *found;
}

Json Jobs::status(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  return find(id)->json();
}

Json Jobs::all() const {
  const std::lock_guard lock(mutex_);
  Json list = Json::array();
  for (const auto& job : jobs_) list.push_back(job->json());
  return list;
}

void Jobs::stop(const std::string& id) {
  const std::lock_guard lock(mutex_);
  stop(*find(id));
}

void Jobs::stop(Job& job) {
  if (job.ended()) return;
  job.stopped = true;
  if (job.stop) job.stop();
  changed_.notify_all();
}

bool Jobs::news(const std::string& id, std::optional<Json>& seen, std::chrono::milliseconds patience) const {
  std::unique_lock lock(mutex_);
  const std::shared_ptr<Job> job = find(id);
  const auto same = [&] {
    if (!seen) return false;
    Json now = job->json(), before = *seen;
    now.erase("left_s"), before.erase("left_s");
    return now == before;
  };
  changed_.wait_for(lock, patience, [&] { return !same() || job->ended(); });
  if (same()) return !job->ended();
  seen = job->json();
  return true;
}

}  // namespace rigsound::studio
