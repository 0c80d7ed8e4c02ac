#include "rig_loader.hpp"

#include <exception>
#include <thread>
#include <utility>

namespace rigsound::daemon {

void RigLoader::begin(Load load) {
  job_ = std::make_shared<Job>();
  job_->load = std::move(load);
  std::thread([job = job_] {
    try {
      job->outcome.rig = job->load(job->outcome.not_applied);
    } catch (const std::exception& error) {
      job->outcome.error = error.what();
    }
    job->done.set();
  }).detach();
}

std::optional<RigLoader::Outcome> RigLoader::take() {
  if (!job_ || !job_->done.is_set()) return std::nullopt;
  Outcome outcome = std::move(job_->outcome);
  job_.reset();
  return outcome;
}

}  // namespace rigsound::daemon
