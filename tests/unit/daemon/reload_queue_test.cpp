// Reloads, one at a time, and the rigs they read.
#include "reload_queue.hpp"

#include <doctest/doctest.h>
#include <poll.h>

#include <atomic>
#include <stdexcept>
#include <thread>

#include "rig_loader.hpp"

using namespace rigsound;
using namespace rigsound::daemon;

TEST_CASE("All who ask while a reload is under way share the next one, and learn of that one") {
  ReloadQueue queue;
  CHECK_FALSE(queue.due());
  const auto first = queue.ask();
  CHECK(queue.ask() == first);
  CHECK(queue.due());
  queue.begin();
  CHECK_FALSE(queue.due());
  CHECK(queue.result(first) == nullptr);
  const auto second = queue.ask();
  CHECK(second == first + 1);
  for (int i = 0; i < 100; ++i) CHECK(queue.ask() == second);
  CHECK_FALSE(queue.due());  // not two at a time
  queue.finish({"wrong", {}});
  REQUIRE(queue.result(first) != nullptr);
  CHECK(queue.result(first)->error == "wrong");
  CHECK(queue.result(second) == nullptr);
  CHECK(queue.due());
  queue.begin();
  queue.finish({"", {"audio.rate"}});
  CHECK_FALSE(queue.due());
  CHECK(queue.result(second)->not_applied.size() == 1);
}

namespace {

RigLoader::Outcome taken(RigLoader& loader) {
  pollfd poll = loader.to_poll();
  REQUIRE(::poll(&poll, 1, 60000) == 1);
  auto outcome = loader.take();
  REQUIRE(outcome);
  return std::move(*outcome);
}

}  // namespace

TEST_CASE("A rig is read while the caller goes on; an error is an outcome") {
  RigLoader loader;
  CHECK_FALSE(loader.busy());
  CHECK(loader.to_poll().fd == -1);
  std::atomic<bool> go{false};
  loader.begin([&](std::vector<std::string>& not_applied) {
    while (!go) std::this_thread::yield();
    not_applied = {"audio.block"};
    LoadedRig rig;
    rig.fingerprint = "f";
    return rig;
  });
  CHECK(loader.busy());
  CHECK_FALSE(loader.take());
  go = true;
  const RigLoader::Outcome good = taken(loader);
  CHECK(good.rig.fingerprint == "f");
  CHECK(good.not_applied.size() == 1);
  CHECK(good.error.empty());
  CHECK_FALSE(loader.busy());
  loader.begin([](std::vector<std::string>&) -> LoadedRig { throw std::runtime_error("no such rig"); });
  CHECK(taken(loader).error == "no such rig");
}

TEST_CASE("A loader that is destroyed waits for nobody") {
  const auto go = std::make_shared<std::atomic<bool>>(false);
  const auto over = std::make_shared<std::atomic<bool>>(false);
  {
    RigLoader loader;
    loader.begin([go, over](std::vector<std::string>&) {
      while (!*go) std::this_thread::yield();
      *over = true;
      return LoadedRig{};
    });
  }
  CHECK_FALSE(*over);
  *go = true;
  while (!*over) std::this_thread::yield();
}
