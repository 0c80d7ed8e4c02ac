#include <chrono>

#include "analyze_job.hpp"
#include "routes.hpp"
#include "suggest_job.hpp"

namespace rigsound::studio {
namespace {

Answer start(Workplace& place, const Request& request) {
  const Json body = request.object();
  const std::string kind = body.at("kind").get<std::string>();
  Jobs::Work work;
  if (kind == "analyze")
    work = analyze_work(place, body);
  else if (kind == "suggest")
    work = suggest_work(place, body);
  else
    throw ApiError(400, "kind: is " + kind + ", expected analyze or suggest");
  return json_answer({{"id", place.jobs.start(kind, std::move(work))}}, 202);
}

Answer events(Workplace& place, const std::string& id) {
  static constexpr std::chrono::milliseconds kPatience(1000), kPause(100);  // at most ten lines a second
  place.jobs.status(id);                                                    // 404 before the stream begins
  Answer answer;
  answer.type = "application/x-ndjson";
  answer.stream = [&place, id, seen = std::optional<Json>()](std::string& piece) mutable {
    const std::optional<Json> before = seen;
    const bool more = place.jobs.news(id, seen, kPatience);
    if (seen != before) piece = seen->dump() + "\n";
    if (more) std::this_thread::sleep_for(kPause);
    return more;
  };
  return answer;
}

}  // namespace

void add_job_routes(Router& router, Workplace& place) {
  router.add("POST", "/jobs", [&place](const Request& request) { return start(place, request); });
  router.add("GET", "/jobs", [&place](const Request&) { return json_answer({{"jobs", place.jobs.all()}}); });
  router.add("GET", "/jobs/{}",
             [&place](const Request& request) { return json_answer(place.jobs.status(request.words[0])); });
  router.add("GET", "/jobs/{}/events",
             [&place](const Request& request) { return events(place, request.words[0]); });
  router.add("DELETE", "/jobs/{}", [&place](const Request& request) {
    place.jobs.stop(request.words[0]);
    return json_answer(place.jobs.status(request.words[0]));
  });
}

}  // namespace rigsound::studio
