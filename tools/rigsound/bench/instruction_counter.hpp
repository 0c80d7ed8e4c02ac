// Instructions retired by this thread, where the kernel and the processor tell.
#pragma once

#include <cstdint>
#include <optional>

namespace rigsound::tools {

class InstructionCounter {
 public:
  InstructionCounter();
  ~InstructionCounter();
  InstructionCounter(const InstructionCounter&) = delete;
  InstructionCounter& operator=(const InstructionCounter&) = delete;

  /// Instructions in user space since construction; nothing where they cannot be counted. Thread: CT.
  std::optional<std::uint64_t> read() const;

 private:
  int fd_;
};

}  // namespace rigsound::tools
