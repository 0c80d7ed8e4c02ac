// What has to be undone when a signal ends the program in the midst of work: temporary files and folders.
#pragma once

#include <functional>
#include <list>

namespace rigsound {

/// Something begun that its destructor takes for finished. Thread: OFF, CT; any number at a time.
class Unfinished {
 public:
  using Undo = std::function<void()>;

  /// `begin` makes the thing and returns what removes it; that must not throw and may find it gone already.
  explicit Unfinished(const std::function<Undo()>& begin);
  ~Unfinished();
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;

 private:
  std::list<Undo>::iterator undo_;
};

/// Undoes all that is unfinished, the newest first. From then on nothing can be begun or finished any more:
/// who tries waits for ever, so the caller must end the program at once. Thread: any, once, but not from a
/// handler.
void undo_unfinished();

}  // namespace rigsound
