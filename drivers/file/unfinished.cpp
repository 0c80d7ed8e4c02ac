#include "rigsound/file/unfinished.hpp"

#include <mutex>

namespace rigsound {
namespace {

// Signals are the whole program's, and so is this list. Never destroyed: a signal may come while it ends.
struct UnfinishedList {
  std::mutex mutex;
  std::list<Unfinished::Undo> undos;
};

UnfinishedList& unfinished_list() {
  static auto* const list = new UnfinishedList;
  return *list;
}

}  // namespace

Unfinished::Unfinished(const std::function<Undo()>& begin) {
  UnfinishedList& list = unfinished_list();
  const std::lock_guard<std::mutex> lock(list.mutex);
  undo_ = list.undos.insert(list.undos.end(), begin());
}

Unfinished::~Unfinished() {
  UnfinishedList& list = unfinished_list();
  const std::lock_guard<std::mutex> lock(list.mutex);
  list.undos.erase(undo_);
}

void undo_unfinished() {
  UnfinishedList& list = unfinished_list();
  list.mutex.lock();  // for good
  for (auto undo = list.undos.rbegin(); undo != list.undos.rend(); ++undo) (*undo)();
}

}  // namespace rigsound
